// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>

#include "jounce/axis/command.hpp"
#include "jounce/command/command_table.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::record_fields {

/// A command in the form of the record: the fields of all commands, with the names of cycle_t.
struct FlatCommand {
  CommandKind kind = CommandKind::none;
  std::uint64_t id = 0;
  StartAt start_at = StartAt::tick;
  std::int64_t at = -1;
  double position = 0;
  bool relative = false;
  double factor = 1;
  MoveDynamics dynamics = {};
  Direction direction = Direction::shortest;
  BufferMode buffer = BufferMode::aborting;
  std::int32_t method = 0;
  double index_velocity = as_configured;
  double timeout = as_configured;
  double distance = as_configured;
};

/// Calls f(field of the command, field of the flat command) for every field except the movement.
template <class C, class Flat, class F>
void each_pair_of_command(C& c, Flat& flat, F f) {
  using T = std::remove_const_t<C>;
  if constexpr (requires { c.position; }) f(c.position, flat.position);
  if constexpr (requires { c.tick; }) f(c.tick, flat.at);
  if constexpr (requires { c.when; }) f(c.when, flat.start_at);
  if constexpr (std::is_same_v<T, command::SetPosition>) f(c.relative, flat.relative);
  if constexpr (requires { c.factor; }) f(c.factor, flat.factor);
  if constexpr (requires { c.direction; }) f(c.direction, flat.direction);
  if constexpr (requires { c.shift; }) f(c.shift, flat.distance);
  if constexpr (requires { c.until; }) f(c.until, flat.timeout);
  if constexpr (requires { c.length; }) f(c.length, flat.distance);
  if constexpr (requires { c.waste; }) f(c.waste, flat.timeout);
  if constexpr (requires { c.buffer; }) f(c.buffer, flat.buffer);
  if constexpr (requires { c.wait; }) f(c.wait, flat.timeout);
  if constexpr (requires { c.strokes; }) f(c.strokes, flat.method);
  if constexpr (std::is_same_v<T, command::Home>) {
    f(c.offset, flat.position);
    f(c.method, flat.method);
    f(c.search_velocity, flat.dynamics.velocity);
    f(c.index_velocity, flat.index_velocity);
    f(c.acceleration, flat.dynamics.acceleration);
    f(c.timeout, flat.timeout);
    f(c.distance, flat.distance);
  } else if constexpr (std::is_same_v<T, command::TouchProbe>) {
    f(c.input, flat.method);
    f(c.edge, flat.factor);
    f(c.count, flat.timeout);
    f(c.first_position, flat.index_velocity);
    f(c.last_position, flat.distance);
  } else if constexpr (std::is_same_v<T, command::AbortTrigger>) {
    f(c.input, flat.method);
  } else if constexpr (std::is_same_v<T, command::ChangeVelocity>) {
    f(c.velocity, flat.dynamics.velocity);
  } else {
    if constexpr (requires { c.distance; }) f(c.distance, flat.position);
    if constexpr (requires { c.velocity; }) f(c.velocity, flat.position);
    if constexpr (requires { c.dynamics; }) f(c.dynamics, flat.dynamics);
  }
}

/// Returns a command in that form.
inline FlatCommand flat(const Command& command) {
  FlatCommand flat{.kind = command.kind(), .id = command.id, .at = command.at};
  const auto put = [](const auto& from, auto& to) {
    to = static_cast<std::remove_reference_t<decltype(to)>>(from);
  };
  std::visit([&](const auto& what) { each_pair_of_command(what, flat, put); }, command.what);
  return flat;
}

/// Sets a field of a command from the number of a record. Throws InputError if the field needs a whole number
/// and `from` is none.
struct SetField {
  template <class To, class From>
  void operator()(To& to, const From& from) const {
    if constexpr (!std::is_floating_point_v<To> && std::is_floating_point_v<From>) {
      constexpr double most = std::numeric_limits<std::int32_t>::max();
      if (!(from >= 0 && from <= most && std::trunc(from) == from))
        throw InputError("command", std::to_string(from),
                         "must be a whole number from 0 to 2147483647");
    }
    to = static_cast<To>(from);
  }
};

/// Returns the command. Throws InputError for a kind that no axis executes, and for a damaged number.
inline Command command_of(const FlatCommand& flat) {
  const auto with_defaults = made<AxisCommand>(flat.kind);
  if (!with_defaults) throw InputError("command", name(flat.kind), "is not a command of an axis");
  Command command{.what = *with_defaults, .at = flat.at, .id = flat.id};
  const auto fill = [&](auto& what) {
    each_pair_of_command(what, flat, SetField{});
    if constexpr (requires { what.tick; }) command.at = -1;
  };
  std::visit(fill, command.what);
  return command;
}

}  // namespace jounce::record_fields
