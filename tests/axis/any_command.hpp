// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "jounce/axis/command.hpp"

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
          record_fields::each_pair_of_command(what, *this,
                                              [](auto& to, const auto& from) { to = from; });
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

/// Kinds that an axis executes, `none` among them; `extend` is only for a group.
inline std::vector<CommandKind> axis_kinds() {
  std::vector<CommandKind> all;
  for (std::size_t k = 0; k < command_kinds; ++k) {
    const auto kind = static_cast<CommandKind>(k);
    if (made<AxisCommand>(kind) && kind != CommandKind::extend) all.push_back(kind);
  }
  return all;
}
/// Number of these kinds that any axis can obey: the first ones. A plan of cuts has further ones.
inline constexpr auto usual_kinds = static_cast<std::size_t>(CommandKind::gear_in_pos);

}  // namespace jounce::test
