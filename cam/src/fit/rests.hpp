// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/cam/fit/fit.hpp"

namespace jounce::cam_detail {

/// Consecutive points, from `first` to `last`.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Returns the stretches in which the slave may rest: one position is within the tolerances of all
/// their points. They are long, or the slave reverses there. In the order of the master.
std::vector<Stretch> rests(const MeasuredCam& measured);

/// Returns a position that is within the tolerances of all points of a rest, or near them.
double level(const MeasuredCam& measured, const Stretch& rest);

/// Returns the longest stretch of the points from `within.first` to `within.last` through which a
/// straight line passes within the tolerances. nullopt if it is shorter than `least`, a share of
/// the whole range.
std::optional<Stretch> longest_line(const MeasuredCam& measured, const Stretch& within,
                                    double least);

}  // namespace jounce::cam_detail
