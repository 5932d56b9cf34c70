// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plot/src/figure/path.hpp"

namespace jounce {

/// A rectangle, px, y downwards.
struct Rectangle {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
};

bool overlap(const Rectangle& a, const Rectangle& b);
bool crosses(const Rectangle& box, Pixel from, Pixel to);

/// Parts that a label must not cover.
struct Surroundings {
  Rectangle frame;                        ///< labels stay inside
  std::vector<Rectangle> taken;           ///< areas that labels must not cover
  std::vector<std::vector<Pixel>> lines;  ///< lines that labels should not cover
};

/// Returns the index of the candidate box that crosses the fewest lines, the first of them; nullopt
/// if every candidate leaves the frame or covers a taken area.
std::optional<std::size_t> place(const Surroundings& around, std::span<const Rectangle> candidates);

}  // namespace jounce
