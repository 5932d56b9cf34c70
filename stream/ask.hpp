#pragma once

#include <optional>

#include "jounce/stream/command_slot.hpp"
#include "jounce/stream/link.hpp"

namespace jounce {

struct AskOptions {
  std::optional<wire::Key> key{};                ///< the executor's; none: it has none
  Nanos patience = std::chrono::seconds(2);      ///< until it is decided
  Nanos repeat = std::chrono::milliseconds(20);  ///< between two times that it is said
};

/// Says the slot's command in the session of `message` until the executor decides, for at most
/// `patience`. Returns its last reply, which is pending where it did not decide; none: nobody
/// answered. Who cannot know the challenge yet, an operator or the first command of a session, is
/// told it, notes it in `message`, and says the command again. The link has subscribed to replies.
std::optional<wire::Reply> ask(Transport& link, wire::Message& message, CommandSlot& slot,
                               const AskOptions& options, const Clock& clock, Rejects& rejects);

}  // namespace jounce
