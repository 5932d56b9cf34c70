// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/transport/transport.hpp"

/// Functions that send and receive messages over a link.
namespace jounce {

/// Numbers of packets that were rejected, for each reason.
struct Rejects {
  std::array<std::size_t, wire::reject_count> by_reason{};  ///< indexed by wire::Reject

  [[nodiscard]] std::size_t operator[](wire::Reject reject) const {
    return by_reason[static_cast<std::size_t>(reject)];
  }
  /// Number of all rejected packets.
  [[nodiscard]] std::size_t total() const;
};

/// Waits for a packet for at most `timeout`, and returns its message. A packet that is not a
/// message is counted in `rejects` and dropped; the function then returns nullopt.
std::optional<wire::Message> next_message(Transport& link, Nanos timeout, Rejects& rejects,
                                          const std::optional<wire::Key>& key = {});

/// Waits for a message for at most `timeout`. Then passes all messages that wait on the link, up to
/// a fixed number, to `take`.
void drain(Transport& link, Nanos timeout, const std::optional<wire::Key>& key, Rejects& rejects,
           const std::function<void(const wire::Message&)>& take);

/// Encodes a message (with a key: with an authentication code), and sends it on its channel.
void send_message(Transport& link, const wire::Message& message,
                  const std::optional<wire::Key>& key = {});

/// Greatest number of packets of a channel that wait. This number exceeds the number of messages
/// that a streamer has in transit (Pace::window, 8 by default), because repetitions and other
/// streamers may add packets.
inline constexpr int queue_capacity = 64;

/// Returns a random number > 0, for sessions, boots and operators' commands.
std::int64_t random_id();

}  // namespace jounce
