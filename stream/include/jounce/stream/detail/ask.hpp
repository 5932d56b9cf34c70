// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/stream/detail/command_slot.hpp"
#include "jounce/stream/transport/link.hpp"

namespace jounce {

/// Options of ask().
struct AskOptions {
  std::optional<wire::Key> key{};                ///< key of the executor; nullopt: none
  Nanos patience = std::chrono::seconds(2);      ///< greatest time until the outcome
  Nanos repeat = std::chrono::milliseconds(20);  ///< time between two repetitions
};

/// Sends the command of the slot in the session of `message`, and repeats it until the executor
/// reports its outcome, for at most `patience`. Returns the last reply (`pending` if the command
/// has no outcome yet); nullopt: no reply. If the executor requires another challenge (from an
/// operator, or for the first command of a session), stores this challenge in `message` and sends
/// the command again. Requires a link that has subscribed to the replies.
std::optional<wire::Reply> ask(Transport& link, wire::Message& message, CommandSlot& slot,
                               const AskOptions& options, const Clock& clock, Rejects& rejects);

}  // namespace jounce
