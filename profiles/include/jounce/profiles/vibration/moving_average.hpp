// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// The moving average of a curve over the window T, exactly:
///
///     (1)  g(x) = 1/T * integral of f from x - T to x
///
///     const Trajectory hard = trapezoid({.to = 9, .velocity = 100, .acceleration = 500}).curve();
///     const Trajectory smooth = moving_average(hard, 0.05);      // jerk 500 / 0.05
///     const Trajectory smoother = moving_average(smooth, 0.05);  // one order smoother again
///
/// Controllers call this smoothing time (HIMC HMPL manual 5.1): a trapezoid becomes the S-curve of
/// jerk a / T, each of its ramps longer by T. A polynomial gains one degree at most, a sine stays a
/// sine of its frequency, every derivative that was a step becomes continuous, and no peak of
/// velocity, acceleration or jerk grows (a step of the acceleration counts as infinite jerk: that
/// of a trapezoid becomes a / T).
///
/// **Interval.** f must begin and end at rest; before and after it the axis stands at f's end
/// values (even if f refuses): the result runs over [start, end + T] and holds. A curve that wraps
/// is averaged through its seam, over its own interval, and wraps.
///
/// The value is accurate to rounding (about 1e-14 of the stroke): each piece is integrated on its
/// own. The rounding error of the acceleration grows with 1 / T^2, to about 1e-6 of its peak at the
/// shortest window. Throws InputError unless the window is 1e-5 to 10000 times the curve's length,
/// for a curve that begins or ends moving (append the stop first), and if a degree would exceed 11
/// or a piece would need more than three sines.
template <class Over>
Curve<Over> moving_average(const Curve<Over>& f, double window);

}  // namespace jounce
