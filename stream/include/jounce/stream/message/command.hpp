// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/command/command_values.hpp"
#include "jounce/command/commands.hpp"

namespace jounce::wire {

/// Any ClientCommand, with the fields of the wire format. Arm, Start and Stop have messages of
/// their own. A received message may contain any numbers; the receiver checks them and makes a
/// ClientCommand.
///
///     wire::message_of(command::MoveAbsolute{.position = 120, .dynamics = {.velocity = 200}})
struct Command {
  std::int32_t command = 0;                ///< number of the command in its session, see Arm
  CommandKind kind = CommandKind::enable;  ///< kind of the command
  std::int64_t at = -1;                    ///< tick in which the axis executes it; -1: the next one
  /// Fields of the command, in the order of CommandInfo::fields.
  CommandValues value{};
};

/// Returns the message for a command. `at`: tick in which the axis executes it; -1: the next one.
inline Command message_of(const ClientCommand& command, std::int64_t at = -1) {
  return {.kind = kind_of(command), .at = at, .value = values_of(command)};
}

}  // namespace jounce::wire
