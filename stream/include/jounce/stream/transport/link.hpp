// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/transport/transport.hpp"

/// Messages over a link: functions for all programs around the state machines.
namespace jounce {

/// Number of rejected packets, by reason.
struct Rejects {
  std::array<std::size_t, wire::reject_count> by_reason{};

  [[nodiscard]] std::size_t operator[](wire::Reject reject) const {
    return by_reason[static_cast<std::size_t>(reject)];
  }
  [[nodiscard]] std::size_t total() const;
};

/// Returns the next message on this link, after waiting for at most `timeout` for a packet. A
/// packet that is not a message is counted and dropped, and ends the wait.
std::optional<wire::Message> next_message(Transport& link, Nanos timeout, Rejects& rejects,
                                          const std::optional<wire::Key>& key = {});

/// Passes the messages that wait on the link to `take`, up to a bounded number, after waiting for
/// the first for at most `timeout`.
void drain(Transport& link, Nanos timeout, const std::optional<wire::Key>& key, Rejects& rejects,
           const std::function<void(const wire::Message&)>& take);

/// Encodes a message, signs it with the key, and sends it on its channel.
void send_message(Transport& link, const wire::Message& message,
                  const std::optional<wire::Key>& key = {});

/// Waiting packets of a channel, at most: more than a window, for repeats and other streamers.
inline constexpr int queue_capacity = 64;

/// A random number > 0, for sessions, boots and an operator's commands.
std::int64_t random_id();

}  // namespace jounce
