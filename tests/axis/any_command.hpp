// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "jounce/axis/command.hpp"
#include "jounce/command/command_table.hpp"

#include "executor/src/record/flat_command.hpp"

namespace jounce::test {

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
          record_fields::each_pair_of_command(what, *this, [](auto& to, const auto& from) {
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
