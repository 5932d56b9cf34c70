#pragma once

#include "jounce/profiles/curve.hpp"
#include "jounce/profiles/limits.hpp"
#include "jounce/profiles/vibration.hpp"

namespace jounce {

/// A cam that makes what hangs behind a spring move as wanted, and what is odd about it.
struct Polydyne {
  Cam cam;
  Report warnings;  ///< "polydyne/geo_acceleration": the cam's acceleration steps
};

/// The polydyne cam: a follower on a spring (Mode, profiles/vibration.hpp, over the master instead of
/// time) that is moved by the cam f moves exactly along the wanted output y,
///
///     (1)  f = y + (2 D / w) y' + y'' / w^2,    w = 2 pi frequency
///
/// and stands still where y does: nothing is left to swing.
///
///     const Cam output = design(spec).cam;                      // e.g. 5-6-7-8-9 rises, dwells
///     const double speed = 400;                                 // deg/s: it is right at this one
///     const Polydyne made = polydyne(output, {.frequency = 12 / speed, .damping = 0.02});
///
/// **Units.** mode.frequency in cycles per unit of the master: Hz over the master's speed. At other
/// speeds the follower swings (see residual_vibration()), and less if y is smoother.
///
/// **Exact** on every Segment (degree 11, three sines): (1) maps the set onto itself. The cam has the
/// output's breaks and its policy outside.
///
/// **Smoothness.** The cam has two derivatives less than the output. Throws InputError `polydyne`
/// where the cam itself or its geo_velocity would step: the output's geo_velocity, geo_acceleration
/// or geo_jerk does, also into and out of the rest of a cam that holds; and for a mode out of
/// range. A step of the cam's geo_acceleration (any 4-5-6-7 rise: 840 / w^2 of stroke over length
/// squared) is a warning: 5-6-7-8-9, or `nonic`, has none.
///
/// Source: W. M. Dudley, "New methods in valve cam design", SAE Quarterly Transactions 2 (1948);
/// D. A. Stoddart, "Polydyne cam design", Machine Design, 1953.
Polydyne polydyne(const Cam& output, const Mode& mode);

}  // namespace jounce
