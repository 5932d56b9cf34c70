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
/// **Vocabulary.** The functions for any curve are in jounce/profiles/curve/curve.hpp and apply to
/// cams: `scaled` (slave times a factor, master times a stretch), `shifted` (offsets dx, dy),
/// `reversed` (run backwards), `concatenated`, `repeated`, `sum`, `with`. The functions here depend
/// on the extrapolation of a cam: periodic (Extrapolation::wrap), holding, or none.
///
/// **Values** stay as they are: a jump at a joint remains, and `check_continuity` finds it.
/// **Cuts** nearer to a break than 1e-13 of the axis are at that break. Segments without a cut stay
/// the same to the last digit; the lengths of the two parts of a cut segment add up to its length
/// exactly.
///
/// **Throws** InputError as documented for each function.

/// Returns the cam between two master positions, as a cam that rejects positions outside. The
/// interval may exceed that of `f`: a periodic cam continues with its next turn, a cam that holds
/// stays at rest. Throws InputError unless from < to are finite, if the interval exceeds that of a
/// cam that rejects positions outside, and for more than 1e6 segments.
Cam part(const Cam& f, double from, double to);

/// Returns a periodic cam, later by `phase`: g(x) = f(x - phase) over the same interval, for any
/// finite phase. The period is the same. A step of the position at the wrap becomes a step inside;
/// a slave that advances still advances. Throws InputError unless the cam wraps or advances.
Cam phased(const Cam& f, double phase);

/// g(master + x) = f(master - x): the cam for a master in the opposite direction.
Cam mirrored_about_master(const Cam& f, double master);

/// g(x) = 2 slave - f(x): the cam of a slave in the opposite direction.
Cam mirrored_about_slave(const Cam& f, double slave);

/// Returns f, with g over g's interval, which must lie within f's; throws InputError otherwise.
Cam replaced(const Cam& f, const Cam& g);

/// f up to `at`, then g, then the rest of f: longer than f by g's length, for any start of g.
/// Throws InputError unless start <= at <= end.
Cam inserted(const Cam& f, double at, const Cam& g);

/// f + g: superposed cams. The interval of the sum depends on the extrapolation of both:
///
/// | f, g | interval of the sum | outside |
/// |---|---|---|
/// | both wrap or advance | the common period (up to 1000 turns) from f's start | wrap; advance if one does |
/// | both hold | from the first start to the last end | hold |
/// | one refuses | its own interval, over which the other extrapolates | refuse |
/// | both refuse | their common interval, equal to rounding | refuse |
///
/// Throws InputError "period" if two periods have no common multiple (1e-12), or if one wraps and
/// the other holds: the sum is neither (cut it out with `part`). Throws InputError "sum" if a
/// segment needs more than three sines: use the overload with a tolerance.
Cam superimposed(const Cam& f, const Cam& g);

/// The same for any number of sines: if the exact sum does not fit, polynomials within `tolerance`
/// > 0 (unit of the slave) replace the sines of `g`. The error is certified (fitted.hpp), and zero
/// without a replacement.
Fitted<OverMaster> superimposed(const Cam& f, const Cam& g, double tolerance);

}  // namespace jounce
