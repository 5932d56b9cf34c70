// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/profiles/sequences/synchronize.hpp"

#include "profiles/src/solver/solver.hpp"

namespace jounce::profiles_detail {

// Every goal is a move between two states in its own coordinates:
//
//   state     the axis as it is
//   velocity  one derivative lower: the velocity takes the place of the position, the acceleration
//             the place of the velocity, the jerk the place of the acceleration
//   moving    seen from the target, which rests there: velocities less by its own
//
// The phases of a motion are the same in all of them, except for the velocities of first order.

/// The task of an axis as a move between two states, in the coordinates of its goal.
AxisMove posed(const AxisMove& axis) noexcept;
/// Converts a solution in these coordinates to the motion of the axis, `out`. Returns
/// position_limit if it leaves the position limits of the axis; `out` is set in this case, too.
MoveStatus answered(const AxisMove& axis, const Profile& solved, Profile& out) noexcept;

/// The solutions for one axis and its goal. The AxisMove must outlive the object.
class AxisTask {
 public:
  explicit AxisTask(const AxisMove& axis) noexcept : axis_(axis) {
    if (axis.goal != MoveGoal::state)
      posed_ = posed(axis);
    else if (!axis.under_way)
      form_ = form(axis.from, axis.to, axis.bounds);
    if (form_ == Form::point_to_point) inside_.emplace(axis.from, axis.to, axis.bounds);
  }

  /// All functions below require the status `ok`.
  [[nodiscard]] MoveStatus status() const noexcept;
  [[nodiscard]] Durations durations() const noexcept;
  MoveStatus shortest(Profile& out) const noexcept;
  /// True for a usual task of third order; it has a shortest motion.
  [[nodiscard]] bool is_usual() const noexcept {
    return form_ == Form::point_to_point || form_ == Form::rest_to_rest || form_ == Form::even_rest;
  }
  /// Estimated duration of the shortest motion of a usual task, s.
  [[nodiscard]] double about() const noexcept;
  /// Computes the motion of a usual task that lasts t, if it has a cruise; t is then longer than
  /// the shortest duration. Otherwise returns false, mostly because t is shorter.
  bool cruises(double t, Profile& out) const noexcept;
  /// Returns `blocked` if no motion lasts t.
  MoveStatus lasting(double t, Profile& out) const noexcept;

 private:
  [[nodiscard]] bool steps() const noexcept;
  void begin(Profile& out) const noexcept;
  [[nodiscard]] Solver solver() const noexcept;
  MoveStatus answer(MoveStatus solved, Profile& out) const noexcept;

  const AxisMove& axis_;
  Form form_ = Form::any;
  std::optional<PointToPoint> inside_;  ///< for Form::point_to_point only
  std::optional<AxisMove> posed_;       ///< for all goals except a state
};

}  // namespace jounce::profiles_detail
