// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/profiles/curve/modulo.hpp"
#include "jounce/profiles/moves/profile.hpp"

#include "axis/src/motion/move_plan.hpp"

namespace jounce {

/// A setpoint, and the tick in which it was output. u is the unit of the axis.
struct TimedState {
  MotionState state;      ///< u, u/s, u/s^2
  std::int64_t tick = 0;  ///< tick of the output
};

/// Plays a move that the axis plans itself. The goal and the plan of the player always belong
/// together: if a new move cannot be planned, both stay unchanged.
///
///     MovePlayer player(config.period);
///     if (!player.begin({last, tick}, goal, 1, config)) ...       // no such move exists
///     const Jet next = player.at(tick);                           // u, u/s, u/s^2, u/s^3
///     if (player.is_over(tick)) ...  // the axis continues at its velocity
///
/// A MovePlayer has a fixed size, and copies are independent. It does not allocate or throw.
class MovePlayer {
 public:
  /// `period`: duration of a tick, ns.
  explicit MovePlayer(std::int64_t period) noexcept : period_(period) {}

  /// Plans the move to the goal at `factor` times its velocity, and begins the move in the tick
  /// `from.tick`. `ahead` is the part of the move that has passed at this tick, s. Returns false if
  /// no such move exists.
  bool begin(const TimedState& from, const Goal& goal, double factor, const AxisConfig& config,
             double ahead = 0) noexcept;
  /// Plans a move to rest with the dynamics of the goal. A later begin() can resume the goal.
  /// Returns false if no such move exists.
  bool pause(const TimedState& from, const Goal& goal, const AxisConfig& config) noexcept;

  /// The goal of the move.
  [[nodiscard]] const Goal& goal() const noexcept { return goal_; }
  /// The planned motion.
  [[nodiscard]] const Profile& plan() const noexcept { return plan_; }
  /// True if the move passes its target at a nonzero velocity.
  [[nodiscard]] bool passes() const noexcept { return goal_.through != 0; }

  /// Returns the state in this tick: u, u/s, u/s^2, u/s^3.
  [[nodiscard]] Jet at(std::int64_t tick) const noexcept;
  /// Returns the time since the end of the move, s; negative before the end.
  [[nodiscard]] double beyond(std::int64_t tick) const noexcept;
  /// True if the move has ended.
  [[nodiscard]] bool is_over(std::int64_t tick) const noexcept { return beyond(tick) >= 0; }

  /// Returns the time since the move passed this position, s, if it passed it after the tick `from`
  /// and up to the tick `to`, in the given direction (shortest: in either). Otherwise returns
  /// nullopt. Requires that the move does not reverse between the ticks.
  [[nodiscard]] std::optional<double> passed(double position, Direction direction,
                                             std::int64_t from, std::int64_t to) const noexcept;
  /// Returns the state of the move `ago` s before the tick.
  [[nodiscard]] MotionState state(std::int64_t tick, double ago) const noexcept;

  /// Returns the greatest magnitudes of the move, and of every move that is planned again with a
  /// factor up to max(factor, 1).
  [[nodiscard]] Peaks peaks_up_to(double factor) const noexcept;

 private:
  bool adopt(const std::optional<Profile>& profile, const TimedState& from, const Goal& goal,
             double ahead) noexcept;
  [[nodiscard]] double time(std::int64_t tick) const noexcept;
  [[nodiscard]] double position(double t) const noexcept;

  std::int64_t period_;
  Goal goal_;
  Profile plan_;
  std::int64_t origin_ = 0;  // tick of the start
  double ahead_ = 0;         // part of the move that was over in that tick, s
};

}  // namespace jounce
