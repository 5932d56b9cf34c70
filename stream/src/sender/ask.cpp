// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/ask.hpp"

#include <utility>
#include <variant>

#include "stream/src/sender/outbox.hpp"

namespace jounce {

std::optional<wire::Reply> ask(Transport& link, wire::Message& message, CommandSlot& slot,
                               const AskOptions& options, const Clock& clock, Rejects& rejects) {
  const bool learns = message.session == 0 || slot.number() == 1;
  std::optional<wire::Reply> last;
  stream_detail::Outbox outbox(link, options.key, clock);
  for (const Nanos end = clock() + options.patience; clock() <= end;) {
    if (auto body = slot.due(clock(), options.repeat)) {
      message.body = *std::move(body);
      outbox.send(message);
    }
    const auto answer = next_message(link, options.repeat, rejects, options.key);
    const auto* const reply = answer ? std::get_if<wire::Reply>(&answer->body) : nullptr;
    if (reply == nullptr || answer->executor != message.executor ||
        answer->session != message.session || !slot.is_answered_by(*reply))
      continue;
    if (learns && reply->refusal == wire::Refusal::stale_challenge) {
      if (std::exchange(message.challenge, answer->challenge) != answer->challenge) slot.hurry();
      continue;
    }
    last = *reply;
    if (last->outcome != wire::Outcome::pending) break;
  }
  slot.clear();
  return last;
}

}  // namespace jounce
