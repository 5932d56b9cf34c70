// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// The dynamics of a command as PLCopen blocks and most controllers take them: magnitudes, with
/// `deceleration` for slowing down. In any one unit of length and time: u, s here.
///
///     const Dynamics axis{.velocity = 10, .acceleration = 20, .deceleration = 10, .jerk = 200};
///     const Trajectory running = point_to_point(0, 50, axis).curve();
///     const Trajectory longer = with_target(running, 2, 80, axis);     // new target at 2 s
///     const Trajectory slower = with_velocity(running, 2, 5, axis);    // new velocity at 2 s
///     const Trajectory halted = with_velocity(running, 2, 0, axis);    // MC_Halt
///
/// **In flight** position, velocity and (with a jerk) acceleration go on continuously from the
/// instant of the change. Without jerk the acceleration steps, as in a trapezoid; out of one, a
/// command with a jerk begins with no acceleration (`state_for` in splice.hpp).
///
/// **Throws** InputError for values out of range: velocity and acceleration must be > 0, the others
/// not negative.
struct Dynamics {
  double velocity = 0;           ///< u/s, > 0
  double acceleration = 0;       ///< u/s^2, > 0
  double deceleration = 0;       ///< u/s^2; 0: as acceleration
  double jerk = 0;               ///< u/s^3; 0: not limited
  double deceleration_jerk = 0;  ///< u/s^3, while slowing down; 0: as jerk
};

/// Rest to rest: trapezoid or s_curve. Throws InputError if `to` equals `from`.
Profile point_to_point(double from, double to, const Dynamics& dynamics);

/// A motion from any state to a velocity (signed) without acceleration, as fast as the dynamics
/// permit (dynamics.velocity is not used). With a jerk limit, the acceleration of the state is taken
/// over. It falls first if it would lead past the velocity; if it would reverse the axis, it falls
/// until the axis rests. If speeding up and slowing down differ, a change through rest is two ramps.
/// From a state within them the limits hold throughout, except while an acceleration at rest,
/// permitted in slowing down, falls. Also throws InputError if time or position would overflow.
Profile velocity_ramp(const MotionState& from, double velocity, const Dynamics& dynamics);

// ---- in flight -------------------------------------------------------------------------------

/// `running` up to t, from there to rest at `target`, as fast as the dynamics allow. A target that
/// has been passed, or that can no longer be met, is reached after a return. A velocity above the
/// new one is reduced first.
///
/// If acceleration and deceleration differ, a motion that must reverse stops first, then moves
/// back. With two jerks, each holds in its own direction if the motion goes to one velocity and
/// from there to rest, or only stops: the same move given again changes nothing. Otherwise, if it
/// must reverse or its target is nearer than that, the larger jerk holds for the rest of the move:
/// with the smaller one an axis that is speeding up could not help passing its velocity.
Trajectory with_target(const Trajectory& running, double t, double target,
                       const Dynamics& dynamics);

/// `running` up to t, from there to `velocity` (signed; dynamics.velocity is not used). The result
/// ends when it reaches the velocity; it ends at t if `running` already has it.
Trajectory with_velocity(const Trajectory& running, double t, double velocity,
                         const Dynamics& dynamics);

}  // namespace jounce
