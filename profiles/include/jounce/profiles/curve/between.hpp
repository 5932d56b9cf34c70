// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Returns the part of a curve over the interval [from, to]. The part keeps its times or master
/// positions.
///
///     const Trajectory move = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100})
///                                 .curve();                      // 0 to 5.7 s
///     const Trajectory first_second = between(move, 0, 1);       // a part of it
///     const Trajectory delayed = between(move, -0.5, move.end());  // at rest for half a second
///
/// The policy of f (key `outside`) fills the part of the interval that f does not cover: `hold`
/// with the end value at rest, `wrap` and `advance` with the periods before and after (at most 1e6
/// segments). The result has the policy of f. Exception: a part of a periodic curve has the policy
/// `hold`. The result is exact: the only new breaks are `from` and `to`.
///
/// Throws InputError if from >= to, if f has the policy `refuse` and does not cover [from, to], or
/// if a periodic f would need more than 1e6 segments.
template <class Over>
Curve<Over> between(const Curve<Over>& f, double from, double to);

/// Returns f delayed by `delay`. The interval of the result is [start, end + late], or [start, end]
/// if f is periodic. Requires 0 <= delay <= late, in the unit of the curve's variable. Before and
/// after its motion, f is at rest. Filters such as shaped() (vibration/shaper.hpp) add several
/// delayed curves; `late` is then the longest delay, so that all have the same interval.
template <class Over>
Curve<Over> delayed(const Curve<Over>& f, double delay, double late);

/// Throws InputError if f is not periodic and begins or ends in motion, that is, faster than 1e-9
/// of its peak velocity. Filters call this function because they hold f at its end values outside
/// its interval: a curve that ends in motion would stop there in zero time.
template <class Over>
void require_resting_ends(const Curve<Over>& f);

}  // namespace jounce
