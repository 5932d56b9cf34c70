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
  executor,  ///< only the executor, to carry out a message of another type
  owner,     ///< the client that owns the axis during its session, such as a streamer
  anyone,  ///< even an operator who does not own the axis: the command only changes the timing of a
           ///< motion
};

/// Everything about a command except its effect. The codec, `jounce order`, the live page, the
/// checks of the receiver and of the axis, and the tables in the documentation use this
/// description.
struct CommandInfo {
  CommandKind kind = CommandKind::none;
  const char* name = "";     ///< name in logs and messages: "move_absolute"
  std::int8_t number = -1;   ///< number on the wire; -1: the command is not sent
  const char* word = "";     ///< word of `jounce order`; "": none
  const char* plcopen = "";  ///< function block of PLCopen; "": none
  CommandSender sender = CommandSender::executor;  ///< permitted sender
  bool moves = false;  ///< true if the command can set the axis in motion
  /// For each State, the reason to reject the command; none: the state permits it.
  std::array<Cause, states> by_state{};
  Fields fields = {};  ///< fields, in the order of the wire
};

/// Returns one row for each command, in the order of CommandKind.
std::span<const CommandInfo> all_commands();
/// Returns the rows of the commands that a client sends, in the order of their numbers.
std::span<const CommandInfo* const> sent_commands();
/// Returns the row of a command.
const CommandInfo& info(CommandKind kind);

/// Returns the name of a command: "move_absolute", ...
const char* name(CommandKind kind);

/// Returns the command with this number on the wire; nullopt if no command has the number.
std::optional<CommandKind> kind_of_number(int number);

/// Returns the reason to reject a command in a state, or none if the state permits it. Further
/// conditions (an armed movement, a target within the range) are checked later.
Cause permitted(State state, CommandKind kind) noexcept;

/// True if an operator may send the command without owning the axis.
bool is_operators(CommandKind kind);

}  // namespace jounce
