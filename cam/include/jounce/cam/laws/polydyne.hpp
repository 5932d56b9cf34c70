// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/vibration/vibration.hpp"

namespace jounce {

/// A cam that moves a follower on a spring exactly as required.
struct Polydyne {
  Cam cam;               ///< the cam f of (1) below
  Report warnings = {};  ///< "polydyne/geo_acceleration" if the cam's geo_acceleration steps
};

/// Returns the polydyne cam f for a required motion y of a follower on a spring. If the cam f moves
/// one end of the spring, the follower at its other end moves exactly as y:
///
///     (1)  f = y + (2 D / w) y' + y'' / w^2,    w = 2 pi frequency, D the damping
///
/// The follower is the load of Mode (jounce/profiles/vibration/vibration.hpp), with the master in
/// place of time. It is at rest whenever y is at rest, so no residual vibration remains.
///
///     const Cam output = design(spec).cam;                      // e.g. 5-6-7-8-9 rises, dwells
///     const double speed = 400;                                 // deg/s: exact only at this speed
///     const Polydyne made = polydyne(output, {.frequency = 12 / speed, .damping = 0.02});
///
/// **Units.** mode.frequency is in cycles per unit of the master: the frequency in Hz divided by
/// the speed of the master. At other speeds, the follower oscillates (see residual_vibration()); it
/// oscillates less with a smoother y.
///
/// **Exact.** For y on any Segment (degree 11, three sines), f is a Segment too. The cam has the
/// breaks of y, and the policy of y outside.
///
/// **Smoothness.** The cam has two continuous derivatives fewer than y. Throws InputError
/// `polydyne` for a mode out of range, and if the cam or its geo_velocity would step, because
/// geo_velocity, geo_acceleration or geo_jerk of y steps (also at the ends of a cam that holds). A
/// step of the cam's geo_acceleration is a warning. Every 4-5-6-7 rise causes such a step, of size
/// 840 stroke / (w^2 length^4); 5-6-7-8-9 and `nonic` do not.
///
/// Source: W. M. Dudley, "New methods in valve cam design", SAE Quarterly Transactions 2 (1948); D.
/// A. Stoddart, "Polydyne cam design", Machine Design, 1953.
Polydyne polydyne(const Cam& output, const Mode& mode);

}  // namespace jounce
