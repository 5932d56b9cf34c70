// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/orders.hpp"

#include <cmath>

#include "jounce/axis/live_gear.hpp"

namespace jounce {
namespace {

using Kind = Command::Kind;
using wire::OrderKind;

/// The wire's values from `first` on: velocity, acceleration, deceleration, jerk.
MoveDynamics dynamics(const std::array<double, 8>& value, std::size_t first) {
  return {value[first], value[first + 1], value[first + 2], value[first + 3]};
}

BufferMode buffer(double value) {
  return static_cast<BufferMode>(std::lround(value));
}

Command buffered(Command command, double value) {
  command.buffer = buffer(value);
  return command;
}

Command move(Kind kind, const std::array<double, 8>& value) {
  return {.kind = kind, .position = value[0], .dynamics = dynamics(value, 1)};
}

Command move_absolute(const std::array<double, 8>& value) {
  Command command = move(Kind::move_absolute, value);
  command.direction = static_cast<Direction>(std::lround(value[5]));
  command.buffer = buffer(value[6]);
  return command;
}

Command home(const std::array<double, 8>& value) {
  return {.kind = Kind::home,
          .position = value[0],
          .dynamics = {.velocity = value[2], .acceleration = value[4]},
          .homing = {.method = static_cast<int>(std::lround(value[1])),
                     .index_velocity = value[3],
                     .timeout = value[5],
                     .distance = value[6]}};
}

Command move_velocity(const std::array<double, 8>& value) {
  return {.kind = Kind::move_velocity,
          .position = value[0],
          .dynamics = {as_configured, value[1], value[2], value[3]}};
}

}  // namespace

namespace {

/// The command without its time.
std::optional<Command> untimed(const OrderRequested& order) {
  const auto& value = order.value;
  switch (order.kind) {
    case OrderKind::enable:
      return Command{.kind = Kind::enable};
    case OrderKind::disable:
      return Command{.kind = Kind::disable};
    case OrderKind::reset:
      return Command{.kind = Kind::reset};
    case OrderKind::set_position:
      return Command{.kind = Kind::set_position, .position = value[0], .relative = value[1] == 1};
    case OrderKind::home:
      return home(value);
    case OrderKind::hold:
      return Command{.kind = Kind::hold};
    case OrderKind::resume:
      return Command{.kind = Kind::resume};
    case OrderKind::override_:
      return Command{.kind = Kind::override_, .factor = value[0]};
    case OrderKind::move_absolute:
      return move_absolute(value);
    case OrderKind::move_relative:
      return buffered(move(Kind::move_relative, value), value[5]);
    case OrderKind::move_additive:
      return move(Kind::move_additive, value);
    case OrderKind::move_superimposed:
      return move(Kind::move_superimposed, value);
    case OrderKind::move_velocity:
      return buffered(move_velocity(value), value[4]);
    case OrderKind::halt:
      return Command{.kind = Kind::halt, .dynamics = {.deceleration = value[0], .jerk = value[1]}};
    case OrderKind::gear_out:
      return Command{.kind = Kind::gear_out};
    case OrderKind::cam_out:
      return Command{.kind = Kind::cam_out};
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Command> command_of(const OrderRequested& order) {
  auto command = untimed(order);
  if (command) command->at = order.at;
  return command;
}

std::unique_ptr<Movement> gear_of(const OrderRequested& order, std::uint64_t id,
                                  const AxisConfig& config, double position) {
  const auto& value = order.value;
  const auto whole = [&](std::size_t i) {
    return static_cast<std::int64_t>(std::llround(value[i]));
  };
  if (order.kind == OrderKind::gear_in) {
    const auto given = [](double number, double otherwise) {
      return std::isnan(number) ? otherwise : number;
    };
    return std::make_unique<LiveGear>(
        id, GearInSpec{.numerator = whole(0),
                       .denominator = whole(1),
                       .acceleration = given(value[2], *config.limits.acceleration),
                       .deceleration = given(value[3], 0),
                       .jerk = given(value[4], config.limits.jerk.value_or(0))});
  }
  if (order.kind == OrderKind::gear_in_pos)
    return std::make_unique<LiveGearInPos>(id, GearInPosSpec{.numerator = whole(0),
                                                             .denominator = whole(1),
                                                             .master_sync_position = value[2],
                                                             .slave_sync_position = value[3],
                                                             .master_start_distance = value[4],
                                                             .slave_start = position,
                                                             .avoid_reversal = value[5] == 1});
  return nullptr;
}

}  // namespace jounce
