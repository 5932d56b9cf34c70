// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/profiles/sequences/synchronise.hpp"

#include "profiles/src/solver/solver.hpp"

namespace jounce::profiles_detail {

// Every goal is a move between two states in its own coordinates:
//
//   state     the axis as it is
//   velocity  one derivative lower: the velocity takes the place of the position, the acceleration
//             that of the velocity, the jerk that of the acceleration
//   moving    seen from the target, which rests there: velocities less by its own
//
// The phases of a motion are the same in all of them, except for the velocities of first order.

/// The goal of an axis as a move between two states, in those coordinates.
AxisMove posed(const AxisMove& axis) noexcept;
/// A solution in those coordinates as the motion of the axis. `position_limit` where it leaves the
/// axis's position limits; `out` is the motion in that case, too.
MoveStatus answered(const AxisMove& axis, const Profile& solved, Profile& out) noexcept;

/// The questions about one axis and its goal. The AxisMove must outlive it.
class AxisTask {
 public:
  explicit AxisTask(const AxisMove& axis) noexcept : axis_(axis) {
    if (axis.goal != MoveGoal::state)
      posed_ = posed(axis);
    else if (!axis.under_way)
      form_ = form(axis.from, axis.to, axis.bounds);
    if (form_ == Form::point_to_point) inside_.emplace(axis.from, axis.to, axis.bounds);
  }

  /// The questions below need `ok`.
  [[nodiscard]] MoveStatus status() const noexcept;
  [[nodiscard]] Durations durations() const noexcept;
  MoveStatus shortest(Profile& out) const noexcept;
  /// A usual question of third order: it has a shortest motion.
  [[nodiscard]] bool is_usual() const noexcept {
    return form_ == Form::point_to_point || form_ == Form::rest_to_rest || form_ == Form::even_rest;
  }
  /// About how long the shortest motion of such a question takes, s.
  [[nodiscard]] double about() const noexcept;
  /// The motion of such a question that lasts t, where it cruises: then t is longer than the shortest.
  /// Otherwise false, most often since t is shorter.
  bool cruises(double t, Profile& out) const noexcept;
  /// `blocked` where no motion lasts t.
  MoveStatus lasting(double t, Profile& out) const noexcept;

 private:
  [[nodiscard]] bool steps() const noexcept;
  void begin(Profile& out) const noexcept;
  [[nodiscard]] Solver solver() const noexcept;
  MoveStatus answer(MoveStatus solved, Profile& out) const noexcept;

  const AxisMove& axis_;
  Form form_ = Form::any;
  std::optional<PointToPoint> inside_;  ///< only for Form::point_to_point
  std::optional<AxisMove> posed_;       ///< for goals other than a state
};

}  // namespace jounce::profiles_detail
