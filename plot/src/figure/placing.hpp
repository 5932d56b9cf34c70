// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plot/src/figure/path.hpp"

namespace jounce {

struct Box {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
};

bool overlap(const Box& a, const Box& b);
bool crosses(const Box& box, Pixel from, Pixel to);

/// Parts that a label must not cover.
struct Surroundings {
  Box frame;                              ///< labels stay inside
  std::vector<Box> taken;                 ///< and off these,
  std::vector<std::vector<Pixel>> lines;  ///< and, if they can, off these
};

/// The first of the candidate boxes that crosses the fewest lines; nothing if every one leaves the
/// frame or covers what is taken.
std::optional<std::size_t> place(const Surroundings& around, std::span<const Box> candidates);

}  // namespace jounce
