// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "jounce/profiles/moves/move.hpp"

#include "profiles/src/solver/brake.hpp"
#include "profiles/src/solver/point_to_point.hpp"

namespace jounce::profiles_detail {

/// The highest order of derivative that is limited: 3, 2 or 1.
inline int order_of(const Bounds& b) {
  if (std::isfinite(b.jerk_max)) return 3;
  return std::isfinite(b.acceleration_max) ? 2 : 1;
}

inline bool limits_position(const Bounds& b) {
  return b.position_min > -Bounds::none || b.position_max < Bounds::none;
}

/// Returns ok if states and bounds are valid; otherwise the reason.
MoveStatus status_of(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

/// The usual tasks: valid, without position limits. Only `outside` needs a Solver.
enum class Form : std::uint8_t {
  any,      ///< any other task, or an invalid one: status_of() returns the reason
  outside,  ///< third order, with the start outside the bounds
  /// From rest to rest, with the same limits of acceleration and jerk in both directions.
  even_rest,
  rest_to_rest,
  point_to_point,
  second_order,
};
Form form(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

/// Computes the shortest motion of such a task. Returns false if a Solver is needed: for `any` and
/// `outside`, and for a motion from rest to rest without a closed form.
bool shortest(Form form, const MotionState& from, const MotionState& to, const Bounds& bounds,
              Profile& out) noexcept;

/// One move with valid input. Combines the beginning that all motions from a start outside the
/// bounds share, the solver for the order, and the position limits.
class Solver {
 public:
  /// `keeps_braking`: true if the present braking may be kept for the target.
  Solver(const MotionState& from, const MotionState& to, const Bounds& bounds,
         bool keeps_braking = true) noexcept;

  /// The possible durations, without position limits.
  [[nodiscard]] Durations durations() const noexcept;
  [[nodiscard]] double minimum() const noexcept;

  MoveStatus shortest(Profile& out) const noexcept;
  /// Returns `blocked` if the duration, which must be >= minimum(), is blocked.
  MoveStatus lasting(double t, Profile& out) const noexcept;

 private:
  [[nodiscard]] MotionState begin(Profile& profile) const noexcept;
  [[nodiscard]] Profile begun() const noexcept;
  [[nodiscard]] Solver with_all_braking() const noexcept;
  void straight(double t, Profile& out) const noexcept;
  [[nodiscard]] bool by_way_of_rest(Profile& out) const noexcept;
  void look_on_the_way_out() noexcept;
  [[nodiscard]] PointToPoint on_the_way_out() const noexcept { return {leaving_, to_, bounds_}; }
  [[nodiscard]] Profile led_out() const noexcept;
  [[nodiscard]] Durations durations_inside() const noexcept;
  [[nodiscard]] double minimum_inside() const noexcept;
  [[nodiscard]] bool rests() const noexcept;
  MoveStatus checked(Profile& out) const noexcept;

  int order_;
  Bounds bounds_;
  MotionState start_, to_;  ///< without the components that the order does not use
  MotionState asked_;       ///< the target as given
  MotionState inside_;      ///< the end of the common beginning
  double before_ = 0;       ///< s, duration of the common beginning
  double hold_ = 0;         ///< s, part of it in which the initial acceleration is held
  bool extended_ = false;   ///< true: the present braking extends the bounds
  /// True: the start leaves the velocity limits, but reaches a target that also leaves them before
  /// it is outside.
  bool meets_ = false;
  MotionState leaving_;  ///< the state from which this motion begins
};

/// The fastest change to a velocity and an acceleration.
MoveStatus to_velocity(const MotionState& from, double velocity, double acceleration,
                       const Bounds& bounds, Profile& out) noexcept;

}  // namespace jounce::profiles_detail
