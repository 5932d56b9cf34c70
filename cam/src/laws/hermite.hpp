// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// A point of a cam table with derivatives with respect to the master, as in a controller's table
/// of format XYVA. u is the slave's unit, m the master's.
struct HermitePoint {
  double master = 0;                    ///< m, master position
  double slave = 0;                     ///< u, slave position
  double geo_velocity = 0;              ///< u/m
  double geo_acceleration = 0;          ///< u/m^2
  std::optional<double> geo_jerk = {};  ///< u/m^3; given at all points or at none
};

/// Returns the polynomials between successive points: of degree 5, or of degree 7 if the points
/// have a jerk. Any spline of degree 5 with continuous geo_acceleration, or of degree 7 with
/// continuous geo_jerk, consists of such pieces. So the function reproduces the spline exactly from
/// its values at its breaks.
///
///     auto pieces = hermite(std::vector<HermitePoint>{{0, 0}, {60, 25, 0.8}, {120, 50}});
///     Cam cam(pieces, 0, Extrapolation::hold);
///
/// Positions are rounded to double precision. Over a piece of length h, this rounding causes an
/// error of geo_jerk of about |slave| 1e-14 / h^3. Throws InputError (key "points[2].slave", ...)
/// for fewer than two points, a number that is not finite, masters that do not ascend, and a jerk
/// at some points only. Source: J. Stoer, R. Bulirsch, Introduction to Numerical Analysis, 2.1.5.
std::vector<Segment> hermite(std::span<const HermitePoint> points);

}  // namespace jounce
