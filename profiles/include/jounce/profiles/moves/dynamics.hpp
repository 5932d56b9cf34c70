// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Dynamics of a command, as PLCopen blocks and most controllers define them: magnitudes, with a
/// separate `deceleration` for the time while the axis slows down. u is the axis' unit.
///
///     const Dynamics axis{.velocity = 10, .acceleration = 20, .deceleration = 10, .jerk = 200};
///     const Trajectory running = point_to_point(0, 50, axis).curve();
///     const Trajectory longer = with_target(running, 2, 80, axis);     // new target at 2 s
///     const Trajectory slower = with_velocity(running, 2, 5, axis);    // new velocity at 2 s
///     const Trajectory halted = with_velocity(running, 2, 0, axis);    // MC_Halt
///
/// **Change in flight.** Position, velocity and (with a jerk limit) acceleration are continuous
/// when a command changes a running motion. Without a jerk limit the acceleration steps. If a
/// command with a jerk limit interrupts a motion without one, it begins at zero acceleration
/// (`state_for` in splice.hpp).
///
/// **Throws.** The functions below throw InputError for a value out of range: velocity and
/// acceleration must be > 0, the others >= 0. They also throw if a time precedes the start of
/// `running`, and if no motion results.
struct Dynamics {
  double velocity = 0;           ///< u/s, > 0
  double acceleration = 0;       ///< u/s^2, > 0
  double deceleration = 0;       ///< u/s^2; 0: the same as acceleration
  double jerk = 0;               ///< u/s^3; 0: not limited; must be > 0 if deceleration_jerk > 0
  double deceleration_jerk = 0;  ///< u/s^3, while the axis slows down; 0: the same as jerk
};

/// Returns a move from rest to rest: trapezoid() without a jerk limit, otherwise s_curve(). Throws
/// InputError if `to` equals `from`.
Profile point_to_point(double from, double to, const Dynamics& dynamics);

/// Returns the change of velocity from any state to `velocity` (u/s, signed), with the limits of
/// `dynamics`; dynamics.velocity is not used.
Profile velocity_ramp(const MotionState& from, double velocity, const Dynamics& dynamics);

// ---- in flight -------------------------------------------------------------------------------

/// Returns `running` until the time t (s), then the fastest motion to rest at `target` (u). If the
/// axis has passed the target, or can no longer stop before the target, it stops and moves back. A
/// velocity above the new dynamics.velocity is reduced first.
///
/// If acceleration and deceleration differ, a motion that must reverse stops first, then moves
/// back.
///
/// If jerk and deceleration_jerk differ, each applies in its own phase in two cases: the axis only
/// stops, or it first changes to one velocity and then stops. In these cases, the motion does not
/// change if the same command is repeated. In all other cases (the axis must reverse, or the target
/// is too near), the larger jerk applies to the rest of the move. With the smaller jerk, an axis
/// that is speeding up would exceed its velocity.
Trajectory with_target(const Trajectory& running, double t, double target,
                       const Dynamics& dynamics);

/// Returns `running` until the time t (s), then the change to `velocity` (u/s, signed).
/// dynamics.velocity is not used. The result ends when the axis reaches the velocity. If `running`
/// already has this velocity at t, the result ends at t; InputError is thrown if t is then also the
/// start of `running`.
Trajectory with_velocity(const Trajectory& running, double t, double velocity,
                         const Dynamics& dynamics);

}  // namespace jounce
