// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/executed_command.hpp"

#include <cmath>
#include <type_traits>
#include <variant>

#include "jounce/axis/live_clutch.hpp"
#include "jounce/axis/live_combination.hpp"
#include "jounce/axis/live_gear.hpp"
#include "jounce/profiles/error.hpp"

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

/// The ramp of a gear; values that are not given are the limits of the axis.
GearInSpec ramp_of(const MoveDynamics& dynamics, const AxisConfig& config) {
  const auto given = [](double number, double otherwise) {
    return std::isnan(number) ? otherwise : number;
  };
  return {.acceleration = given(dynamics.acceleration, *config.limits.acceleration),
          .deceleration = given(dynamics.deceleration, 0),
          .jerk = given(dynamics.jerk, config.limits.jerk.value_or(0))};
}

double quotient(std::int32_t numerator, std::int32_t denominator) {
  return static_cast<double>(numerator) / static_cast<double>(denominator);
}

std::unique_ptr<Movement> gear_in_of(const command::GearIn& gear, std::uint64_t id,
                                     const AxisConfig& config) {
  const MoveDynamics& d = gear.dynamics;
  if (gear.clutch == 0) {
    GearInSpec spec = ramp_of(d, config);
    spec.numerator = gear.numerator;
    spec.denominator = gear.denominator;
    return std::make_unique<LiveGear>(id, spec);
  }
  for (const double value : {d.acceleration, d.deceleration, d.jerk})
    if (!std::isnan(value))
      throw InputError(
          "clutch", gear.clutch,
          "cannot be combined with acceleration, deceleration or jerk: the distance of "
          "the master determines them");
  return std::make_unique<LiveClutch>(id, quotient(gear.numerator, gear.denominator), gear.clutch);
}

}  // namespace

std::unique_ptr<Movement> gear_of(const ClientCommand& command, std::uint64_t id,
                                  const AxisConfig& config, double position) {
  if (const auto* const gear = std::get_if<command::GearIn>(&command))
    return gear_in_of(*gear, id, config);
  if (const auto* const gear = std::get_if<command::CombineAxes>(&command))
    return std::make_unique<LiveCombination>(
        id,
        CombinedRatios{.first = quotient(gear->numerator, gear->denominator),
                       .second = quotient(gear->second_numerator, gear->second_denominator)},
        ramp_of(gear->dynamics, config));
  if (const auto* const gear = std::get_if<command::GearInPos>(&command))
    return std::make_unique<LiveGearInPos>(id, gear_in_pos_of(*gear, config.modulo, position));
  return nullptr;
}

}  // namespace jounce
