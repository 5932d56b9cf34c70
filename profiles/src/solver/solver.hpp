// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "jounce/profiles/moves/move.hpp"

#include "profiles/src/solver/brake.hpp"
#include "profiles/src/solver/point_to_point.hpp"

namespace jounce::profiles_detail {

/// The highest derivative that is limited: 3, 2 or 1.
inline int order_of(const Bounds& b) {
  if (std::isfinite(b.jerk_max)) return 3;
  return std::isfinite(b.acceleration_max) ? 2 : 1;
}

/// True if states and bounds make a sound question.
MoveStatus status_of(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

/// The usual questions: sound, without position limits. All but `outside` need no Solver.
enum class Form : std::uint8_t {
  any,        ///< another question, or one that is not sound: status_of() gives the reason
  outside,    ///< third order, the start outside the bounds
  even_rest,  ///< from rest to rest, acceleration and jerk with the same limits both ways
  rest_to_rest,
  point_to_point,
  second_order,
};
Form form(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

/// The shortest motion of such a question; false where a Solver is needed: for `any` and `outside`, and for a
/// rest to rest without a closed form.
bool shortest(Form form, const MotionState& from, const MotionState& to, const Bounds& bounds,
              Profile& out) noexcept;

/// One move whose input is sound: the beginning that all motions from a start outside the bounds share,
/// then whichever solver the order asks for, then the position limits.
class Solver {
 public:
  /// `keeps_braking`: true if braking under way may be kept for the target.
  Solver(const MotionState& from, const MotionState& to, const Bounds& bounds,
         bool keeps_braking = true) noexcept;

  /// Without position limits.
  [[nodiscard]] Durations durations() const noexcept;
  [[nodiscard]] double minimum() const noexcept;

  MoveStatus shortest(Profile& out) const noexcept;
  /// `blocked` for a duration >= minimum() that is.
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
  MotionState start_, to_;  ///< without what is not part of the order's state
  MotionState asked_;       ///< the target as it was given
  MotionState inside_;      ///< the end of the shared beginning
  double before_ = 0;       ///< s, its duration
  double hold_ = 0;         ///< s, in which it holds the start's acceleration
  bool extended_ = false;   ///< the bounds, by braking under way
  /// A start that runs out of the velocity limits meets a target that does so, too, before it is out.
  bool meets_ = false;
  MotionState leaving_;  ///< from where on
};

/// The fastest change to a velocity and acceleration.
MoveStatus to_velocity(const MotionState& from, double velocity, double acceleration,
                       const Bounds& bounds, Profile& out) noexcept;

}  // namespace jounce::profiles_detail
