// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

const std::vector<std::string> queue_types{"absolute", "relative", "velocity", "halt", "dwell"};
const std::vector<std::string> buffer_modes{"aborting",          "buffered",      "blending_low",
                                            "blending_previous", "blending_next", "blending_high"};

void read_over(MotionFields& f, Dynamics& d) {
  f.may_positive("velocity", 1, d.velocity);
  f.may_positive("acceleration", 2, d.acceleration);
  f.may("deceleration", 2, d.deceleration);
  f.may("jerk", 3, d.jerk);
  for (const auto& [key, value] : {std::pair{"deceleration", d.deceleration}, {"jerk", d.jerk}})
    if (value < 0) f.reader().fail(key, number(value), "must not be negative");
}

/// The places of a queue on a modulo axis: the position at which the next command begins.
struct Turning {
  std::optional<double> period;  ///< nullopt: a linear axis
  std::optional<double> place;   ///< nullopt: unknown, because the axis then moves
};

/// The target of a move to `position`, as the position on the way that `direction` names.
double read_turned(TomlReader& command, double position, bool waits, const Turning& axis) {
  const Direction direction = read_direction(command, axis.period.has_value());
  if (!axis.period) return position;
  if (!axis.place || !waits)
    command.fail("position", number(position),
                 "needs a place where the command before it ends: with period, use mode = "
                 "\"buffered\" or a blending mode, after a move to a target");
  return turned_target(command, "position", {.position = *axis.place}, position, direction,
                       *axis.period);
}

MotionCommand read_what(MotionFields& f, bool waits, Turning& axis) {
  TomlReader& command = f.reader();
  double value = 0;
  switch (command.variant("type", queue_types)) {
    case 0:
      f.need("position", 0, value);
      value = read_turned(command, value, waits, axis);
      axis.place = value;
      return MoveAbsolute{value};
    case 1:
      f.need("distance", 0, value);
      axis.place = axis.place && waits ? std::optional(*axis.place + value) : std::nullopt;
      return MoveRelative{value};
    case 2:
      axis.place.reset();
      return MoveVelocity{static_cast<int>(command.optional_whole("direction").value_or(1))};
    case 3:
      axis.place.reset();
      return Halt{};
    default:
      return Dwell{command.number("time", f.units().x)};
  }
}

void require_dynamics(MotionFields& f, const QueuedCommand& c) {
  const auto require = [&](const char* key, int order, double value) {
    if (value != 0) return;
    f.reader().fail(key, "",
                    std::string("is missing: add ") + key + " = NUMBER, in " + f.unit(order) +
                        ", here or for all commands in [dynamics]");
  };
  if (!std::holds_alternative<Halt>(c.command)) require("velocity", 1, c.dynamics.velocity);
  require("acceleration", 2, c.dynamics.acceleration);
}

QueuedCommand read_command(TomlReader& command, const Units& units, const Dynamics& common,
                           Turning& axis, bool first) {
  MotionFields fields(command, units);
  QueuedCommand c{.command = {}, .dynamics = common};
  if (const auto mode = command.optional_choice("mode", buffer_modes))
    c.mode = static_cast<BufferMode>(*mode);
  c.command = read_what(fields, first || c.mode != BufferMode::aborting, axis);
  if (!std::holds_alternative<Dwell>(c.command)) {
    read_over(fields, c.dynamics);
    require_dynamics(fields, c);
  }
  if (std::holds_alternative<Dwell>(c.command) && c.mode > BufferMode::buffered)
    command.fail("mode", '"' + buffer_modes[static_cast<std::size_t>(c.mode)] + '"',
                 "does not apply to a dwell, which begins and ends at rest: use buffered");
  c.issued = fields.optional_time("issued");
  command.finish();
  return c;
}

}  // namespace

QueueSpec read_queue(TomlReader& top, const Units& units) {
  QueueSpec queue;
  if (auto start = top.optional_table("start")) {
    MotionFields fields(*start, units);
    fields.may("position", 0, queue.start.position);
    fields.may("velocity", 1, queue.start.velocity);
    fields.may("acceleration", 2, queue.start.acceleration);
    start->finish();
  }
  Dynamics common;
  if (auto dynamics = top.optional_table("dynamics")) {
    MotionFields fields(*dynamics, units);
    read_over(fields, common);
    dynamics->finish();
  }
  Turning axis{top.optional_positive("period", units.position), std::nullopt};
  if (queue.start.velocity == 0 && queue.start.acceleration == 0) axis.place = queue.start.position;
  top.for_each("command", [&](TomlReader& command) {
    queue.commands.push_back(read_command(command, units, common, axis, queue.commands.empty()));
  });
  if (queue.commands.empty()) top.fail("command", "", "is missing: add [[command]]");
  return queue;
}

}  // namespace jounce::spec_detail
