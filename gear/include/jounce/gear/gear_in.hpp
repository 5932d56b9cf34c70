// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// A gear that is engaged in flight, within limits over time: MC_GearIn (PLCopen; PMC600 manual 6.1).
///
///     const GearInSpec spec{.numerator = 1, .denominator = 2, .acceleration = 20000};
///     const GearedIn gear = gear_in(spec, slave, master.jet(0), 0);    // at t = 0
///     const Jet now = point(gear, master.jet(t), t);                   // each cycle
///     if (in_gear(gear, t)) ...                                        // InGear
///     const GearedIn other = gear_in(new_spec, state, master.jet(t), t);   // re-trigger: replaces it
///     const Released out = cam_out(now, t);                            // GearOut keeps the velocity
///
/// From the state it is in, the slave ramps to the velocity that the gear gives it, k x'; from then on
/// it goes k for every unit of its master. It never makes up the distance lost (or gained) in the ramp:
///
///     (1)  y(t) = y0 + k (x(t) - x0) + c(t)
///
/// c is the difference due to the ramp: its velocity begins with y0' - k x0' and ends with 0. With
/// a steady master, as the manual recommends, `acceleration`, `deceleration` and `jerk` are those
/// of the slave itself. A master that accelerates while the slave is ramping adds k x'': so the
/// ramp takes the same time for any motion of the master, and there is no cycle in which the slave
/// hunts for a velocity that runs away from it.
///
/// u is the slave's unit, m the master's; times in s. Pure: a GearedIn is a value, nothing allocates
/// in gear_in() with a jet or point().
struct GearInSpec {
  std::int64_t numerator = 1;    ///< k = numerator / denominator, u/m; may be negative, or 0
  std::int64_t denominator = 1;  ///< > 0; PMC600 error 675
  double acceleration = 0;       ///< u/s^2, > 0; error 676
  double deceleration = 0;  ///< u/s^2, while the slave slows down; 0: as acceleration; error 677
  double jerk = 0;          ///< u/s^3; 0: not limited, the acceleration steps; error 679
};

/// A gear that is engaged, or being engaged.
struct GearedIn {
  double ratio = 1;     ///< k, u/m
  double time = 0;      ///< s, when it was triggered
  double master = 0;    ///< x0, m, then
  double slave = 0;     ///< y0, u, then
  double velocity = 0;  ///< k x0', u/s: end of the ramp with a steady master
  Profile ramp;         ///< that, from position 0 at time 0
};

/// Throws InputError for a spec that is out of range (the codes above), and for states that are not
/// finite. With a jerk limit, an acceleration of the slave or the master is taken over.
GearedIn gear_in(const GearInSpec& spec, const MotionState& slave, const Jet& master, double t);

/// The slave's set-point, [y, y', y'', y'''], for a master that moves as [x, x', x'', x'''].
Jet point(const GearedIn& gear, const Jet& master, double t);

/// InGear: the ramp is over.
bool in_gear(const GearedIn& gear, double t);

/// The slave's exact whole motion behind a known master: it stands at `slave` until t, the instant
/// of the GearIn trigger. It lasts until master and ramp have ended. Throws like gear_in(), and
/// InputError "t" for a time outside the master's.
Trajectory gear_in(const GearInSpec& spec, double slave, const Trajectory& master, double t);

}  // namespace jounce
