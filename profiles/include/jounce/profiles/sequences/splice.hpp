// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Functions that cut a running motion and continue with another one. A controller does this when a
/// target or a velocity changes in flight, when a move aborts another one, or when a move is
/// superimposed.
///
///     const Trajectory running = trapezoid({.to = 50, .velocity = 10, .acceleration = 20}).curve();
///     const MotionState now = state_at(running, 2);
///     const MoveResult next = move_to(now, {.position = 80}, within(10, 20));
///     const Trajectory both = spliced(running, 2, next.profile);
///
/// **Outside its interval** a motion is continued as follows: before its start it stands still;
/// after its end it keeps its end velocity, without acceleration. So a motion that ended at rest
/// stands still, and a jog continues.
///
/// **Throws** InputError if a time is not finite or precedes the start of the motion.

/// Returns the position, velocity and acceleration of f at t >= f.start(). At a break: the values
/// after it.
MotionState state_at(const Trajectory& f, double t);

/// Returns the state at t from which a new command with this jerk begins. The jerk is in the unit
/// of the position per s^3; 0: no limit. The acceleration of the state is zero in two cases: the
/// command has no jerk limit, or the acceleration of `f` has steps near t, as in a trapezoid. Then
/// the new command may also begin with a step of the acceleration.
MotionState state_for(const Trajectory& f, double t, double jerk);

/// Returns f from its start to t, cut or continued as described above. Throws InputError also if t
/// is f.start(). A t that differs from a break only by rounding counts as the break.
Trajectory until(const Trajectory& f, double t);

/// Returns `running` until t >= its start, then `next`, whose own start time has no effect. `next`
/// should begin in state_at(running, t). If t is the start, the result is `next` alone, from t. The
/// result holds outside if it ends at rest; otherwise it refuses.
Trajectory spliced(const Trajectory& running, double t, const Trajectory& next);

/// Like spliced() above, with a sequence of profiles as the continuation; profiles without duration
/// are omitted. Throws InputError if t is the start and no profile has a duration.
Trajectory spliced(const Trajectory& running, double t, std::span<const Profile> next);
inline Trajectory spliced(const Trajectory& running, double t, const Profile& next) {
  return spliced(running, t, std::span(&next, 1));
}

/// Returns the sum of two motions over an interval that contains the intervals of both. Outside its
/// own interval, each motion is continued as described above. Exact; throws like sum() if a piece
/// needs more than three sines.
Trajectory superimposed(const Trajectory& f, const Trajectory& g);

}  // namespace jounce
