// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/path/plan.hpp"

#include "path/src/geometry/route.hpp"
#include "path/src/timing/stations.hpp"

namespace jounce {

/// Directions (one number an axis) and boxes of the lines of a route; nothing of its other pieces.
struct Lines {
  std::vector<double> directions;
  std::vector<Box> boxes;
};
Lines lines_of(const Route& route, const Program& program, const Rates& rates);

/// A route with its corners rounded, and what the law may do on it.
struct Rounded {
  std::optional<Path> path;  ///< nothing: the route's own, since no corner is rounded
  std::vector<Unit> units;
  std::vector<JointMark> joints;
};

/// `stop`: joints at which the plan rests although their corners could be rounded.
Rounded rounded(const Route& route, const Lines& lines, const Program& program, const Rates& rates,
                const std::vector<bool>& stop);

}  // namespace jounce
