// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/move_plan.hpp"
#include "jounce/axis/waiting_moves.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// The limits of an axis for the targets of its moves.
struct MoveRules {
  const AxisConfig& config;
  bool positive_switch = false;  ///< limit switch active
  bool negative_switch = false;
};

/// Sets the goal of a move that begins in the state `from`, or returns the reason to reject it: a
/// value that is not finite, a target outside the range, a direction in which a limit switch is
/// active, dynamics beyond their limits.
std::optional<Refusal> goal_of(const command::MoveAbsolute& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept;
std::optional<Refusal> goal_of(const command::MoveRelative& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept;
std::optional<Refusal> goal_of(const command::MoveVelocity& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept;
std::optional<Refusal> goal_of(const BufferedMove& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept;
/// `start`: u, the position from which the distance counts.
std::optional<Refusal> goal_of(const command::MoveAdditive& what, double start,
                               const MotionState& from, const MoveRules& rules,
                               Goal& goal) noexcept;

/// The state at rest after the last of these moves, the first of which begins at rest in `from`.
/// nullopt: a move has no target, or may not have it.
std::optional<MotionState> end_of(const WaitingMoves& moves, std::optional<MotionState> from,
                                  const MoveRules& rules) noexcept;

/// The goal that brings an axis to rest at the end of its range, with the gentlest stop that the
/// state `from` still has. `limit`: positive_soft_limit or negative_soft_limit. `dt`: s until the
/// next setpoint. nullopt: it is outside, or does not move towards that end.
std::optional<Goal> stop_at_limit(Cause limit, const MotionState& from, double dt,
                                  const AxisConfig& config) noexcept;

}  // namespace jounce
