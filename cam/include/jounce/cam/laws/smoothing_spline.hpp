// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/laws/spline.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// The smoothest curve through points with tolerances: of all curves that pass every point within
/// its tolerance, the one with the least integral of geo_jerk^2.
///
///     SplineSpec measured{.points = {{0, 0}, {60, 11.7, 0.5}, {120, 30.2, 0.5}, {180, 40}}};
///     measured.start = measured.end = {.geo_velocity = 0, .geo_acceleration = 0};
///     SmoothingSpline s = smoothing_spline(measured);
///     Cam cam(s.segments, 0, Extrapolation::hold);
///     double bound = s.square_jerk - s.gap;             // no permitted curve has less
///
/// The curve is a quintic spline. Its breaks are the points with zero tolerance, which the curve
/// passes exactly, and the points where the curve uses the whole tolerance. Other points are not
/// breaks. If all tolerances are zero, the curve is quintic_spline().
struct SmoothingSpline {
  /// from the master of the first point to the master of the last
  std::vector<Segment> segments = {};
  std::vector<std::size_t> touched = {};  ///< indices of the points that are breaks
  double square_jerk = 0;                 ///< integral of geo_jerk^2, u^2/m^5 (units: spline.hpp)
  double gap = 0;     ///< proven: no curve within the tolerances has less than square_jerk - gap
  int solutions = 0;  ///< number of linear systems that were solved
};

/// Computes the curve by an active-set method for a strictly convex quadratic program. The result
/// exceeds no tolerance by more than 1e-9 of it, plus the rounding of the slave positions. If a
/// parabola (periodic: a constant) is within all tolerances, square_jerk is zero and the curve is
/// such a parabola: the parabola through the first, the middle and the last point, or the nearest
/// parabola that the tolerances permit.
///
/// Throws InputError like quintic_spline(); for fewer than three points; for a tolerance that is
/// negative or not finite; for SplineEnds::not_a_knot; and for periodic ends with different
/// tolerances at the first and the last point, which are the same point.
SmoothingSpline smoothing_spline(const SplineSpec& spec);

}  // namespace jounce
