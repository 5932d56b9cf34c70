// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/sequences/synchronize.hpp"

namespace jounce::profiles_detail {

/// One axis of an OnlineGenerator: its settings and its present motion. docs/generators/online.md
/// derives in which cases the axis continues its present motion.
class OnlineAxis {
 public:
  // Settings, as in OnlineGenerator.
  MoveStatus set_state(const MotionState& state) noexcept;
  MoveStatus set_target(MoveGoal goal, const MotionState& target) noexcept;
  MoveStatus set_bounds(const Bounds& bounds) noexcept;
  void set_enabled(bool enabled) noexcept;
  void set_tolerance(double position, double velocity) noexcept;

  // Results, as in OnlineGenerator.
  [[nodiscard]] const Motion& now() const noexcept { return now_; }
  [[nodiscard]] const Bounds& in_force() const noexcept { return in_force_; }
  [[nodiscard]] MoveStatus status() const noexcept {
    if (!bounded_ && has_goal()) return MoveStatus::invalid_bounds;
    return bent_ && !ended() ? MoveStatus::not_straight : status_;
  }
  [[nodiscard]] bool arrived() const noexcept;
  [[nodiscard]] double remaining() const noexcept { return ended() ? 0 : duration_ - elapsed_; }

  // Functions for a plan of several axes.
  /// Compares the present motion with the settings. True: a new plan is needed.
  bool look() noexcept { return stale_ = is_stale(); }
  [[nodiscard]] bool stale() const noexcept { return stale_; }  ///< result of the last look()
  /// True if the axis must stop: it is disabled, or a limit of 0 forbids its motion.
  [[nodiscard]] bool must_stop() const noexcept;
  /// True if the axis must stop because of a limit of 0, and is not at its goal.
  [[nodiscard]] bool is_held() const noexcept {
    return bounded_ && enabled_ && must_stop() && !arrived();
  }
  /// True if the axis has not reached its goal, or needs a new plan.
  [[nodiscard]] bool takes_part() const noexcept {
    return bounded_ && status_ == MoveStatus::ok && !must_stop() && (stale_ || !ended());
  }
  /// Returns the axis' part of a common motion, from its present state, with the bounds that the
  /// rule for lowered limits gives (docs/generators/online.md). `widened` selects the wider bounds
  /// of that rule, if it has any.
  [[nodiscard]] AxisMove move(bool widened) const noexcept;
  [[nodiscard]] bool can_widen() const noexcept;  ///< true if the wider bounds differ
  /// Rest of the present motion.
  [[nodiscard]] Profile rest_of_plan() const noexcept { return plan_.after(elapsed_); }
  /// True if the axis may execute the plan. It may not if the plan moves in a forbidden direction.
  [[nodiscard]] bool permits(const Profile& plan) const noexcept;
  void go(const AxisMove& move, const Profile& plan) noexcept;  ///< executes the plan
  /// True if the present motion still leads to the goal, so that only its bounds have changed.
  [[nodiscard]] bool is_on_its_way() const noexcept {
    return purpose_ == Purpose::goal && is_aimed();
  }
  /// Marks that the present motion leaves the requested straight line.
  void bend() noexcept { bent_ = true; }

  /// Reacts to a goal that cannot be reached, for the given reason. refuse(): the present motion
  /// continues if it stays within the bounds; otherwise the axis stops. halt(): the axis stops.
  /// reconsider(): requests a new plan for an axis that was refused.
  void refuse(MoveStatus why) noexcept;
  void halt(MoveStatus why) noexcept;
  void reconsider() noexcept;
  [[nodiscard]] bool halts() const noexcept { return halts_; }   ///< true if a stop must be planned
  [[nodiscard]] AxisMove stopping(bool widened) const noexcept;  ///< the stop, as a move
  void stop(const AxisMove& move, const Profile& plan) noexcept;  ///< executes a stop

  /// True if after the next step of dt (s) the axis could no longer stop inside its position
  /// limits.
  [[nodiscard]] bool runs_out(double dt) const noexcept;
  void advance(double dt) noexcept;  ///< advances the motion by dt, s

 private:
  enum class Purpose : std::uint8_t { goal, stop };

  [[nodiscard]] bool has_goal() const noexcept {
    return goal_ != MoveGoal::velocity || target_.velocity != 0;
  }
  [[nodiscard]] bool is_stale() noexcept;
  [[nodiscard]] bool ended() const noexcept { return elapsed_ >= duration_; }
  [[nodiscard]] MotionState state() const noexcept { return state_of(now_); }
  [[nodiscard]] MotionState target_now() const noexcept;
  [[nodiscard]] bool is_aimed() const noexcept;
  [[nodiscard]] bool fits_bounds() noexcept;
  [[nodiscard]] bool may_narrow() const noexcept;
  [[nodiscard]] AxisMove towards_goal(const Bounds& bounds) const noexcept;
  [[nodiscard]] Bounds wider(const Bounds& bounds) const noexcept;
  [[nodiscard]] Motion at(double elapsed) const noexcept;
  void follow(const AxisMove& move, const Profile& plan, Purpose purpose) noexcept;

  // Settings.
  MotionState target_;
  double age_ = 0;  ///< time since the target was set, s
  Bounds bounds_;
  double position_tolerance_ = 0;
  double velocity_tolerance_ = 0;
  MoveGoal goal_ = MoveGoal::velocity;
  bool bounded_ = false;
  bool enabled_ = true;
  /// True if a setting changed after the present motion was planned or last found to fit.
  bool changed_ = false;
  bool stale_ = false;
  bool halts_ = false;
  bool again_ = false;  ///< plan again at rest: the states may then be on one line

  // Present motion.
  Profile plan_;
  double duration_ = 0;
  double elapsed_ = 0;
  MotionState aim_;  ///< the target of the plan, as it was at the plan's beginning
  Bounds asked_;     ///< the bounds that were set when the motion was planned or last found to fit
  Bounds in_force_;  ///< the bounds of the plan
  Motion now_;
  MoveGoal aim_goal_ = MoveGoal::velocity;
  Purpose purpose_ = Purpose::stop;
  bool bent_ = false;  ///< the motion leaves the straight line
  /// A target with a nonzero velocity was reached: the axis continues at this velocity.
  bool passed_ = false;
  MoveStatus status_ = MoveStatus::ok;
};

/// Strictness of detours(): `strictly` for a plan that another plan could replace, `mildly` for the
/// last possible plan.
enum class Judged : std::uint8_t { strictly, mildly };
/// True if a motion towards a goal passes the goal or reverses by more than rounding. For a
/// velocity goal this applies to the velocity.
bool detours(const AxisMove& move, const Profile& plan, Judged judged) noexcept;

}  // namespace jounce::profiles_detail
