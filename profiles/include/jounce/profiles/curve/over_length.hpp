// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Position of one axis along a path of several axes, and its derivatives with respect to the path
/// parameter q. Units: u, u/m, u/m^2 and u/m^3, where u is the unit of the axis and m the unit of
/// q. If u and m are the same unit of length, q is the arc length, except in a rounded corner,
/// where q advances slightly faster (see Path in the module path).
struct PathPoint {
  double position = 0;        ///< u
  double direction = 0;       ///< this axis' component of the tangent
  double curvature = 0;       ///< this axis' component of the curvature vector
  double curvature_rate = 0;  ///< derivative of the curvature
};

/// Tag of a curve over path length, beside OverTime and OverMaster (decision 0002). Because the
/// types differ, a program cannot play the shape of a path as a motion over time by mistake.
struct OverLength {
  using Point = PathPoint;
  static constexpr std::array<const char*, 4> names{"position", "direction", "curvature",
                                                    "curvature_rate"};
};

}  // namespace jounce
