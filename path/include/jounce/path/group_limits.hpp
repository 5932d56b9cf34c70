// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Limits along the path: magnitudes > 0.
struct PathLimits {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double velocity = none;             ///< u/s
  double acceleration = none;         ///< tangential, u/s^2
  double deceleration = none;         ///< tangential, u/s^2
  double jerk = none;                 ///< tangential, u/s^3
  double normal_acceleration = none;  ///< v^2 times curvature, u/s^2
  double total_acceleration = none;   ///< magnitude, tangential and normal together, u/s^2
};

/// Limits of a group. Axis limits bound the motion of each axis, on any path: exactly, by the extrema of
/// the planned curves. `axes` has one entry an axis; its position limits are checked at the end points,
/// and by check() on the planned axes.
struct GroupLimits {
  std::vector<Limits> axes;
  PathLimits path = {};
};

/// PMC600's limits (manual 7.2.4): L = override * min(ancillary, factor * global) for an axis. An omitted
/// value is not limited. `override` and `factor` > 0.
struct LimitFactors {
  double override = 1;
  double factor = 1;
  Limits ancillary = {};
};
Limits effective(const Limits& global, const LimitFactors& factors);

/// The same along a path: L = override * min(ancillary, command).
PathLimits effective(const PathLimits& command, const PathLimits& ancillary, double override);

}  // namespace jounce
