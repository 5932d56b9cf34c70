#pragma once

#include "jounce/profiles/curve.hpp"

namespace jounce {

/// The moving average of a curve over the window T, exactly:
///
///     (1)  g(x) = 1/T * integral of f from x - T to x
///
///     const Trajectory hard = trapezoid({.to = 9, .velocity = 100, .acceleration = 500}).curve();
///     const Trajectory smooth = moving_average(hard, 0.05);      // jerk 500 / 0.05
///     const Trajectory smoother = moving_average(smooth, 0.05);  // one order smoother again
///
/// What controllers call smoothing time (HIMC HMPL manual 5.1): a trapezoid becomes the S-curve of
/// jerk a / T, each of its ramps longer by T. A polynomial gains one degree at most, a sine stays a
/// sine of its frequency, every derivative becomes continuous that was a step, and no peak of
/// velocity, acceleration or jerk grows.
///
/// **Interval.** Before and after f the axis is taken to stand at f's end values (also where f
/// refuses): the result runs over [start, end + T] and holds. A curve that wraps is averaged
/// through its seam, over its own interval, and wraps.
///
/// Accurate to rounding (about 1e-14 of the stroke), however long the curve and short the window:
/// each piece is integrated on its own. Throws InputError for a window that is not positive and
/// finite, and where a degree would pass 11 or a piece need more than three sines.
template <class Over>
Curve<Over> moving_average(const Curve<Over>& f, double window);

}  // namespace jounce
