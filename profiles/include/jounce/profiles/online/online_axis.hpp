// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/sequences/synchronise.hpp"

namespace jounce::profiles_detail {

/// One axis of an OnlineGenerator: its orders, and the motion under way. docs/generators/online.md
/// derives when that motion is kept.
class OnlineAxis {
 public:
  // Orders.
  MoveStatus set_state(const MotionState& state) noexcept;
  MoveStatus set_target(MoveGoal goal, const MotionState& target) noexcept;
  MoveStatus set_bounds(const Bounds& bounds) noexcept;
  void set_enabled(bool enabled) noexcept;
  void set_tolerance(double position, double velocity) noexcept;

  // Answers.
  [[nodiscard]] const Motion& now() const noexcept { return now_; }
  [[nodiscard]] const Bounds& in_force() const noexcept { return in_force_; }
  [[nodiscard]] MoveStatus status() const noexcept {
    if (!bounded_ && has_goal()) return MoveStatus::invalid_bounds;
    return bent_ && !ended() ? MoveStatus::not_straight : status_;
  }
  [[nodiscard]] bool arrived() const noexcept;
  [[nodiscard]] double remaining() const noexcept { return ended() ? 0 : duration_ - elapsed_; }

  // For a plan of several axes.
  /// Compares the motion under way with the orders. True: it must be planned again.
  bool look() noexcept { return stale_ = is_stale(); }
  [[nodiscard]] bool stale() const noexcept { return stale_; }
  [[nodiscard]] bool must_stop() const noexcept;
  /// Held by a limit of 0, away from its goal.
  [[nodiscard]] bool is_held() const noexcept {
    return bounded_ && enabled_ && must_stop() && !arrived();
  }
  /// True if the axis has still a way to go to its goal, or must be planned for.
  [[nodiscard]] bool takes_part() const noexcept {
    return bounded_ && status_ == MoveStatus::ok && !must_stop() && (stale_ || !ended());
  }
  /// Its part in a common motion, from its state now, under the bounds that the rule for lowered limits
  /// gives; with `widened` under the wider ones, if there are such.
  [[nodiscard]] AxisMove move(bool widened) const noexcept;
  [[nodiscard]] bool can_widen() const noexcept;
  [[nodiscard]] Profile rest_of_plan() const noexcept { return plan_.after(elapsed_); }
  /// True if the axis may follow a plan: one direction may be forbidden to it.
  [[nodiscard]] bool permits(const Profile& plan) const noexcept;
  void go(const AxisMove& move, const Profile& plan) noexcept;
  /// True if the motion under way still leads to the goal: only its bounds have changed.
  [[nodiscard]] bool is_on_its_way() const noexcept {
    return purpose_ == Purpose::goal && is_aimed();
  }
  /// The motion under way leaves the requested line.
  void bend() noexcept { bent_ = true; }

  /// There is, or may be, no motion to the goal: the motion under way continues if it keeps the
  /// bounds. Otherwise the axis must stop.
  void refuse(MoveStatus why) noexcept;
  void halt(MoveStatus why) noexcept;
  void reconsider() noexcept;
  [[nodiscard]] bool halts() const noexcept { return halts_; }
  [[nodiscard]] AxisMove stopping(bool widened) const noexcept;
  void stop(const AxisMove& move, const Profile& plan) noexcept;

  /// True if the axis could no longer stop inside its position limits after the next step of dt.
  [[nodiscard]] bool runs_out(double dt) const noexcept;
  void advance(double dt) noexcept;

 private:
  enum class Purpose : std::uint8_t { goal, stop };

  [[nodiscard]] bool has_goal() const noexcept {
    return goal_ != MoveGoal::velocity || target_.velocity != 0;
  }
  [[nodiscard]] bool is_stale() noexcept;
  [[nodiscard]] bool ended() const noexcept { return elapsed_ >= duration_; }
  [[nodiscard]] MotionState state() const noexcept {
    return {now_.position, now_.velocity, now_.acceleration};
  }
  [[nodiscard]] MotionState target_now() const noexcept;
  [[nodiscard]] bool is_aimed() const noexcept;
  [[nodiscard]] bool fits_bounds() noexcept;
  [[nodiscard]] bool may_narrow() const noexcept;
  [[nodiscard]] AxisMove towards_goal(const Bounds& bounds) const noexcept;
  [[nodiscard]] Bounds wider(const Bounds& bounds) const noexcept;
  [[nodiscard]] Motion at(double elapsed) const noexcept;
  void follow(const AxisMove& move, const Profile& plan, Purpose purpose) noexcept;

  // The orders.
  MotionState target_;
  double age_ = 0;  ///< since the target was set, s
  Bounds bounds_;
  double position_tolerance_ = 0;
  double velocity_tolerance_ = 0;
  MoveGoal goal_ = MoveGoal::velocity;
  bool bounded_ = false;
  bool enabled_ = true;
  bool changed_ = false;  ///< since the motion under way was planned or found to fit
  bool stale_ = false;
  bool halts_ = false;
  bool again_ = false;  ///< at rest the states may lie on a line that they did not in motion

  // The motion under way.
  Profile plan_;
  double duration_ = 0;
  double elapsed_ = 0;
  MotionState aim_;  ///< the target that the plan leads to, as it was when the plan began
  Bounds asked_;     ///< the bounds that were set when it was planned or last found to fit
  Bounds in_force_;  ///< those that it was planned under
  Motion now_;
  MoveGoal aim_goal_ = MoveGoal::velocity;
  Purpose purpose_ = Purpose::stop;
  bool bent_ = false;    ///< leaves the line
  bool passed_ = false;  ///< a state that is not at rest has been reached: on at its velocity
  MoveStatus status_ = MoveStatus::ok;
};

/// Strictness of the test of a motion: strict for a candidate, mild for the last resort.
enum class Judged : std::uint8_t { strictly, mildly };
/// True if a motion towards a goal passes it or reverses on its way (for a velocity goal: its
/// velocity does), by more than rounding.
bool detours(const AxisMove& move, const Profile& plan, Judged judged) noexcept;

}  // namespace jounce::profiles_detail
