// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/fitted.hpp"

namespace jounce {

/// Exact operations that make new cams from given cams.
///
///     Cam lane2 = phased(cam, 180);                               // half a turn later
///     Cam both = superimposed(cam, correction);                 // periods 360 and 120: period 360
///     Cam left = mirrored_about_slave(cam, 0);                    // slave position u becomes -u
///     Cam window = part(cam, 300, 420);                           // across the end of the period
///     Cam held = inserted(cam, 90, Cam({line(30, 50, 50)}));      // a dwell over 30 of the master
///     Cam second = composed(cam, camshaft);                       // cam(camshaft(x))
///
/// **Other operations.** The functions for any curve in jounce/profiles/curve/curve.hpp apply to
/// cams as well: `scaled` (slave and master times a factor), `shifted` (by dx of the master, dy of
/// the slave), `reversed` (backwards), `concatenated`, `repeated`, `sum`, `with`. The functions of
/// this header depend on the policy of the cam outside its interval: periodic (wrap or advance),
/// hold, or refuse.
///
/// **Values** do not change: a jump at a break remains, and check_continuity() (limits/limits.hpp)
/// reports it. If a **cut** is nearer to a break than 1e-13 of the master positions, the cut is
/// made at the break. Segments that are not cut stay the same to the last digit. The two parts of a
/// cut segment have lengths whose sum is exactly the length of the segment.
///
/// **Errors.** Each function documents when it throws InputError.

/// Returns the index of the segment at a master position. For a position outside the interval: a
/// periodic cam repeats its segments; for any other cam, the result is the first or the last
/// segment.
std::size_t segment_at(const Cam& f, double master);

/// Returns the cam between two master positions, with the policy refuse. The interval may exceed
/// the interval of `f`: a periodic cam continues with its next period, a cam that holds stays at
/// rest. Throws InputError if from >= to, if one of them is not finite, if [from, to] exceeds the
/// interval of a cam that refuses, if its length is only rounding, or if the result would have more
/// than 1e6 segments.
Cam part(const Cam& f, double from, double to);

/// Returns a periodic cam delayed by `phase`: g(x) = f(x - phase), over the same interval. `phase`
/// may be any finite number. A step of the position at the end of the period becomes a step inside
/// the interval. A cam that advances still advances. Throws InputError unless the cam is periodic
/// (wrap or advance) and the phase finite.
Cam phased(const Cam& f, double phase);

/// Returns the cam for a master that moves in the opposite direction: g(master + x) = f(master -
/// x). Throws InputError if `master` is not finite.
Cam mirrored_about_master(const Cam& f, double master);

/// Returns the cam of a slave that moves in the opposite direction: g(x) = 2 slave - f(x). Throws
/// InputError if `slave` is not finite.
Cam mirrored_about_slave(const Cam& f, double slave);

/// Returns f, with g in its place on the interval of g. The policy of g has no effect. Throws
/// InputError unless f contains this interval.
Cam replaced(const Cam& f, const Cam& g);

/// Returns f up to the master position `at`, then g, then the rest of f. The result is longer than
/// f by the length of g. The start and the policy of g have no effect. Throws InputError unless
/// start <= at <= end of f.
Cam inserted(const Cam& f, double at, const Cam& g);

/// Returns f + g. The policies of f and g outside their intervals determine the interval of the
/// sum:
///
/// | f, g | interval of the sum | outside |
/// |---|---|---|
/// | both wrap or advance | the common period (up to 1000 turns) from f's start | wrap or advance |
/// | both hold | from the first start to the last end | hold |
/// | one refuses | its own interval, over which the other extrapolates | refuse |
/// | both refuse | the interval of f; that of g must be equal (to rounding) | refuse |
///
/// Throws InputError "period" in two cases: the two periods have no common multiple (to 1e-12)
/// within 1000 turns of each; or one cam is periodic and the other holds, so the sum would be
/// neither (take a `part` of each). Throws InputError "sum" if a segment needs more than three
/// sines; the next overload accepts any number.
Cam superimposed(const Cam& f, const Cam& g);

/// Returns f + g for any number of sines. Where the exact sum does not fit, polynomials replace the
/// sines of `g`, with an error of at most `tolerance` > 0 (unit of the slave). The error is
/// certified (fitted.hpp); it is zero if nothing is replaced. Throws InputError "tolerance" unless
/// the tolerance is > 0, and also like polynomial_within(). Throws "period" like the overload
/// above.
Fitted<OverMaster> superimposed(const Cam& f, const Cam& g, double tolerance);

}  // namespace jounce
