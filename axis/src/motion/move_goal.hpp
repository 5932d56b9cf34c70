// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/moves/profile.hpp"

#include "axis/src/motion/move_plan.hpp"
#include "axis/src/motion/waiting_moves.hpp"

namespace jounce {

/// The limits that apply to the target of a move: the limits of the axis, and its limit switches.
struct MoveRules {
  const AxisConfig& config;      ///< configuration of the axis
  bool positive_switch = false;  ///< true if the positive limit switch is active
  bool negative_switch = false;  ///< true if the negative limit switch is active
};

/// Sets `goal` to the goal of a move that begins in the state `from`. Returns nullopt, or the
/// reason to reject the move: a value that is not finite, a target outside the position range, a
/// direction in which a limit switch is active, or dynamics beyond the limits.
std::optional<Refusal> goal_of(const command::MoveAbsolute& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept;
std::optional<Refusal> goal_of(const command::MoveRelative& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept;
std::optional<Refusal> goal_of(const command::MoveVelocity& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept;
std::optional<Refusal> goal_of(const BufferedMove& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept;
/// Sets the goal of an additive move, like the functions above. `start` is the position from which
/// the distance counts, u.
std::optional<Refusal> goal_of(const command::MoveAdditive& what, double start,
                               const MotionState& from, const MoveRules& rules,
                               Goal& goal) noexcept;

/// Returns the state at rest after the last of these moves. The first one begins at rest in `from`.
/// Returns nullopt if `from` is missing, if a move has no target, or if a target is not permitted.
std::optional<MotionState> end_of(const WaitingMoves& moves, std::optional<MotionState> from,
                                  const MoveRules& rules) noexcept;

/// Returns the goal that brings an axis to rest at the end of its range, by the gentlest stop that
/// is still possible from the state `from`. `limit` is positive_soft_limit or negative_soft_limit.
/// `dt` is the time until the next setpoint, s. Returns nullopt if the axis is outside the range,
/// if it cannot stop inside the range, or if it would come to rest far from the end of the range
/// (farther than it moves in 10 ticks).
std::optional<Goal> stop_at_limit(Cause limit, const MotionState& from, double dt,
                                  const AxisConfig& config) noexcept;

}  // namespace jounce
