// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/laws/spline.hpp"

namespace jounce {

/// Points with a tolerance: the curve with the least integral of geo_jerk^2 among all that pass
/// every point within its tolerance.
///
///     SplineSpec measured{.points = {{0, 0}, {60, 11.7, 0.5}, {120, 30.2, 0.5}, {180, 40}}};
///     measured.start = measured.end = {.geo_velocity = 0, .geo_acceleration = 0};
///     SmoothingSpline s = smoothing_spline(measured);
///     Cam cam(s.segments, 0, Extrapolation::hold);
///     double bound = s.square_jerk - s.gap;             // no curve within the tolerances has less
///
/// It is a quintic spline. Its joints are the points where the tolerance is used up and the points
/// with zero tolerance, which it passes exactly; it has no joint at other points. If all tolerances
/// are zero, it is quintic_spline().
struct SmoothingSpline {
  std::vector<Segment> segments;     ///< from the first point's master to the last one's
  std::vector<std::size_t> touched;  ///< points where the tolerance is used up or zero, from 0
  double square_jerk = 0;            ///< integral of geo_jerk^2, u^2/m^5
  double gap = 0;     ///< certificate: no curve within the tolerances is below square_jerk - gap
  int solutions = 0;  ///< linear systems solved
};

/// A strictly convex quadratic program, solved by an active set. Each tolerance is kept to within
/// 1e-9 of its value plus the rounding of the slave positions. If a parabola keeps all tolerances
/// (periodic: a constant), square_jerk is zero and the curve is such a parabola: the one through
/// the first, the middle and the last point, or the nearest one that the tolerances permit.
///
/// Throws InputError like quintic_spline(); for fewer than three points; for a tolerance that is
/// negative or not finite; for SplineEnds::not_a_knot; and for periodic ends with different
/// tolerances at the first and the last point, which are the same point.
SmoothingSpline smoothing_spline(const SplineSpec& spec);

}  // namespace jounce
