// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Returns the moving average of a curve over a window T (in the unit of the curve's variable),
/// exactly:
///
///     (1)  g(x) = 1/T * integral of f from x - T to x
///
///     const Trajectory hard = trapezoid({.to = 9, .velocity = 100, .acceleration = 500}).curve();
///     const Trajectory smooth = moving_average(hard, 0.05);      // jerk 500 / 0.05
///     const Trajectory smoother = moving_average(smooth, 0.05);  // continuous jerk
///
/// Controllers call T the smoothing time (HIMC HMPL manual 5.1). A trapezoid with acceleration a
/// becomes an S-curve with the jerk a / T, and each of its ramps takes T longer. The degree of a
/// polynomial grows by at most one; a sine keeps its frequency. Every derivative with steps becomes
/// continuous. No peak of velocity, acceleration or jerk grows (a step of the acceleration counts
/// as infinite jerk).
///
/// **Interval.** Before and after its interval, f stands still; it must begin and end at rest. The
/// result covers [start, end + T] and holds outside. If f is periodic, the average continues across
/// its ends; the result then has the interval and the policy of f.
///
/// **Accuracy.** The value is accurate to rounding (about 1e-14 of the stroke), because each piece
/// is integrated separately. The rounding error of the acceleration grows with 1 / T^2, to about
/// 1e-6 of the acceleration's peak at the shortest window.
///
/// Throws InputError unless the window is 1e-5 to 10000 times the curve's length; if the curve
/// begins or ends in motion (append the stop first); if a degree would exceed 11; or if a piece
/// would need more than three sines.
template <class Over>
Curve<Over> moving_average(const Curve<Over>& f, double window);

}  // namespace jounce
