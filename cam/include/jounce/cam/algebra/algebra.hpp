// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/fitted.hpp"

namespace jounce {

/// New cams from old ones, exactly.
///
///     Cam lane2 = phased(cam, 180);                               // half a turn later
///     Cam both = superimposed(cam, correction);                   // 360 and 120: period 360
///     Cam left = mirrored_about_slave(cam, 0);                    // u -> -u
///     Cam window = part(cam, 300, 420);                           // across the wrap
///     Cam held = inserted(cam, 90, Cam({line(30, 50, 50)}));      // a dwell of 30
///     Cam second = composed(cam, camshaft);                       // cam(camshaft(x))
///
/// **Vocabulary.** What any curve can do stands in jounce/profiles/curve/curve.hpp and goes for cams: `scaled`
/// (slave times a factor, master times a stretch), `shifted` (offsets dx, dy), `reversed` (run
/// backwards), `concatenated`, `repeated`, `sum`, `with`. Here stands what needs to know that a cam
/// goes on beyond its interval: periodic (Extrapolation::wrap), holding, or not at all.
///
/// **Values are not moved** to make ends meet: a jump at a joint is kept, and found by
/// `check_continuity`. **Cuts** nearer to a break than 1e-13 of the axis are at that break; segments
/// that are not cut are the same to the last digit, and so are the lengths of the two parts of one
/// that is.
///
/// **Throws** InputError as documented for each function.

/// The cam between two master positions, as a cam of its own that refuses what lies outside. The
/// interval may leave the cam's: a periodic one begins its next turn, one that holds stands still.
/// Throws InputError unless from < to are finite, where the interval leaves a cam that refuses, and
/// for more than 1e6 segments.
Cam part(const Cam& f, double from, double to);

/// A periodic cam with everything later by `phase`: g(x) = f(x - phase) over the same interval, for
/// any finite phase. The period is the same; a step of the position at the wrap becomes one inside,
/// and a slave that advances goes on. Throws InputError unless the cam wraps or advances.
Cam phased(const Cam& f, double phase);

/// g(master + x) = f(master - x): the cam for a master that runs the other way.
Cam mirrored_about_master(const Cam& f, double master);

/// g(x) = 2 slave - f(x): the cam of a slave that moves the other way.
Cam mirrored_about_slave(const Cam& f, double slave);

/// f, but g over g's interval, which must lie within f's. Throws InputError if it does not.
Cam replaced(const Cam& f, const Cam& g);

/// f up to `at`, then g, then the rest of f: longer than f by g's length, for any start of g.
/// Throws InputError unless start <= at <= end.
Cam inserted(const Cam& f, double at, const Cam& g);

/// f + g: superposed cams. Over which interval depends on what they do outside theirs:
///
/// | f, g | interval of the sum | outside |
/// |---|---|---|
/// | both wrap or advance | the common period, from f's start; up to 1000 turns of each | wrap, or advance if one does |
/// | both hold | from the first start to the last end | hold |
/// | one refuses | its own, the other one goes on as it does | refuse |
/// | both refuse | the one they share to rounding | refuse |
///
/// Throws InputError "period" where two periods have no common multiple (1e-12), or where one wraps
/// and the other holds: the sum is neither (cut it out with `part`). Throws InputError "sum" where a
/// segment needs more than three sines: the form with a tolerance works.
Cam superimposed(const Cam& f, const Cam& g);

/// The same for any number of sines: where the exact sum does not fit, the sines of `g` are replaced
/// by polynomials within `tolerance` > 0 (unit of the slave); the error is certified (fitted.hpp),
/// and zero where nothing was replaced.
Fitted<OverMaster> superimposed(const Cam& f, const Cam& g, double tolerance);

}  // namespace jounce
