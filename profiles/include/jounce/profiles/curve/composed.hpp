// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/fitted.hpp"

namespace jounce {

/// Returns outer(inner(x)), exactly, as a curve over the variable of the inner curve.
///
///     Trajectory move = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100})
///                           .curve();
///     Trajectory clock({line(move.end() / 0.5, 0, move.end())});  // path time over time: 50 %
///     Trajectory slow = composed(move, clock);
///     Trajectory slave = composed(cam, master);               // cam: a Cam, master: a Trajectory
///
/// **Vocabulary.** The *inner* curve is a clock (path time over time) or a master. The *outer*
/// curve is a motion over path time, or a cam. The value of the inner curve is the variable of the
/// outer curve.
///
/// **Breaks** of the result are the breaks of the inner curve, and every place where the inner
/// curve passes a break of the outer curve (an exact root, as in roots.hpp).
///
/// **Outside** its interval, the result has the policy of the inner curve. Where the inner curve
/// leaves the interval of the outer curve, the policy of the outer curve applies: `hold` gives a
/// rest, `wrap` the next period.
///
/// **Exact if it fits a Segment.** On each piece,
/// - the product of the two degrees is at most 11;
/// - if the outer curve has sines, the inner curve is linear;
/// - if the inner curve has sines, the outer curve is linear.
///
/// So an S-curve (degree 3) can run on a jerk-limited clock (3), and a quintic cam can follow a
/// trapezoidal master (2). A quintic cannot run on a cubic clock; see composed_within().
///
/// Throws InputError("composed", ...) with the place if a piece does not fit. Throws
/// InputError("inner", ...) in two cases:
/// - The inner curve leaves, by more than rounding, the interval of an outer curve with the policy
///   `refuse`.
/// - One inner segment passes more than 1e6 segments of a periodic outer curve.
///
/// The result ends exactly where the inner curve ends, with one exception: if the inner curve runs
/// from a large negative start to about 0, the sum of its segment lengths has fewer digits than its
/// end.
template <class Outer, class Inner>
Curve<Inner> composed(const Curve<Outer>& outer, const Curve<Inner>& inner);

/// Returns outer(inner(x)) for any degrees and sines. Every piece that fits a Segment is exact. Any
/// other piece is a fit within `tolerance` (in the unit of the value) with a certified error; see
/// fitted.hpp. Throws InputError("tolerance", ...) in two cases: the tolerance is not positive and
/// above rounding (1e-14 of the magnitude of the outer curve), or more than 1e6 pieces would be
/// necessary. Throws InputError("inner", ...) like composed().
template <class Outer, class Inner>
Fitted<Inner> composed_within(const Curve<Outer>& outer, const Curve<Inner>& inner,
                              double tolerance);

}  // namespace jounce
