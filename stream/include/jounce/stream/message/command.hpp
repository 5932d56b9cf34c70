// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/command/command_values.hpp"
#include "jounce/command/commands.hpp"

namespace jounce::wire {

/// A command to an axis other than playing tables, with its fields as the wire has them: a sender
/// may have sent any numbers. The receiver checks them and makes the ClientCommand.
///
///     wire::message_of(command::MoveAbsolute{.position = 120, .dynamics = {.velocity = 200}})
struct Command {
  std::int32_t command = 0;  ///< see Arm
  CommandKind kind = CommandKind::enable;
  std::int64_t at = -1;  ///< tick; -1: the next one
  CommandValues value{};
};

/// `at`: tick; -1: the next one.
inline Command message_of(const ClientCommand& command, std::int64_t at = -1) {
  return {.kind = kind_of(command), .at = at, .value = values_of(command)};
}

}  // namespace jounce::wire
