// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/start_check.hpp"

#include <cmath>
#include <tuple>

#include "jounce/cam/coupling/passing.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/motion/setpoint_check.hpp"
#include "axis/src/motion/setpoint_supervision.hpp"

namespace jounce {

Refusal begin_refusal(Cause no, const Movement& movement, const MotionState& state) noexcept {
  const bool placed = no == Cause::start_position || no == Cause::cutter_away;
  return {.cause = no,
          .value = placed ? movement.place() : state.position,
          .limit = placed ? state.position : 0};
}

std::optional<Refusal> against_switch(const Movement& path, bool positive_switch,
                                      bool negative_switch, double position) noexcept {
  const int way = path.direction();
  const bool blocked = (way > 0 && positive_switch) || (way < 0 && negative_switch);
  return blocked ? std::optional(Refusal{Cause::direction_blocked, position, 0}) : std::nullopt;
}

std::optional<Refusal> against_demand(const Movement& movement, const Moment& start,
                                      const AxisConfig& config) noexcept {
  const Peaks need = movement.demand(start);
  const auto& [low, high, v, a, j] = config.limits;
  for (const auto& [value, most, cause] : {std::tuple{need.velocity, v, Cause::velocity_limit},
                                           {need.acceleration, a, Cause::acceleration_limit},
                                           {need.jerk, j, Cause::jerk_limit}})
    if (most && !(value <= *most * (1 + profiles_detail::rounded_input)))
      return Refusal{cause, value, *most};
  return std::nullopt;
}

std::optional<Refusal> against_jump(const Movement& movement, const Moment& now,
                                    const MotionState& last, const AxisConfig& rules) noexcept {
  const auto first = movement.first_setpoint(now);
  if (!first) return std::nullopt;
  switch (check_setpoint(last, *first, {now.dt, joint_step(rules)}, rules)) {
    case Cause::none:
      break;
    case Cause::overspeed:
      return Refusal{Cause::velocity_limit, std::abs(first->velocity), *rules.limits.velocity};
    case Cause::out_of_range:
      return Refusal{Cause::position_limit, first->position, last.position};
    default:
      return Refusal{Cause::start_jump, first->velocity, last.velocity};
  }
  if (!exceeds_acceleration(*first, rules)) return std::nullopt;
  return Refusal{Cause::acceleration_limit, std::abs(first->acceleration),
                 *rules.limits.acceleration};
}

std::optional<Refusal> against_first(Cause wrong, const MotionState& first, double last_velocity,
                                     const AxisConfig& config) noexcept {
  switch (wrong) {
    case Cause::overspeed:
      return Refusal{Cause::velocity_limit, std::abs(first.velocity), *config.limits.velocity};
    case Cause::overacceleration:
      return Refusal{Cause::acceleration_limit, std::abs(first.acceleration),
                     *config.limits.acceleration};
    case Cause::jump:
      return Refusal{Cause::start_jump, first.velocity, last_velocity};
    default:
      return std::nullopt;
  }
}

std::optional<Moment> crossing(double position, const Jet& before, const Jet& after,
                               double dt) noexcept {
  const double way_before = before[0] - position;
  const double way_after = after[0] - position;
  if (!(way_before * way_after <= 0 && way_before != way_after)) return std::nullopt;
  const Sample earlier{-dt, before};
  const Sample now{0, after};
  const Sample at = way_before == 0 ? earlier : passing(earlier, now, position).value_or(now);
  return Moment{at.t, dt, at.master};
}

}  // namespace jounce
