// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/move_goal.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/motion/setpoint_check.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

/// Reason why no move may have this target.
std::optional<Refusal> forbidden(double target, double from, const MoveRules& rules) {
  const auto& [low, high, v, a, j] = rules.config.limits;
  if (low && target < *low) return Refusal{Cause::position_limit, target, *low};
  if (high && target > *high) return Refusal{Cause::position_limit, target, *high};
  const bool blocked =
      (rules.positive_switch && target > from) || (rules.negative_switch && target < from);
  return blocked ? std::optional(Refusal{Cause::direction_blocked, target, from}) : std::nullopt;
}

std::optional<Refusal> by_distance(double distance, MoveDynamics dynamics, double start,
                                   double from, const MoveRules& rules, Goal& goal) {
  if (!std::isfinite(distance)) return Refusal{Cause::no_value, distance, 0};
  if (const auto no = fill(dynamics, rules.config)) return no;
  goal = {Goal::Kind::position, start + distance, dynamics};
  return forbidden(goal.value, from, rules);
}

}  // namespace

std::optional<Refusal> goal_of(const command::MoveAbsolute& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept {
  if (!std::isfinite(what.position)) return Refusal{Cause::no_value, what.position, 0};
  MoveDynamics dynamics = what.dynamics;
  if (const auto no = fill(dynamics, rules.config)) return no;
  const auto target = target_of(what.position, what.direction, from, dynamics, rules.config);
  if (!target) return Refusal{Cause::no_such_move, what.position, from.position, 0};
  goal = {Goal::Kind::position, *target, dynamics};
  return forbidden(*target, from.position, rules);
}

std::optional<Refusal> goal_of(const command::MoveRelative& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept {
  return by_distance(what.distance, what.dynamics, from.position, from.position, rules, goal);
}

std::optional<Refusal> goal_of(const command::MoveAdditive& what, double start,
                               const MotionState& from, const MoveRules& rules,
                               Goal& goal) noexcept {
  return by_distance(what.distance, what.dynamics, start, from.position, rules, goal);
}

/// A velocity of 0: to rest.
std::optional<Refusal> goal_of(const command::MoveVelocity& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept {
  const double velocity = what.velocity;
  if (!std::isfinite(velocity)) return Refusal{Cause::no_value, velocity, 0};
  MoveDynamics dynamics = what.dynamics;
  dynamics.velocity = as_configured;
  if (const auto no = fill(dynamics, rules.config)) return no;
  const double most = dynamics.velocity;
  if (std::abs(velocity) > most) return Refusal{Cause::velocity_limit, velocity, most};
  const bool blocked =
      (velocity > 0 && rules.positive_switch) || (velocity < 0 && rules.negative_switch);
  if (blocked) return Refusal{Cause::direction_blocked, velocity, 0};
  const Limits& limits = rules.config.limits;
  const auto limit = velocity > 0   ? limits.position_max
                     : velocity < 0 ? limits.position_min
                                    : std::nullopt;
  const double near = rounded_input * most * seconds(rules.config.period);
  if (limit && (*limit - from.position) * std::copysign(1.0, velocity) < near)
    return Refusal{Cause::position_limit, from.position, *limit};
  dynamics.velocity = std::abs(velocity);
  goal = {Goal::Kind::velocity, velocity, dynamics};
  return std::nullopt;
}

std::optional<Refusal> goal_of(const BufferedMove& what, const MotionState& from,
                               const MoveRules& rules, Goal& goal) noexcept {
  return std::visit([&](const auto& move) { return goal_of(move, from, rules, goal); }, what);
}

std::optional<MotionState> end_of(const WaitingMoves& moves, std::optional<MotionState> from,
                                  const MoveRules& rules) noexcept {
  for (const BufferedMove& move : moves) {
    Goal goal;
    if (!from || goal_of(move, *from, rules, goal) || goal.kind != Goal::Kind::position)
      return std::nullopt;
    from = MotionState{goal.value, 0, 0};
  }
  return from;
}

std::optional<Goal> stop_at_limit(Cause limit, const MotionState& from, double dt,
                                  const AxisConfig& config) noexcept {
  const auto& [low, high, v_most, a_most, j_most] = config.limits;
  const bool up = limit == Cause::positive_soft_limit;
  const auto end = up ? high : low;
  const Stop stop = gentlest_stop(from, config);
  if (!end || (up ? from.position > *end : from.position < *end) || stop == Stop::none)
    return std::nullopt;
  const double a = stop == Stop::soft ? config.limit_acceleration : config.stop_acceleration;
  const double j = j_most ? config.stop_jerk : Bounds::none;
  const double own = std::abs(from.velocity) + from.acceleration * from.acceleration / (2 * j);
  // From rest, the velocity gained in this tick: so an axis that has just begun also reaches the
  // end.
  const double velocity = std::min(std::max(own, a * dt), *v_most);
  const MoveDynamics dynamics{velocity, a, a, j};
  const auto rest = plan(from, {Goal::Kind::rest, 0, dynamics}, 1, config);
  const double near = 10 * velocity * dt;
  if (!rest || std::abs(*end - rest->end().position) > near) return std::nullopt;
  return Goal{Goal::Kind::position, *end, dynamics};
}

}  // namespace jounce
