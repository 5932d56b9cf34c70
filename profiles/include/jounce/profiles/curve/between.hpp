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
/// If the interval reaches beyond f, the policy of f fills the missing part: with `hold` the end
/// value at rest, with `wrap` and `advance` the periods before and after (at most 1e6 segments).
/// The result has the policy of f, except that a part of a periodic curve holds. Exact: only `from`
/// and `to` are new breaks. Throws InputError if from >= to, if the interval reaches beyond an f
/// that refuses positions outside, or if a periodic curve would need more segments.
template <class Over>
Curve<Over> between(const Curve<Over>& f, double from, double to);

/// Returns f delayed by `delay`, over [start, end + late]; 0 <= delay <= late, in the unit of the
/// curve's variable. Before and after its motion f is at rest. A filter adds several such curves.
/// For a periodic f the interval stays [start, end].
template <class Over>
Curve<Over> delayed(const Curve<Over>& f, double delay, double late);

/// Throws InputError unless f begins and ends at rest, to 1e-9 of its peak velocity. A filter
/// requires this of an f that is not periodic, because holding a moving end would stop it in zero
/// time.
template <class Over>
void require_resting_ends(const Curve<Over>& f);

}  // namespace jounce
