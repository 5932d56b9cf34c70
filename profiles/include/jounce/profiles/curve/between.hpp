// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// The stretch [from, to] of a curve as a curve of its own, at the same place of the axis.
///
///     const Trajectory move = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100})
///                                 .curve();                      // 0 to 5.7 s
///     const Trajectory first_second = between(move, 0, 1);       // a part of it
///     const Trajectory delayed = between(move, -0.5, move.end());  // at rest for half a second
///
/// f's policy gives the parts outside f: its end values at rest (hold), or the turns before and
/// after (wrap; at most 1e6 segments of them). The result has f's policy; a part of a wrapping
/// curve holds. Exact: only the two ends become new breaks. Throws InputError unless from < to, if
/// f refuses a part outside, and if a wrapping curve would need more segments.
template <class Over>
Curve<Over> between(const Curve<Over>& f, double from, double to);

/// f over [start, end + late], delayed by `delay`, 0 <= delay <= late: a term in the sum of a
/// filter. Before and after it f is at rest, unless it wraps; then the interval stays [start, end].
template <class Over>
Curve<Over> delayed(const Curve<Over>& f, double delay, double late);

/// Requirement of a filter if f does not wrap: throws InputError unless f begins and ends at rest,
/// to 1e-9 of its peak velocity. A hold after a moving end would be a stop in zero time.
template <class Over>
void require_resting_ends(const Curve<Over>& f);

}  // namespace jounce
