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
/// The *control* values are slave positions (u), the *knots* master positions (m). The conversion is
/// exact (to rounding): every segment is the polynomial the B-spline is between two knots.
struct BSplineSpec {
  int degree = 3;               ///< 1 ... 11
  std::vector<double> knots;    ///< m, ascending, control.size() + degree + 1 of them; may repeat
  std::vector<double> control;  ///< u
};

/// One segment for each pair of different knots within [knots[degree], knots[control.size()]], where
/// the curve begins and ends. A knot that stands k times leaves degree - k derivatives continuous.
/// Throws InputError for a degree out of range, too few control values, a wrong number of knots,
/// values that are not finite, knots that descend, and a knot within that stands more than `degree`
/// times: the curve would break. Source: C. de Boor, A Practical Guide to Splines, ch. IX, X.
std::vector<Segment> b_spline(const BSplineSpec& spec);

/// The spline of the given degree, 1 ... 7, through the points, with degree - 1 continuous
/// derivatives and knots chosen such that it always exists (Schoenberg, Whitney 1953): of odd degree
/// at the points, without the first and the last (degree - 1) / 2 inner ones (for 3 and 5:
/// SplineEnds::not_a_knot); of even degree halfway between the points. Error order h^(degree + 1).
/// Degrees above 5 swing between points whose spacing is uneven. Throws InputError as quintic_spline
/// does, for a degree out of range, and for fewer than degree + 1 points.
BSplineSpec interpolating_b_spline(const std::vector<SplinePoint>& points, int degree);

/// The Bezier curve of the control values, evenly spaced in master over the length: degree + 1 of
/// them, degree 0 ... 11. It starts at the first and ends at the last, with slopes
/// degree (control[1] - control[0]) / length and so on. Throws InputError for a length that is not
/// positive, no or more than 12 values, values that are not finite.
Segment bezier(double length, std::span<const double> control);

/// Bezier curves of one degree between the breaks, each sharing its end value with the next one's
/// start: (breaks - 1) * degree + 1 control values. Continuous in value; what more, the control
/// values decide (see `check_continuity`). Throws InputError as bezier() does, for a degree out of
/// 1 ... 11, breaks that do not ascend, and a wrong number of control values.
std::vector<Segment> bezier_chain(std::span<const double> breaks, std::span<const double> control,
                                  int degree);

}  // namespace jounce
