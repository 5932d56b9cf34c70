// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Cutting a running motion and going on differently: what a controller does when a target or a
/// velocity changes in flight, when a move aborts another, or when one is laid on top of another.
///
///     const Trajectory running = trapezoid({.to = 50, .velocity = 10, .acceleration = 20}).curve();
///     const MotionState now = state_at(running, 2);
///     const Move next = move_to(now, {.position = 80}, within(10, 20));
///     const Trajectory both = spliced(running, 2, next.profile);
///
/// **Beyond its end** a motion goes on at the velocity it ends with: one that ended at rest stands,
/// one that ended at a velocity (a jog) keeps it, without acceleration. Before its start it stands.
///
/// **Throws** InputError for a time that is not finite or lies before the start of the motion.

/// Position, velocity and acceleration at t >= f.start(), right-continuous.
MotionState state_at(const Trajectory& f, double t);

/// The state that a new command with this jerk (0: not limited) takes over at t. An acceleration is
/// one only under a jerk limit, and only where `f` led to it, or leads from it to zero, continuously:
/// one that steps in and steps out again, as a trapezoid's, can step at t too, and is none.
MotionState state_for(const Trajectory& f, double t, double jerk);

/// f from its start up to t > f.start(): shortened, or prolonged as described above. A t that differs
/// from a break by rounding alone is that break.
Trajectory until(const Trajectory& f, double t);

/// `running` up to t >= its start, then `next`, independent of its own start time; it should begin
/// in state_at(running, t). With t at the start, `next` alone, from there. The result holds outside
/// where it ends at rest, otherwise it refuses, for every `running`.
Trajectory spliced(const Trajectory& running, double t, const Trajectory& next);

/// The same with profiles one after another; those of no duration are left out.
Trajectory spliced(const Trajectory& running, double t, std::span<const Profile> next);
inline Trajectory spliced(const Trajectory& running, double t, const Profile& next) {
  return spliced(running, t, std::span(&next, 1));
}

/// Sum of two motions over the time of either: where one has not begun it stands, where it has
/// ended it continues as described above. Exact; throws as `sum` does where three sines do not do.
Trajectory superimposed(const Trajectory& f, const Trajectory& g);

}  // namespace jounce
