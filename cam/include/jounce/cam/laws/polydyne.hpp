// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/vibration/vibration.hpp"

namespace jounce {

/// A cam that makes a follower on a spring move as specified, and warnings about it.
struct Polydyne {
  Cam cam;
  Report warnings;  ///< "polydyne/geo_acceleration": the cam's acceleration steps
};

/// The polydyne cam: a follower on a spring (Mode, jounce/profiles/vibration/vibration.hpp, over
/// the master instead of time) that is moved by the cam f follows the required output y exactly,
///
///     (1)  f = y + (2 D / w) y' + y'' / w^2,    w = 2 pi frequency
///
/// and is at rest whenever y is: there is no residual vibration.
///
///     const Cam output = design(spec).cam;                      // e.g. 5-6-7-8-9 rises, dwells
///     const double speed = 400;                                 // deg/s: exact only at this speed
///     const Polydyne made = polydyne(output, {.frequency = 12 / speed, .damping = 0.02});
///
/// **Units.** mode.frequency in cycles per unit of the master: Hz over the master's speed. At other
/// speeds the follower oscillates (see residual_vibration()), and less for a smoother y.
///
/// **Exact** on every Segment (degree 11, three sines): (1) of such a segment is again such a
/// segment. The cam has the breaks of the output and the same Outside policy.
///
/// **Smoothness.** The cam has two continuous derivatives fewer than the output. Throws InputError
/// `polydyne` for a mode out of range, and if the cam itself or its geo_velocity would step,
/// because the output's geo_velocity, geo_acceleration or geo_jerk steps (also at the ends of a cam
/// that holds). A step of the cam's geo_acceleration (any 4-5-6-7 rise: 840 / w^2 of stroke over
/// length squared) is a warning: 5-6-7-8-9, or `nonic`, has none.
///
/// Source: W. M. Dudley, "New methods in valve cam design", SAE Quarterly Transactions 2 (1948); D.
/// A. Stoddart, "Polydyne cam design", Machine Design, 1953.
Polydyne polydyne(const Cam& output, const Mode& mode);

}  // namespace jounce
