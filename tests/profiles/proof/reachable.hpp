// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/moves/move.hpp"

#include "profiles/proof/envelope.hpp"

namespace jounce::proof {

/// A closed interval of durations; `to` may be infinite.
struct Span {
  Real from = 0;
  Real to = 0;
};

/// Permitted deviation of a reached state: u, u/s, u/s^2. Above zero the problem is a little easier
/// than the one given, below zero a little harder.
struct Slack {
  Real position = 0;
  Real velocity = 0;
  Real acceleration = 0;
};

/// Every duration T in which an axis can go from one state to another within its bounds, ascending
/// and disjoint: the independent witness for `move_to`, `durations` and `synchronize`. It shares no
/// code and no formula with the solver: no profile is ever solved for a target position.
///
///     const std::vector<Span> T = reachable(from, to, bounds);
///     T.front().from;                       // the minimum duration
///     T[i].to, T[i + 1].from;               // a blocked interval
///
/// The target must be safe (`safe_target`). The start may lie anywhere: outside, the durations are
/// those of the motions that the rule for such starts admits (envelope.hpp). A start that is the
/// target can stay: T = 0. Position limits are not considered. Derivation: reachable.cpp.
std::vector<Span> reachable(const MotionState& from, const MotionState& to, const Bounds& bounds,
                            const Slack& slack = {});

/// The same for velocity and acceleration alone, wherever that ends (move_velocity).
std::vector<Span> reachable_velocity(const MotionState& from, double velocity, double acceleration,
                                     const Bounds& bounds, const Slack& slack = {});

/// True if a start can stay inside the bounds of velocity and acceleration.
bool safe_start(const MotionState& from, const Bounds& bounds);
/// True if a target lies inside, and can be reached without a velocity outside.
bool safe_target(const MotionState& to, const Bounds& bounds);

/// Does any of the spans hold T?
bool contains(const std::vector<Span>& spans, Real T);

}  // namespace jounce::proof
