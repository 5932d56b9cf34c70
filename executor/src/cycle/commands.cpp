// SPDX-License-Identifier: Apache-2.0
#include "executor/src/cycle/commands.hpp"

#include <cmath>
#include <type_traits>
#include <variant>

#include "jounce/axis/live_gear.hpp"

namespace jounce {

std::optional<AxisCommand> axis_command_of(const ClientCommand& command) {
  return std::visit(
      [](const auto& what) -> std::optional<AxisCommand> {
        if constexpr (std::is_constructible_v<AxisCommand, decltype(what)>) return what;
        return std::nullopt;
      },
      command);
}

namespace {

/// The positions of a modulo axis repeat in each turn: the gear engages at the one nearest to
/// `position`, the present position of the axis.
GearInPosSpec gear_in_pos_of(const command::GearInPos& gear, double turn, double position) {
  GearInPosSpec spec{.numerator = gear.numerator,
                     .denominator = gear.denominator,
                     .master_sync_position = gear.master_sync_position,
                     .slave_sync_position = gear.slave_sync_position,
                     .master_start_distance = gear.master_start_distance,
                     .slave_start = position,
                     .avoid_reversal = gear.avoid_reversal};
  if (turn > 0) {
    spec.slave_period = turn;
    spec.slave_sync_position = position + std::remainder(gear.slave_sync_position - position, turn);
  }
  return spec;
}

}  // namespace

std::unique_ptr<Movement> gear_of(const ClientCommand& command, std::uint64_t id,
                                  const AxisConfig& config, double position) {
  const auto given = [](double number, double otherwise) {
    return std::isnan(number) ? otherwise : number;
  };
  if (const auto* const gear = std::get_if<command::GearIn>(&command)) {
    const MoveDynamics& dynamics = gear->dynamics;
    return std::make_unique<LiveGear>(
        id, GearInSpec{.numerator = gear->numerator,
                       .denominator = gear->denominator,
                       .acceleration = given(dynamics.acceleration, *config.limits.acceleration),
                       .deceleration = given(dynamics.deceleration, 0),
                       .jerk = given(dynamics.jerk, config.limits.jerk.value_or(0))});
  }
  if (const auto* const gear = std::get_if<command::GearInPos>(&command))
    return std::make_unique<LiveGearInPos>(id, gear_in_pos_of(*gear, config.modulo, position));
  return nullptr;
}

}  // namespace jounce
