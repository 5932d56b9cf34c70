// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/command/field.hpp"
#include "jounce/command/state.hpp"

namespace jounce {

/// Permitted sender of a command.
enum class CommandSender : std::uint8_t {
  executor,  ///< the executor alone, on behalf of a message of another type
  owner,     ///< the session that owns the axis
  anyone,    ///< even an operator without a session: it changes the timing of the motion only
};

/// Everything about a command except its effect. The codec, `jounce order`, the live page, the
/// checks of the receiver and of the axis, and the tables in the documentation come from it.
struct CommandInfo {
  CommandKind kind = CommandKind::none;
  const char* name = "";     ///< "move_absolute"
  std::int8_t number = -1;   ///< on the wire; -1: it is not sent
  const char* word = "";     ///< word of `jounce order`; "": none
  const char* plcopen = "";  ///< function block of PLCopen; "": none
  CommandSender sender = CommandSender::executor;
  bool moves = false;                    ///< sets the axis in motion for the session that sends it
  std::array<Cause, states> by_state{};  ///< reason to reject it in a state; none: accepted
  Fields fields = {};
};

/// One row a command, in the order of CommandKind.
std::span<const CommandInfo> all_commands();
const CommandInfo& info(CommandKind kind);

/// "move_absolute", ...
const char* name(CommandKind kind);

/// The command of this number on the wire; nullopt: none.
std::optional<CommandKind> kind_of_number(int number);

/// Returns the reason to reject a command in a state, or none if it is accepted. Further conditions
/// (a movement, a target within the range) are checked later.
Cause permitted(State state, CommandKind kind) noexcept;

/// True if an operator may send it without owning the axis.
bool is_operators(CommandKind kind);

}  // namespace jounce
