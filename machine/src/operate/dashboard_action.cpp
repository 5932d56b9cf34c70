// SPDX-License-Identifier: Apache-2.0
#include <chrono>

#include <fmt/format.h>

#include "jounce/command/cause.hpp"
#include "jounce/machine/detail/dashboard.hpp"
#include "jounce/stream/sender/driver.hpp"

namespace jounce::dashboard {

std::string send(Transport& link, const std::string& axis, Action action,
                 const std::optional<wire::Key>& key) {
  const char* const word = action == Action::stop   ? "stop"
                           : action == Action::hold ? "hold"
                                                    : "resume";
  wire::Body body = wire::Stop{};
  if (action == Action::hold) body = wire::message_of(command::Hold{});
  if (action == Action::resume) body = wire::message_of(command::Resume{});
  const wire::Reply reply =
      operator_command(link, axis, std::move(body), std::chrono::seconds(1), key);
  if (reply.outcome == wire::Outcome::accepted) return fmt::format("{}: {} accepted", axis, word);
  if (reply.outcome == wire::Outcome::pending) return fmt::format("{}: {}: no answer", axis, word);
  return fmt::format(
      "{}: {} rejected: {}", axis, word,
      reply.cause != 0 ? name(static_cast<Cause>(reply.cause)) : name(reply.refusal));
}

}  // namespace jounce::dashboard
