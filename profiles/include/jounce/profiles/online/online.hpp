// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "jounce/profiles/online/online_group.hpp"

namespace jounce {

/// Generator of setpoints for N axes. Call step() once in each cycle. Targets, bounds and all other
/// settings may change at any time; the generator plans a new motion only if the present one no
/// longer fits the settings. u is the unit of an axis.
///
///     OnlineGenerator<2> xy(Sync::time);
///     xy.set_bounds(0, within(2, 10, 100));          // u/s, u/s^2, u/s^3
///     xy.set_bounds(1, within(1, 5, 50));
///     xy.set_target(0, {.position = 1});             // every cycle, if that is easier
///     xy.set_target(1, {.position = -0.5});
///     while (!xy.step(0.001).arrived) output(xy[0].position, xy[1].position);
///
/// **Start.** Every axis begins at rest at position 0. An axis takes part as soon as it has bounds.
/// Without a target, it comes to rest. When an axis reaches a target with a nonzero velocity, it
/// continues at this velocity.
///
/// **Errors.** Nothing allocates, locks or throws. An axis index must be less than N. A setter
/// rejects invalid bounds, states and targets with a status that is not ok; the previous value
/// stays. Rules for lowered limits: docs/generators/online.md.
template <std::size_t N>
class OnlineGenerator {
 public:
  /// `sync`: synchronization of the axes; see Sync in synchronize.hpp.
  explicit OnlineGenerator(Sync sync = Sync::none) noexcept : sync_(sync) {}

  /// Sets the state of an axis. Call at the beginning, or after something else has moved the axis.
  /// The next setpoint continues from this state.
  MoveStatus set_state(std::size_t axis, const MotionState& state) noexcept {
    return axes_[axis].set_state(state);
  }
  /// Sets the goal of an axis. With MoveGoal::moving, `target` is the target's state at the
  /// beginning of the next step, and its acceleration counts as 0.
  MoveStatus set_target(std::size_t axis, const MotionState& target,
                        MoveGoal goal = MoveGoal::state) noexcept {
    return axes_[axis].set_target(goal, target);
  }
  /// Sets a velocity (u/s) as the goal, at any position. If the velocity exceeds a bound, the bound
  /// replaces it.
  MoveStatus set_velocity(std::size_t axis, double velocity) noexcept {
    return axes_[axis].set_target(MoveGoal::velocity, {0, velocity, 0});
  }
  /// Sets the bounds of an axis. A velocity limit of 0 is permitted: the axis then cannot move in
  /// this direction. If both velocity limits are 0, or a limit of acceleration or jerk is 0, the
  /// axis comes to rest under its previous limits and stays at rest.
  MoveStatus set_bounds(std::size_t axis, const Bounds& bounds) noexcept {
    return axes_[axis].set_bounds(bounds);
  }
  /// Enables or disables an axis. A disabled axis comes to rest as fast as possible; the other axes
  /// do not wait for it. Default: enabled.
  void set_enabled(std::size_t axis, bool enabled) noexcept { axes_[axis].set_enabled(enabled); }
  /// Sets the tolerance (u and u/s) for new targets. If a new target differs from the present one
  /// by no more than the tolerance, the present motion continues and ends within the tolerance of
  /// the new target. Default 0: targets that differ only by rounding count as equal. A negative
  /// tolerance counts as 0.
  void set_tolerance(std::size_t axis, double position, double velocity = 0) noexcept {
    axes_[axis].set_tolerance(position, velocity);
  }
  /// Sets the synchronization of the axes.
  void set_sync(Sync sync) noexcept {
    regroup_ = regroup_ || sync != sync_;
    sync_ = sync;
  }
  /// Rounds the duration of all motions planned after this call up to a multiple of `grid` (s).
  /// Default 0: any duration. A negative grid counts as 0.
  void set_grid(double grid) noexcept { grid_ = std::max(0.0, grid); }

  /// Advances all axes by dt >= 0 s, and plans motions if necessary. If dt is negative or not
  /// finite, no axis advances, and the status is `not_finite`.
  OnlineStep step(double dt) noexcept {
    const bool regroup = regroup_;
    regroup_ = false;
    return profiles_detail::OnlineGroup{axes_, moves_, next_, rests_, sync_, grid_, regroup}.step(
        dt);
  }

  /// The present setpoint of an axis: u, u/s, u/s^2, u/s^3.
  const Motion& operator[](std::size_t axis) const noexcept { return axes_[axis].now(); }
  /// Time until the present motions of all axes have ended, s.
  [[nodiscard]] double remaining() const noexcept {
    double t = 0;
    for (const auto& axis : axes_) t = std::max(t, axis.remaining());
    return t;
  }
  /// Returns the reason why an axis does not move to its goal, or ok. It is `invalid_bounds` if the
  /// axis has a target but no bounds.
  [[nodiscard]] MoveStatus status(std::size_t axis) const noexcept { return axes_[axis].status(); }
  /// Returns the bounds of the present motion. Their acceleration and jerk may be wider than those
  /// of set_bounds(), while the axis would otherwise pass its target.
  [[nodiscard]] const Bounds& in_force(std::size_t axis) const noexcept {
    return axes_[axis].in_force();
  }

 private:
  std::array<profiles_detail::OnlineAxis, N> axes_{};
  std::array<AxisMove, N> moves_{};  // these three are used only inside step()
  std::array<Profile, N> next_{}, rests_{};
  double grid_ = 0;
  Sync sync_;
  bool regroup_ = false;
};

}  // namespace jounce
