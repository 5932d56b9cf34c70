// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Limits along the path: magnitudes > 0; default: no limit. u is the unit of length of the path.
struct PathLimits {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double velocity = none;             ///< u/s
  double acceleration = none;         ///< u/s^2, tangential
  double deceleration = none;         ///< u/s^2, tangential
  double jerk = none;                 ///< u/s^3, tangential
  double normal_acceleration = none;  ///< u/s^2: velocity^2 times curvature
  /// u/s^2: magnitude of the tangential and the normal acceleration together.
  double total_acceleration = none;

  bool operator==(const PathLimits&) const = default;
};

/// Limits of a group of axes. The axis limits apply to the motion of each axis on any path; plan()
/// uses the exact extrema of the planned curves. Exception: plan() checks position limits only at
/// the end points of commands. To check positions between them, call check() on the planned axes.
struct GroupLimits {
  std::vector<Limits> axes = {};  ///< one for each axis
  PathLimits path = {};           ///< limits along the path
};

/// Factors and ancillary limits of the PMC600 (manual 7.2.4): a second set of limits, which a
/// program can lower. The effective limit of an axis is L = override * min(ancillary, factor *
/// global), with the limit of the configured axis as `global`. An omitted limit does not apply.
struct LimitFactors {
  double override = 1;    ///< > 0
  double factor = 1;      ///< > 0
  Limits ancillary = {};  ///< ancillary limits of the axis
};
/// Returns the effective limits of an axis.
Limits effective(const Limits& global, const LimitFactors& factors);

/// Returns the effective limits along a path: L = override * min(ancillary, command), with the
/// limits that the command gives.
PathLimits effective(const PathLimits& command, const PathLimits& ancillary, double override);

}  // namespace jounce
