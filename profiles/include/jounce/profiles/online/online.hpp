// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "jounce/profiles/online/online_group.hpp"

namespace jounce {

/// Setpoints for N axes, one call per cycle. Targets, bounds and everything else may change at any
/// time; a motion is planned only if the one under way no longer fits.
///
///     OnlineGenerator<2> xy(Sync::time);
///     xy.set_bounds(0, within(2, 10, 100));          // u/s, u/s^2, u/s^3
///     xy.set_bounds(1, within(1, 5, 50));
///     xy.set_target(0, {.position = 1});             // every cycle, if that is easier
///     xy.set_target(1, {.position = -0.5});
///     while (!xy.step(0.001).arrived) output(xy[0].position, xy[1].position);
///
/// An axis begins at rest at 0 and takes part once it has bounds. Until it has a target it comes to
/// rest. Beyond a moving target it continues at the target's velocity. Nothing allocates, locks or
/// throws. An axis index must be less than N. Invalid bounds, states and targets are rejected when
/// they are set; the previous order stays. Rules for lowered limits: docs/generators/online.md.
template <std::size_t N>
class OnlineGenerator {
 public:
  explicit OnlineGenerator(Sync sync = Sync::none) noexcept : sync_(sync) {}

  /// State of an axis; for the beginning, and for an axis that something else has moved. The next
  /// setpoint steps there.
  MoveStatus set_state(std::size_t axis, const MotionState& state) noexcept {
    return axes_[axis].set_state(state);
  }
  /// Goal of the axis; MoveGoal::moving: the target at the beginning of the next step.
  MoveStatus set_target(std::size_t axis, const MotionState& target,
                        MoveGoal goal = MoveGoal::state) noexcept {
    return axes_[axis].set_target(goal, target);
  }
  /// A velocity in u/s, wherever that is reached. One beyond the bounds counts as their limit.
  MoveStatus set_velocity(std::size_t axis, double velocity) noexcept {
    return axes_[axis].set_target(MoveGoal::velocity, {0, velocity, 0});
  }
  /// A velocity limit of 0 forbids that direction. Where both are 0, or one of acceleration or jerk is,
  /// the axis comes to rest under the limits before, and stays.
  MoveStatus set_bounds(std::size_t axis, const Bounds& bounds) noexcept {
    return axes_[axis].set_bounds(bounds);
  }
  /// An axis that is not enabled comes to rest as fast as possible; the others do not wait for it.
  void set_enabled(std::size_t axis, bool enabled) noexcept { axes_[axis].set_enabled(enabled); }
  /// Sets the greatest difference (u and u/s) between a new target and the target of the present
  /// motion that keeps the present motion. The axis then ends at most that far from the new target.
  /// 0: only rounding.
  void set_tolerance(std::size_t axis, double position, double velocity = 0) noexcept {
    axes_[axis].set_tolerance(position, velocity);
  }
  void set_sync(Sync sync) noexcept {
    regroup_ = regroup_ || sync != sync_;
    sync_ = sync;
  }
  /// Motions planned from now on last a multiple of this, s; 0: as long as they need.
  void set_grid(double grid) noexcept { grid_ = std::max(0.0, grid); }

  /// Goes on by dt >= 0, s.
  OnlineStep step(double dt) noexcept {
    const bool regroup = regroup_;
    regroup_ = false;
    return profiles_detail::OnlineGroup{axes_, moves_, next_, rests_, sync_, grid_, regroup}.step(
        dt);
  }

  /// The setpoint of an axis.
  const Motion& operator[](std::size_t axis) const noexcept { return axes_[axis].now(); }
  /// Time until the last axis is at its goal, s.
  [[nodiscard]] double remaining() const noexcept {
    double t = 0;
    for (const auto& axis : axes_) t = std::max(t, axis.remaining());
    return t;
  }
  /// Why an axis does not go to its goal, or ok.
  [[nodiscard]] MoveStatus status(std::size_t axis) const noexcept { return axes_[axis].status(); }
  /// Bounds of the present motion. Its acceleration and jerk are wider than those that were set while
  /// the axis would pass its target without them.
  [[nodiscard]] const Bounds& in_force(std::size_t axis) const noexcept {
    return axes_[axis].in_force();
  }

 private:
  std::array<profiles_detail::OnlineAxis, N> axes_{};
  std::array<AxisMove, N> moves_{};  // these three are used within a step alone
  std::array<Profile, N> next_{}, rests_{};
  double grid_ = 0;
  Sync sync_;
  bool regroup_ = false;
};

}  // namespace jounce
