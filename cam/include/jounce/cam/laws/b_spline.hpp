// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/cam/laws/spline.hpp"

namespace jounce {

/// B-splines and Bezier curves as segments for a Cam.
///
///     std::vector<Segment> s = b_spline({.degree = 5, .knots = knots, .control = control});
///     std::vector<Segment> through = b_spline(interpolating_b_spline(points, 7));
///     Segment rise = bezier(120, std::vector<double>{0, 0, 0, 40, 40, 40});   // 3-4-5
///     std::vector<Segment> chain = bezier_chain(std::vector<double>{0, 60, 120}, control, 3);
///
/// The *control* values are slave positions (u: slave unit), the *knots* master positions (m: master
/// unit). The conversion is exact (to rounding): every segment is the polynomial of the B-spline
/// between two knots.
struct BSplineSpec {
  int degree = 3;               ///< 1 ... 11
  std::vector<double> knots;    ///< m, ascending, control.size() + degree + 1 of them; may repeat
  std::vector<double> control;  ///< u
};

/// One segment for each pair of different knots within [knots[degree], knots[control.size()]],
/// where the curve begins and ends. A knot of multiplicity k leaves degree - k derivatives
/// continuous. Throws InputError for a degree out of range, too few control values, a wrong number
/// of knots, values that are not finite, knots that descend, and an inner knot of multiplicity
/// above `degree`: the curve would break. Source: C. de Boor, A Practical Guide to Splines, ch. IX,
/// X.
std::vector<Segment> b_spline(const BSplineSpec& spec);

/// The spline of the given degree, 1 ... 7, through the points, with degree - 1 continuous
/// derivatives and knots chosen such that it always exists (Schoenberg, Whitney 1953). For an odd
/// degree the knots are the points, without the first and the last (degree - 1) / 2 inner ones (for
/// 3 and 5: SplineEnds::not_a_knot); for an even degree they are halfway between the points. Error
/// order h^(degree + 1). Degrees above 5 oscillate between unevenly spaced points. Throws
/// InputError like quintic_spline, for a degree out of range, and for fewer than degree + 1 points.
BSplineSpec interpolating_b_spline(const std::vector<SplinePoint>& points, int degree);

/// The Bezier curve of degree + 1 control values, evenly spaced in master over the length; degree 0
/// ... 11. It starts at the first and ends at the last. Its initial slope is degree * (control[1] -
/// control[0]) / length, and the final one likewise. Throws InputError for a length that is not
/// positive, no or more than 12 values, values that are not finite.
Segment bezier(double length, std::span<const double> control);

/// Bezier curves of one degree between the breaks; each shares its end value with the start of the
/// next: (breaks - 1) * degree + 1 control values. Continuous in value; the control values
/// determine the continuity of derivatives (see `check_continuity`). Throws InputError like
/// bezier(), for a degree outside 1 ... 11, breaks that do not ascend, and a wrong number of
/// control values.
std::vector<Segment> bezier_chain(std::span<const double> breaks, std::span<const double> control,
                                  int degree);

}  // namespace jounce
