// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// A gear that engages in motion, within limits over time: MC_GearIn (PLCopen; PMC600 manual 6.1).
///
///     const GearInSpec spec{.numerator = 1, .denominator = 2, .acceleration = 20000};
///     const GearedIn gear = gear_in(spec, slave, master.jet(0), 0);    // at t = 0
///     const Jet now = point(gear, master.jet(t), t);                   // each cycle
///     if (in_gear(gear, t)) ...                                        // InGear
///     const GearedIn other = gear_in(new_spec, state, master.jet(t), t);  // after a new trigger
///     const Released out = cam_out(now, t);                          // GearOut keeps the velocity
///
/// From its present state, the slave ramps to the velocity of the gear, k x'. After the ramp, the
/// slave moves by k for every unit of the master. The slave does not recover the distance that it
/// loses or gains in the ramp. With x the master, y the slave, and the index 0 for the instant of
/// the trigger,
///
///     (1)  y(t) = y0 + k (x(t) - x0) + c(t)
///
/// c is the difference caused by the ramp: its velocity begins at y0' - k x0' and ends at 0. If the
/// master runs at constant speed, as the manual recommends, the slave has exactly the acceleration,
/// deceleration and jerk of the spec. If the master accelerates during the ramp, k x'' is added. So
/// the motion of the master does not change the duration of the ramp, and the slave always reaches
/// the velocity of the gear.
///
/// u is the slave's unit, m the master's; times are in s. A GearedIn is a value; gear_in() with a
/// jet and point() do not allocate.
struct GearInSpec {
  std::int64_t numerator = 1;    ///< k = numerator / denominator, u/m; any sign, 0 permitted
  std::int64_t denominator = 1;  ///< > 0; otherwise PMC600 error 675
  double acceleration = 0;       ///< u/s^2, > 0; otherwise error 676
  /// u/s^2, while the slave slows down; 0: the same as acceleration; < 0 is error 677.
  double deceleration = 0;
  double jerk = 0;  ///< u/s^3; 0: no limit, the acceleration steps; < 0 is error 679
};

/// A gear that is engaged or engaging.
struct GearedIn {
  double ratio = 1;   ///< k, u/m
  double time = 0;    ///< s, time of the trigger
  double master = 0;  ///< x0, m, master position at the trigger
  double slave = 0;   ///< y0, u, slave position at the trigger
  /// k x0', u/s: velocity at the end of the ramp, if the master's velocity is constant.
  double velocity = 0;
  Profile ramp = {};  ///< the ramp to this velocity, from position 0 at time 0
};

/// Triggers the gear at time t (s), for a slave in the given state and a master at [x, x', x'',
/// x''']. With a jerk limit, the ramp begins with the accelerations of slave and master. Throws
/// InputError for a spec out of range (GearInSpec has the error numbers of the PMC600), and for
/// states that are not finite.
GearedIn gear_in(const GearInSpec& spec, const MotionState& slave, const Jet& master, double t);

/// Returns the setpoint of the slave, [y, y', y'', y'''], at t (s), for a master at [x, x', x'',
/// x'''].
Jet point(const GearedIn& gear, const Jet& master, double t);

/// InGear: true if the ramp is complete at t (s).
bool in_gear(const GearedIn& gear, double t);

/// Returns the exact motion of a slave for a known motion of the master. The slave stands at
/// `slave` (u) until the trigger at t (s). The motion ends when both the master's motion and the
/// ramp have ended. Throws like gear_in() above, and InputError "t" for a time before the start of
/// the master's motion, or not before its end.
Trajectory gear_in(const GearInSpec& spec, double slave, const Trajectory& master, double t);

}  // namespace jounce
