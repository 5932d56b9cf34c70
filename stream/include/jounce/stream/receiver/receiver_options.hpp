// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Options of a receiver.
struct ReceiverOptions {
  std::string executor = {};             ///< name of the axis
  std::uint32_t most_knots = 1U << 24U;  ///< greatest number of knots of a table
  /// Greatest memory for all tables, complete or in transit, bytes.
  std::size_t memory = std::size_t{1} << 28U;
  /// A session ends, and the axis is free, after this time without a sign of life of its owner: a
  /// new command (a heartbeat is one), a repetition of a command that waits for its outcome, or new
  /// rows. Before the first command, any message is a sign of life.
  Nanos session_timeout = std::chrono::seconds(1);
  /// Like session_timeout, from the first hold-to-run jog of a session to its end.
  Nanos hold_timeout = std::chrono::milliseconds(200);
  /// Greatest number of messages of 12.8 KB in transit, 1 to 64. 8 messages fit into the default
  /// buffer of a socket.
  std::uint32_t credit = 8;
  std::uint32_t most_rows = 1U << 20U;  ///< greatest number of rows of one bank of a queue
  std::size_t most_queues = 4;          ///< greatest number of queues in a session
  std::optional<wire::Key> key{};       ///< key that authenticates commands; nullopt: no key
};

}  // namespace jounce
