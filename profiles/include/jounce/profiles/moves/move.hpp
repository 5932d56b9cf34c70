// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Bounds of a move, separate for each direction: u, u/s, u/s^2, u/s^3, signed. Every max is > 0
/// and every min is < 0; for positions, min < max. An infinite value means no limit. Without jerk
/// limits the motion is of second order: the acceleration steps. Without limits of acceleration and
/// jerk it is of first order: the velocity steps. u is the axis' unit.
struct Bounds {
  static constexpr double none = std::numeric_limits<double>::infinity();  ///< no limit

  double velocity_min = -none, velocity_max = none;          ///< u/s
  double acceleration_min = -none, acceleration_max = none;  ///< u/s^2
  double jerk_min = -none, jerk_max = none;                  ///< u/s^3
  double position_min = -none, position_max = none;          ///< u

  bool operator==(const Bounds&) const = default;
};

/// Returns bounds that are equal in both directions. The arguments are magnitudes > 0; an omitted
/// argument means no limit.
constexpr Bounds within(double velocity, double acceleration = Bounds::none,
                        double jerk = Bounds::none) {
  return {.velocity_min = -velocity,
          .velocity_max = velocity,
          .acceleration_min = -acceleration,
          .acceleration_max = acceleration,
          .jerk_min = -jerk,
          .jerk_max = jerk};
}

/// The reason why there is no move; `ok` if there is one.
enum class MoveStatus : std::uint8_t {
  ok,
  /// The duration is not finite, or |position| + |velocity| + |acceleration| of a state is not
  /// below 1e50.
  not_finite,
  /// A bound of velocity, acceleration or jerk is invalid: a max <= 0, a min >= 0, NaN, or a finite
  /// magnitude outside 1e-50 to 1e50. Or position_min is not below position_max. Or the highest
  /// derivative that has a limit is limited in one direction only, or no derivative has a limit.
  invalid_bounds,
  target_outside,  ///< the velocity or acceleration of the target is outside the bounds
  /// The axis can reach (or leave) the acceleration of the target only with a velocity outside the
  /// bounds.
  target_unreachable,
  /// No move stays within the position limits: the axis cannot stop before a limit, or the motion
  /// of the target crosses a limit.
  position_limit,
  too_short,  ///< the requested duration is below the minimum
  blocked,    ///< the requested duration lies in a blocked interval
  /// Phase synchronization: the states are not on one line, or an axis would exceed its velocity
  /// limit on that line.
  not_straight,
  wrong_size,  ///< synchronize(): the two spans differ in size
};

/// Returns one sentence that explains a status to a user.
const char* explain(MoveStatus status) noexcept;

/// A move, if one exists.
struct [[nodiscard]] MoveResult {
  MoveStatus status = MoveStatus::ok;  ///< ok, or why there is no move
  /// The move. If the status is not ok, it has no phases and rests at the position of the start.
  Profile profile = {};

  /// True if the move exists.
  explicit operator bool() const noexcept { return status == MoveStatus::ok; }
  /// Returns the move. Throws InputError, with the sentence of explain(), if there is none:
  ///
  ///     const Trajectory curve = move_to({}, {.position = 50}, within(10, 20)).value().curve();
  [[nodiscard]] const Profile& value() const&;
  [[nodiscard]] Profile value() &&;
};

/// Returns the time-optimal move between two states that stays within the bounds.
///
///     const Bounds axis = within(2, 10, 100);                        // u/s, u/s^2, u/s^3
///     const MoveResult move = move_to({.position = 0}, {.position = 1}, axis);
///     if (!move) throw std::runtime_error(explain(move.status));
///     const Motion now = move.profile.at(0.1);
///
/// **A start outside the bounds** (for example after a limit was lowered in flight) returns inside
/// as follows. The acceleration returns at full jerk. The velocity is never higher than on the
/// fastest return that ends at its limit with zero acceleration; the axis may brake harder than on
/// that return. Once inside, the velocity stays inside. The move is the shortest of all such
/// motions.
///
/// If the fastest stop does not pass a target at rest, the move does not pass the target either,
/// and the axis does not reverse. The acceleration limit has one exception: at the start, the axis
/// is braking harder than the limit, and would pass a target at rest if it braked within the limit.
/// Then the deceleration stays above the limit, but only by the amount that the stop needs, and
/// never exceeds the deceleration at the start.
///
/// **The target** must be inside the bounds. A quantity that may step (such as the acceleration of
/// a second-order motion) steps to its target value at the end.
///
/// **Accuracy.** The duration is the true minimum, to rounding. The move ends exactly at `to`.
/// Results do not depend on the unit.
///
/// **Position limits.** If a position limit excludes the shortest motion, the axis first stops
/// inside the limits, as near as possible to the end of its fastest stop. Such a move stays within
/// the limits, but is not always the shortest.
///
/// Does not allocate or throw. Derivation: docs/generators/move.md.
MoveResult move_to(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

/// Returns a move with exactly this duration (s, >= 0). Of the possible moves, the function prefers
/// the one with the lowest velocity, then the one with the lowest accelerations.
MoveResult move_to(const MotionState& from, const MotionState& to, const Bounds& bounds,
                   double duration) noexcept;

/// The possible durations of a move between two states: every duration >= `minimum`, except those
/// in the blocked intervals. Blocked intervals are open and ascending. They exist only if the axis
/// moves at one of the ends.
struct Durations {
  struct Interval {
    double from = 0;  ///< s
    double to = 0;    ///< s
  };
  MoveStatus status = MoveStatus::ok;  ///< not ok: there is no move
  double minimum = 0;                  ///< s
  std::array<Interval, 2> blocked{};   ///< s; the first `count` are used
  std::size_t count = 0;               ///< number of blocked intervals

  /// True if a move of this duration (s) exists, to 1e-12 of it. Requires the status ok.
  [[nodiscard]] bool allows(double duration) const noexcept;
  /// Returns the least possible duration that is not below the given one, s. Requires the status
  /// ok.
  [[nodiscard]] double at_least(double duration) const noexcept;
};
/// Returns the possible durations of move_to(from, to, bounds).
Durations durations(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

/// Returns the fastest change to a velocity (u/s), at any position (PLCopen MC_MoveVelocity). The
/// move ends with the given acceleration (u/s^2). A start outside the bounds returns inside as in
/// move_to().
MoveResult move_velocity(const MotionState& from, double velocity, const Bounds& bounds,
                         double acceleration = 0) noexcept;

/// Returns the fastest stop (PLCopen MC_Stop, MC_Halt).
inline MoveResult stop(const MotionState& from, const Bounds& bounds) noexcept {
  return move_velocity(from, 0, bounds);
}

}  // namespace jounce
