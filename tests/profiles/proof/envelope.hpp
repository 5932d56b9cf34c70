// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/moves/move.hpp"

namespace jounce::proof {

using Real = long double;

/// One direction of the bounds: the limit of velocity and what brakes in front of it. The other
/// direction is the same for the negated motion.
struct Side {
  Real top = 0;             ///< limit of velocity
  Real a_max = 0;           ///< > 0
  Real a_min = 0;           ///< < 0: brakes
  Real rise = 0, fall = 0;  ///< jerk_max and -jerk_min, both > 0
};
Side upper(const Bounds& bounds);
Side lower(const Bounds& bounds);  ///< side of the negated motion

/// A stretch of constant jerk: the state at its begin, and where that is in time.
struct Arc {
  Real begin = 0;
  Real v = 0, a = 0, j = 0;

  [[nodiscard]] Real velocity(Real t) const {
    const Real s = t - begin;
    return v + s * (a + s * j / 2);
  }
  [[nodiscard]] Real acceleration(Real t) const { return a + (t - begin) * j; }
};

/// The largest velocity that a start is allowed at each instant (docs/generators/move.md, "A start
/// outside the bounds"):
///
/// - inside, the limit;
/// - where the acceleration can first be back at zero above the limit only: the fastest level
///   return, that is full braking, released so that velocity reaches the limit with acceleration 0.
///   Up to where that passes the limit, the limit: a target that runs out, too, may be met there;
/// - where the braking carries the velocity through the limit in every case: the velocity under
///   full jerk upwards until it passes the limit, then the limit.
///
/// Found by plain integration: the instant of the release is bisected, no profile is solved. To the
/// last bits of long double.
struct Envelope {
  std::vector<Arc> arcs;  ///< ascending, the last is the limit itself
  /// Until then there is only one admissible motion that goes on; others end where the limit still holds.
  Real forced = 0;

  [[nodiscard]] const Arc& arc(Real t) const;
  [[nodiscard]] Real velocity(Real t) const { return arc(t).velocity(t); }
};
/// Envelope of third order, or of second if `rise` is infinite.
Envelope envelope(Real v, Real a, const Side& side);

/// A state on the way, and when it is there.
struct Freedom {
  Real time = 0, x = 0, v = 0, a = 0;
};
/// The state in which the freedom of a start begins: after the stretch on which acceleration or
/// velocity come inside in the only way that is admissible. First the acceleration is held for
/// `hold` s. Third order.
Freedom freedom(const MotionState& from, const Bounds& bounds, Real hold = 0);

/// The states of the forced stretch before that at which it has a given acceleration, or, where that
/// is held, a given velocity: where it can pass through a target.
std::vector<Freedom> forced_at(const MotionState& from, const Bounds& bounds, Real hold, Real v,
                               Real a);

/// The fastest stop: how long it takes and how far it runs, signed. Third order; integrated.
Freedom fastest_stop(const MotionState& from, const Bounds& bounds);

/// The distance of the fastest change from rest to a state that can be reached without moving
/// backwards.
Real run_up(const MotionState& to, const Bounds& bounds);
/// True if it can.
bool forward(const MotionState& to, const Bounds& bounds);

/// Limits for a move to a target at rest whose start brakes towards it harder than its limit
/// permits. The limit stays if the move does not pass the target with it. If the move passes the
/// target, but would not if the braking continued, the limit is the least (in magnitude) with which
/// it does not. If the move passes the target in any case, the braking is first held for as long as
/// its stop needs. Found by integrating the stop and bisecting the limit.
struct Force {
  Bounds bounds = {};  ///< bounds of the shortest move
  Bounds longer = {};  ///< bounds of moves of longer durations
  Real hold = 0;       ///< s that the start's acceleration is held first
};
/// `slack`: how much farther away the target is taken to be, u.
Force in_force(const MotionState& from, const MotionState& to, const Bounds& bounds,
               Real slack = 0);

}  // namespace jounce::proof
