// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "jounce/stream/sender/outcome.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Options for sending the chunks of a table. The defaults suit a local network and the default
/// socket buffer of Linux, which holds 8 messages of 12.8 KB, or longer chunks of the same total
/// length.
struct Pace {
  std::uint32_t window = 8;  ///< messages of 12.8 KB in transit, 1 to 64
  /// Doubles in a chunk, 4 to 7680; longer chunks cost less time for each byte.
  std::uint32_t chunk = 4096;
  Nanos resend = std::chrono::milliseconds(6);  ///< least time until a chunk is sent again
  /// Greatest time until a chunk is sent again; the time doubles while no acknowledgment arrives.
  Nanos slowest = std::chrono::milliseconds(100);
  /// Least time until a chunk is sent again if a later chunk has arrived.
  Nanos fast_resend = std::chrono::milliseconds(2);
};

/// Times of a streamer. A stream fails when one of the three waiting limits (`patience`,
/// `command_patience`, `progress_patience`) is exceeded.
struct SenderOptions {
  Pace pace = {};  ///< options for the chunks
  /// Time between two repetitions of a header or command without an answer.
  Nanos repeat = std::chrono::milliseconds(20);
  Nanos heartbeat = std::chrono::milliseconds(100);  ///< time between two heartbeats
  Nanos patience = std::chrono::seconds(5);          ///< greatest time without any answer
  /// Greatest time until the outcome of a command.
  Nanos command_patience = std::chrono::seconds(5);
  /// Greatest time until a further chunk arrives.
  Nanos progress_patience = std::chrono::seconds(10);
};

/// Stage of a stream.
enum class StreamStage {
  downloading,  ///< sends the tables
  arming,
  starting,
  stopping,
  swapping,   ///< a swap was accepted, and waits for its boundary
  waiting,    ///< the last start was accepted, and has not taken place yet
  holding,    ///< the goal is reached, and heartbeats keep the session alive
  releasing,  ///< ends the session; a motion continues
  released,   ///< the session has ended
  failed,     ///< the stream has ended with an error
};
/// Returns the name of a stage.
const char* name(StreamStage stage);

/// Progress of a stream.
struct StreamProgress {
  StreamStage stage = StreamStage::downloading;  ///< present stage
  std::size_t chunks = 0;                        ///< number of chunks of all tables
  std::size_t arrived = 0;                       ///< number of chunks that have arrived
  std::size_t resent = 0;                        ///< number of chunks that were sent again
  std::string note{};  ///< remark of the executor on the accepted start; may be empty
};

/// Outcome or state of a stream. A flag is true as soon as the executor has confirmed it.
struct [[nodiscard]] StreamOutcome : CallOutcome {
  bool downloaded = false;  ///< all tables have arrived
  bool armed = false;       ///< the motion is armed
  bool started = false;   ///< the start was accepted; with StreamPlan::await: the motion has begun
  bool stopped = false;   ///< the axis was stopped
  std::size_t swaps = 0;  ///< number of swaps that were accepted
  StreamProgress progress = {};  ///< progress so far
  std::string remark{};          ///< StreamPlan::remark
};

}  // namespace jounce
