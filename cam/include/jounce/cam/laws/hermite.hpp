// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// A point of a piecewise polynomial, with its derivatives by master position: an entry of a
/// controller's cam table of format XYVA. m: master unit; u: slave unit.
struct HermitePoint {
  double master = 0;
  double slave = 0;                     ///< u
  double geo_velocity = 0;              ///< u/m
  double geo_acceleration = 0;          ///< u/m^2
  std::optional<double> geo_jerk = {};  ///< u/m^3; of all points or of none
};

/// The polynomials between neighboring points: of degree 5, or 7 if the points have a jerk. Any
/// spline of degree 5 (7) with continuous geo_acceleration (geo_jerk) consists of these pieces: its
/// values at its breaks define it, without approximation.
///
///     auto pieces = hermite(std::vector<HermitePoint>{{0, 0}, {60, 25, 0.8}, {120, 50}});
///     Cam cam(pieces, 0, Extrapolation::hold);
///
/// Positions are rounded to double precision, and over a piece of length h that rounding causes an
/// error of about |slave| 1e-14 / h^3 of geo_jerk. Throws InputError (key "points[2].slave", ...)
/// for fewer than two points, a number that is not finite, masters that do not ascend, and a jerk
/// at some points only. Source: any text on interpolation, e.g. J. Stoer, R. Bulirsch, Introduction
/// to Numerical Analysis, 2.1.5.
std::vector<Segment> hermite(std::span<const HermitePoint> points);

}  // namespace jounce
