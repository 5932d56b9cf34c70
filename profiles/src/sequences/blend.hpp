// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/sequences/queue.hpp"

// How one move of a queue is planned between two junctions. Everything here looks *forward*: the
// target lies at a greater position; who asks mirrors what runs the other way.

namespace jounce::detail {

/// The dynamics as bounds for a move in the positive direction.
Bounds forward(const Dynamics& dynamics);

/// True if the axis runs, or is about to run, backwards.
bool runs_backwards(const MotionState& from, const Dynamics& dynamics);

/// Where acceleration and deceleration differ, an axis that has to turn round stops first.
bool stops_to_turn(const Dynamics& dynamics);

/// The fastest stop, wherever the axis is going.
Profile halt(const MotionState& from, const Dynamics& dynamics);

/// The fastest change to a velocity; neither end need keep the velocity bound.
Profile ramp(const MotionState& from, double velocity, const Bounds& bounds);

/// The highest velocity, up to `cap`, at which a move over `length` may begin so that it can end at
/// `exit` >= 0; `cap` itself if that is not higher than `exit`.
double highest_entry(double length, double exit, double cap, const Bounds& bounds);

/// What can be reached at the end of a move.
struct Exit {
  double velocity = 0;
  bool turns = false;  ///< the axis has to turn round
};

/// The velocity that a move from `from` can have at `target`, as near to `wanted` >= 0 as it can.
/// `cap` >= `wanted` is the most that the moves after it can take over. A move that turns round and
/// stops to do so is not looked at further: ask again from there.
Exit reachable_exit(const MotionState& from, double target, double wanted, double cap,
                    const Dynamics& dynamics);

/// The move itself, which does not stop to turn: one profile, or three where it begins or leaves faster than it may run.
std::vector<Profile> between(const MotionState& from, double target, const Exit& exit,
                             const Dynamics& dynamics);

}  // namespace jounce::detail
