// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Coordinate of one axis along a path, with its derivatives by the path parameter q: u, u/m, u/m^2,
/// u/m^3, u the unit of the axis and m that of q. In the unit of length q is the arc length, except in
/// a corner, where it runs slightly faster (see Path).
struct PathPoint {
  double position = 0;
  double direction = 0;       ///< component of the tangent
  double curvature = 0;       ///< component of the curvature vector
  double curvature_rate = 0;  ///< its derivative
};

/// Tag of a curve over path length, in addition to OverTime and OverMaster (decision 0002): a
/// compile-time tag, so that a shape cannot be played as a motion.
struct OverLength {
  using Point = PathPoint;
  static constexpr std::array<const char*, 4> names{"position", "direction", "curvature",
                                                    "curvature_rate"};
};

}  // namespace jounce
