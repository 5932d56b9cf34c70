// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Cuts a running motion and continues with another one, as a controller does when a target or a
/// velocity changes in flight, when a move aborts another, or when one is superimposed on another.
///
///     const Trajectory running = trapezoid({.to = 50, .velocity = 10, .acceleration = 20}).curve();
///     const MotionState now = state_at(running, 2);
///     const Move next = move_to(now, {.position = 80}, within(10, 20));
///     const Trajectory both = spliced(running, 2, next.profile);
///
/// **Beyond its end** a motion keeps its end velocity: one that ended at rest stands still, one
/// that ended at a velocity (a jog) keeps it, without acceleration. Before its start it stands
/// still.
///
/// **Throws** InputError for a time that is not finite or lies before the start of the motion.

/// Position, velocity and acceleration at t >= f.start(), right-continuous.
MotionState state_at(const Trajectory& f, double t);

/// The state that a new command with this jerk (0: not limited) takes over at t. Its acceleration
/// is zero without a jerk limit, and also if the acceleration of `f` at t begins and ends with a
/// step, as in a trapezoid: it can then step at t too.
MotionState state_for(const Trajectory& f, double t, double jerk);

/// f from its start up to t > f.start(): shortened, or prolonged as described above. A t that differs
/// from a break by rounding alone is that break.
Trajectory until(const Trajectory& f, double t);

/// `running` up to t >= its start, then `next`, independent of its own start time; it should begin
/// in state_at(running, t). With t at the start, `next` alone, from there. The result holds outside
/// if it ends at rest, otherwise it refuses, for every `running`.
Trajectory spliced(const Trajectory& running, double t, const Trajectory& next);

/// The same with successive profiles; those without duration are omitted.
Trajectory spliced(const Trajectory& running, double t, std::span<const Profile> next);
inline Trajectory spliced(const Trajectory& running, double t, const Profile& next) {
  return spliced(running, t, std::span(&next, 1));
}

/// Sum of two motions over the time of both: before its start each stands still, after its end it
/// continues as described above. Exact; throws like `sum` if more than three sines would be needed.
Trajectory superimposed(const Trajectory& f, const Trajectory& g);

}  // namespace jounce
