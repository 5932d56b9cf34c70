// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/stream/sender/command_slot.hpp"
#include "jounce/stream/transport/link.hpp"

namespace jounce {

struct AskOptions {
  std::optional<wire::Key> key{};                ///< key of the executor; nullopt: none
  Nanos patience = std::chrono::seconds(2);      ///< until the outcome
  Nanos repeat = std::chrono::milliseconds(20);  ///< interval of repetition
};

/// Repeats the command of the slot in the session of `message` until its outcome, for at most
/// `patience`. Returns the last reply, which is pending without an outcome; nullopt: no answer. On
/// a challenge (for an operator, or the first command of a session), stores it in `message` and
/// resends the command. The link must have subscribed to replies.
std::optional<wire::Reply> ask(Transport& link, wire::Message& message, CommandSlot& slot,
                               const AskOptions& options, const Clock& clock, Rejects& rejects);

}  // namespace jounce
