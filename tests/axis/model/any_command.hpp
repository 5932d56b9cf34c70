// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "jounce/axis/command.hpp"
#include "jounce/command/detail/command_table.hpp"

namespace jounce::test {

/// Calls f(member of the command, field of AnyCommand) for every member except the movement.
template <class C, class Any, class F>
void each_pair(C& c, Any& any, F f) {
  using T = std::remove_const_t<C>;
  if constexpr (requires { c.position; }) f(c.position, any.position);
  if constexpr (requires { c.tick; }) f(c.tick, any.at);
  if constexpr (requires { c.when; }) f(c.when, any.start_at);
  if constexpr (std::is_same_v<T, command::SetPosition>) f(c.relative, any.relative);
  if constexpr (requires { c.factor; }) f(c.factor, any.factor);
  if constexpr (requires { c.direction; }) f(c.direction, any.direction);
  if constexpr (requires { c.shift; }) f(c.shift, any.distance);
  if constexpr (requires { c.until; }) f(c.until, any.timeout);
  if constexpr (requires { c.length; }) f(c.length, any.distance);
  if constexpr (requires { c.waste; }) f(c.waste, any.timeout);
  if constexpr (requires { c.buffer; }) f(c.buffer, any.buffer);
  if constexpr (requires { c.wait; }) f(c.wait, any.timeout);
  if constexpr (requires { c.strokes; }) f(c.strokes, any.method);
  if constexpr (std::is_same_v<T, command::Home>) {
    f(c.offset, any.position);
    f(c.method, any.method);
    f(c.search_velocity, any.dynamics.velocity);
    f(c.index_velocity, any.index_velocity);
    f(c.acceleration, any.dynamics.acceleration);
    f(c.timeout, any.timeout);
    f(c.distance, any.distance);
  } else if constexpr (std::is_same_v<T, command::TouchProbe>) {
    f(c.input, any.method);
    f(c.edge, any.factor);
    f(c.count, any.timeout);
    f(c.first_position, any.index_velocity);
    f(c.last_position, any.distance);
  } else if constexpr (std::is_same_v<T, command::AbortTrigger>) {
    f(c.input, any.method);
  } else if constexpr (std::is_same_v<T, command::ChangeVelocity>) {
    f(c.velocity, any.dynamics.velocity);
  } else {
    if constexpr (requires { c.distance; }) f(c.distance, any.position);
    if constexpr (requires { c.velocity; }) f(c.velocity, any.position);
    if constexpr (requires { c.dynamics; }) f(c.dynamics, any.dynamics);
  }
}

/// The fields of all commands, for tests that go through the kinds.
struct AnyCommand {
  CommandKind kind = CommandKind::none;
  Movement* movement = nullptr;
  StartAt start_at = StartAt::tick;
  std::int64_t group = 0;
  std::int64_t at = -1;
  double position = 0;  ///< also a distance, a velocity, an offset
  bool relative = false;
  double factor = 1;
  MoveDynamics dynamics = {};
  Direction direction = Direction::shortest;
  BufferMode buffer = BufferMode::aborting;
  int method = 0;
  double index_velocity = as_configured;
  double timeout = as_configured;
  double distance = as_configured;

  /// The command of that kind, with those fields that it has.
  operator Command() const {  // NOLINT(google-explicit-constructor)
    Command command{.what = *made<AxisCommand>(kind), .at = at};
    std::visit(
        [&](auto& what) {
          each_pair(what, *this, [](auto& to, const auto& from) {
            using To = std::remove_reference_t<decltype(to)>;
            if constexpr (std::is_integral_v<To> && std::is_same_v<decltype(from), const double&>)
              if (std::isnan(from)) return;  // not given: the default stays
            to = static_cast<To>(from);
          });
          if constexpr (requires { what.movement; }) what.movement = movement;
          if constexpr (requires { what.group; }) what.group = group;
          if constexpr (requires { what.tick; }) command.at = -1;
        },
        command.what);
    return command;
  }
};

inline Command any(const AnyCommand& command) {
  return command;
}

/// Kinds that an axis executes, first `none`. `extend` is only for a group.
inline const std::vector<CommandKind>& axis_kinds() {
  static const std::vector<CommandKind> kinds = [] {
    std::vector<CommandKind> all;
    for (const CommandInfo& row : all_commands())
      if (row.kind != CommandKind::extend && made<AxisCommand>(row.kind)) all.push_back(row.kind);
    return all;
  }();
  return kinds;
}

}  // namespace jounce::test
