// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/fitted.hpp"

namespace jounce {

/// outer(inner(x)), exactly: a curve over the inner's axis.
///
///     Trajectory move = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100})
///                           .curve();
///     Trajectory clock({line(move.end() / 0.5, 0, move.end())});  // path time over time: 50 %
///     Trajectory slow = composed(move, clock);
///     Trajectory slave = composed(cam, master);               // cam: a Cam, master: a Trajectory
///
/// **Vocabulary.** The *inner* curve gives the position on the axis of the outer: a clock (path time over
/// time) or a master; the *outer* is played along it: a motion over path time, or a cam.
///
/// **Breaks** are those of the inner and every place where the inner passes a break of the outer
/// (isolated as in roots.hpp). **Outside**: the result has the inner's policy. If the inner leaves
/// the outer's interval, the outer's policy applies: hold gives a rest, wrap the next turn.
///
/// **Exact if it fits a Segment**: on each piece the product of the two degrees is at most 11, the
/// outer's sines meet an inner that is linear there, and the inner's sines an outer that is linear
/// there. So an S-curve (degree 3) may be played along a jerk-limited clock (3), a quintic cam
/// behind a trapezoidal master (2), but not a quintic along a cubic.
///
/// Throws InputError("composed", ...) with the place if it does not fit, and "inner" if the inner
/// leaves (by more than rounding) an outer that refuses, or if one segment of it travels over more
/// than 1e6 segments of an outer that wraps.
///
/// The result ends with the inner, to the last digit (except for an inner that runs from far below
/// 0 to about 0: then the lengths have fewer digits than the end).
template <class Outer, class Inner>
Curve<Inner> composed(const Curve<Outer>& outer, const Curve<Inner>& inner);

/// The same for any degrees and sines: exact on every piece that fits, otherwise a fit within
/// `tolerance` (unit of the value) with a certified error, see fitted.hpp. Throws InputError
/// "tolerance" unless it is positive and above rounding (1e-14 of the outer's magnitude), and
/// "inner" like `composed`.
template <class Outer, class Inner>
Fitted<Inner> composed_within(const Curve<Outer>& outer, const Curve<Inner>& inner,
                              double tolerance);

}  // namespace jounce
