// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/cam/laws/spline.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// B-splines and Bezier curves as segments for a Cam.
///
///     std::vector<Segment> s = b_spline({.degree = 5, .knots = knots, .control = control});
///     std::vector<Segment> through = b_spline(interpolating_b_spline(points, 7));
///     Segment rise = bezier(120, std::vector<double>{0, 0, 0, 40, 40, 40});   // 3-4-5
///     std::vector<Segment> chain = bezier_chain(std::vector<double>{0, 60, 120}, control, 3);
///
/// The *control* values are slave positions (slave unit u), the *knots* master positions (master
/// unit m). The conversion is exact to rounding: every segment is the polynomial of the B-spline
/// between two knots.
struct BSplineSpec {
  int degree = 3;                  ///< 1 to 11
  std::vector<double> knots = {};  ///< m, ascending, may repeat; control.size() + degree + 1 values
  std::vector<double> control = {};  ///< u, control values
};

/// Returns one segment for each pair of different successive knots within [knots[degree],
/// knots[control.size()]], the interval of the curve. At a knot of multiplicity k, the derivatives
/// up to the order degree - k are continuous. Throws InputError for a degree out of range, too few
/// control values, a wrong number of knots, values that are not finite, knots that descend, and an
/// inner knot of multiplicity above `degree`, where the curve would break. Source: C. de Boor, A
/// Practical Guide to Splines, ch. IX, X.
std::vector<Segment> b_spline(const BSplineSpec& spec);

/// Returns the spline of the given degree (1 to 7) through the points, with degree - 1 continuous
/// derivatives. The function chooses the knots so that the spline always exists (Schoenberg,
/// Whitney 1953). For an odd degree, the knots are the points, without the first and the last
/// (degree - 1) / 2 inner ones (for 3 and 5: SplineEnds::not_a_knot). For an even degree, the knots
/// are halfway between the points. For points at distance h, the error is of order h^(degree + 1).
/// Degrees above 5 oscillate between unevenly spaced points. Throws InputError like
/// quintic_spline(), for a degree out of range, and for fewer than degree + 1 points.
BSplineSpec interpolating_b_spline(const std::vector<SplinePoint>& points, int degree);

/// Returns a Bezier curve over `length` (m) with degree + 1 control values (u); degree 0 to 11. It
/// begins at the first value and ends at the last. Its initial slope is degree * (control[1] -
/// control[0]) / length; the final slope follows likewise from the last two values. Throws
/// InputError for a length that is not positive, no or more than 12 values, and values that are not
/// finite.
Segment bezier(double length, std::span<const double> control);

/// Returns Bezier curves of one degree between successive breaks (m). Neighboring curves share a
/// control value, so the number of control values is (breaks - 1) * degree + 1. The value is
/// continuous; the continuity of derivatives depends on the control values (see check_continuity()
/// in limits/limits.hpp). Throws InputError like bezier(), for a degree outside 1 to 11, for breaks
/// that do not ascend, and for a wrong number of control values.
std::vector<Segment> bezier_chain(std::span<const double> breaks, std::span<const double> control,
                                  int degree);

}  // namespace jounce
