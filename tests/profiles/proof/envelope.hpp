#pragma once

#include <algorithm>
#include <vector>

#include "jounce/profiles/move.hpp"

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
Side lower(const Bounds& bounds);  ///< of the negated motion

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
///   return, that is full braking, released so that velocity reaches the limit with acceleration 0;
/// - where the braking carries the velocity through the limit whatever is done: the velocity under
///   full jerk upwards until it passes the limit, then the limit.
///
/// Found by plain integration: the instant of the release is bisected, no profile is solved. To the
/// last bits of long double.
struct Envelope {
  std::vector<Arc> arcs;  ///< ascending, the last is the limit itself
  Real forced = 0;        ///< until then there is only one admissible motion

  [[nodiscard]] const Arc& arc(Real t) const;
  Real passes = 0;  ///< when the velocity has to pass its limit from inside; 0: it has not

  /// What ends before the velocity has to pass its limit need only keep that.
  [[nodiscard]] Real velocity(Real t) const { return std::max(arc(t).velocity(t), arcs.back().v); }
};
/// Of third order, or of second where `rise` is infinite.
Envelope envelope(Real v, Real a, const Side& side);

/// The state in which the freedom of a start begins: after the stretch on which acceleration or
/// velocity come inside in the only way that is admissible. Third order.
struct Freedom {
  Real time = 0, x = 0, v = 0, a = 0;
  Real passes = 0;  ///< what ends until then is free from the beginning
};
Freedom freedom(const MotionState& from, const Bounds& bounds);
/// The state in which the acceleration is inside.
Freedom acceleration_inside(const MotionState& from, const Bounds& bounds);

/// What holds for a move to a target from a start that brakes towards it harder than its limit, and
/// needs to go on so as not to pass it: the least limit (in magnitude) that does not pass it. Where
/// even the start's own acceleration passes it, that is held as long as the stop needs it.
/// Elsewhere the bounds given.
struct InForce {
  Bounds bounds;
  Real hold = 0;  ///< s, before all else
};
/// Found by integrating the stop and bisecting the limit. `longer`: for a motion that lasts longer than
/// the shortest; the limit is then the start's own acceleration.
InForce in_force(const MotionState& from, const MotionState& to, const Bounds& bounds,
                 bool longer = false);
/// A start after its hold.
MotionState after_hold(const MotionState& from, Real hold);

}  // namespace jounce::proof
