// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/sequences/queue.hpp"

// Plans one move of a queue between two junctions. All functions expect the target at a greater
// position; callers mirror a move in the other direction.

namespace jounce::profiles_detail {

/// The dynamics as bounds for a move in the positive direction.
Bounds forward(const Dynamics& dynamics);

/// True if the axis moves, or is about to move, backwards.
bool runs_backwards(const MotionState& from, const Dynamics& dynamics);

/// True if an axis that must reverse stops first: acceleration and deceleration differ.
bool stops_to_turn(const Dynamics& dynamics);

/// The fastest stop, for either direction of motion.
Profile halt(const MotionState& from, const Dynamics& dynamics);

/// The fastest change to a velocity. The velocities at both ends may exceed the velocity bound.
Profile ramp(const MotionState& from, double velocity, const Bounds& bounds);

/// The highest velocity, up to `cap`, at which a move over `length` may begin so that it can end at
/// `exit` >= 0; `cap` itself if that is not higher than `exit`.
double highest_entry(double length, double exit, double cap, const Bounds& bounds);

/// The end of a move, as far as it can be reached.
struct Exit {
  double velocity = 0;
  bool turns = false;  ///< the axis must reverse
};

/// The velocity that a move from `from` can have at `target`, as near to `wanted` >= 0 as possible.
/// `cap` >= `wanted` is the greatest velocity with which the following moves can begin. A move that
/// stops in order to reverse is not examined further; call the function again from the stop.
Exit reachable_exit(const MotionState& from, double target, double wanted, double cap,
                    const Dynamics& dynamics);

/// The move itself, without a stop to reverse: one profile, or three if its velocity at an end
/// exceeds the limit.
std::vector<Profile> between(const MotionState& from, double target, const Exit& exit,
                             const Dynamics& dynamics);

}  // namespace jounce::profiles_detail
