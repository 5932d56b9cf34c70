// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "jounce/axis/command.hpp"
#include "jounce/command/commands.hpp"

namespace jounce::record_fields {

/// A command in the form of the record. The movement of the command is recorded apart.
struct CommandFields {
  CommandKind kind = CommandKind::none;
  std::uint64_t id = 0;
  std::int64_t at = -1;            ///< tick of the execution, or of the start
  std::int64_t group = 0;          ///< group of an Arm and of a Start
  std::array<double, 8> values{};  ///< the other fields, in their order; then zeros
};

/// Calls f(member) for every member of a command but its movement, its tick and its group.
template <class C, class F>
void each_value(C& c, F f) {
  using T = std::remove_const_t<C>;
  if constexpr (std::is_same_v<T, command::Start>) {
    f(c.when);
    f(c.position);
  } else if constexpr (std::is_same_v<T, command::Stop>) {
    command::each_field(c.dynamics, [&](const Field& /*field*/, auto& member) { f(member); });
  } else if constexpr (std::is_same_v<T, command::Extend>) {
    f(c.position);
    f(c.shift);
    f(c.until);
  } else if constexpr (!std::is_same_v<T, command::Arm> && !std::is_same_v<T, command::Couple>) {
    command::each_field(c, [&](const Field& /*field*/, auto& member) { f(member); });
  }
}

/// Returns a command in that form.
inline CommandFields fields_of(const Command& command) {
  CommandFields fields{.kind = command.kind(), .id = command.id, .at = command.at};
  const auto put = [&](const auto& what) {
    std::size_t i = 0;
    each_value(what,
               [&](const auto& member) { fields.values.at(i++) = static_cast<double>(member); });
    if constexpr (requires { what.tick; }) fields.at = what.tick;
    if constexpr (requires { what.group; }) fields.group = what.group;
  };
  std::visit(put, command.what);
  return fields;
}

}  // namespace jounce::record_fields
