// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Bounds of a move, separate for each direction: u, u/s, u/s^2, u/s^3, signed. Every max > 0 and
/// every min < 0 (positions: min < max). An infinite value means no limit: without jerk limits the
/// motion is of second order (acceleration steps), without those of acceleration of first order.
struct Bounds {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double velocity_min = -none, velocity_max = none;
  double acceleration_min = -none, acceleration_max = none;
  double jerk_min = -none, jerk_max = none;
  double position_min = -none, position_max = none;

  bool operator==(const Bounds&) const = default;
};

/// Bounds that are the same in both directions; magnitudes > 0.
constexpr Bounds within(double velocity, double acceleration = Bounds::none,
                        double jerk = Bounds::none) {
  return {.velocity_min = -velocity,
          .velocity_max = velocity,
          .acceleration_min = -acceleration,
          .acceleration_max = acceleration,
          .jerk_min = -jerk,
          .jerk_max = jerk};
}

/// Reason why there is no move; `ok` if there is one.
enum class MoveStatus : std::uint8_t {
  ok,
  not_finite,      ///< a state or the duration is not finite, or greater than 1e50
  invalid_bounds,  ///< a max that is not > 0 or a min that is not < 0, a magnitude outside 1e-50 to
                   ///< 1e50 that is not infinite, NaN, or the highest derivative that is limited
                   ///< limited in one direction alone
  target_outside,  ///< the target's velocity or acceleration lies outside the bounds
  target_unreachable,  ///< reaching (or leaving) the target's acceleration needs a velocity outside
  position_limit,      ///< no move keeps the position limits: start or target runs into them
  too_short,           ///< the requested duration is below the minimum
  blocked,             ///< the requested duration lies in a blocked interval
  not_straight,        ///< phase synchronisation of states that do not lie on one line, or on which
                       ///< an axis would pass its velocity limit
};

/// One sentence for a status, for people.
const char* explain(MoveStatus status) noexcept;

/// A move, if there is one; otherwise the profile is empty.
struct MoveResult {
  MoveStatus status = MoveStatus::ok;
  Profile profile;

  explicit operator bool() const noexcept { return status == MoveStatus::ok; }
};

/// The time-optimal move between two states that keeps the bounds.
///
///     const Bounds axis = within(2, 10, 100);                        // u/s, u/s^2, u/s^3
///     const Move move = move_to({.position = 0}, {.position = 1}, axis);
///     if (!move) throw std::runtime_error(explain(move.status));
///     const Motion now = move.profile.at(0.1);
///
/// **A start outside the bounds** (a limit or an override was lowered in flight) comes back inside by
/// one rule. The acceleration returns at full jerk. The velocity is never higher than on the fastest
/// return that ends level at its limit, and it may brake harder than that; once inside it stays
/// there. Of all such motions the move is the shortest. A target at rest that the fastest stop does
/// not pass is not passed, and the motion does not reverse. Where the start brakes towards a target
/// at rest harder than the limit of acceleration, and with that limit would pass the target, the
/// deceleration stays above the limit, but only by as much as the stop needs and never above that of
/// the start.
///
/// The target must lie inside (a quantity that may step, like the acceleration of a second-order
/// motion, steps to it at the end). Never longer than the true minimum by more than rounding; ends
/// at `to` exactly; results do not depend on the unit. If a position limit forbids the shortest
/// motion, the move stops first at a point of rest, as near as the limit allows: it then keeps the
/// limits, but need not be the shortest that does. Does not allocate, does not throw. Derivation:
/// docs/generators/move.md.
MoveResult move_to(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

/// The same, lasting exactly `duration` >= 0 s, gently (lower velocity first, then lower
/// accelerations).
MoveResult move_to(const MotionState& from, const MotionState& to, const Bounds& bounds,
                   double duration) noexcept;

/// Possible durations of a move between two states: every T >= minimum except the blocked intervals
/// (open, ascending, at most two), which exist only if an end moves.
struct Durations {
  struct Interval {
    double from = 0;
    double to = 0;
  };
  MoveStatus status = MoveStatus::ok;
  double minimum = 0;
  std::array<Interval, 2> blocked{};
  std::size_t count = 0;  ///< blocked intervals in use

  [[nodiscard]] bool allows(double duration) const noexcept;
  /// The least permitted duration that is not less than the one given.
  [[nodiscard]] double at_least(double duration) const noexcept;
};
Durations durations(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

/// The fastest change to a velocity (and acceleration), wherever that ends (PLCopen MC_MoveVelocity).
/// A start outside the bounds comes inside as in move_to(); its acceleration returns at full jerk.
MoveResult move_velocity(const MotionState& from, double velocity, const Bounds& bounds,
                         double acceleration = 0) noexcept;

/// The fastest stop (MC_Stop, MC_Halt).
inline MoveResult stop(const MotionState& from, const Bounds& bounds) noexcept {
  return move_velocity(from, 0, bounds);
}

}  // namespace jounce
