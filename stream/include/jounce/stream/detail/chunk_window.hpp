// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"

namespace jounce {

/// The chunks of one table in transit: selects the chunks to be sent now, and the chunks to be sent
/// again. The method is selective repeat within a window. The time until a repeat follows the
/// measured round trip (RFC 6298) and increases while no acknowledgment arrives. A chunk counts as
/// lost if a chunk that was sent later has arrived (RFC 8985). If no acknowledgment arrives at all,
/// only one chunk is repeated first, because a receiver that was merely delayed already has all
/// others.
class ChunkWindow {
 public:
  /// `chunks`: number of chunks of the table.
  ChunkWindow(std::uint32_t chunks, Pace pace);

  /// Processes an acknowledgment. Returns true if more chunks have arrived. An inconsistent
  /// acknowledgment has no effect.
  bool acknowledge(const wire::Ack& ack, Nanos now);

  /// Returns the numbers of the chunks to send now. They then count as sent.
  [[nodiscard]] std::vector<std::uint32_t> due(Nanos now);

  /// Number of chunks that have arrived.
  [[nodiscard]] std::size_t arrived() const { return arrived_; }
  /// Number of chunks that were sent again.
  [[nodiscard]] std::size_t resent() const { return resent_; }

 private:
  struct State {
    Nanos sent{};
    std::uint64_t order = 0;  // number of its last transmission, counted over all chunks
    std::uint32_t times = 0;
    bool arrived = false;
  };

  bool mark(std::uint32_t seq, Nanos now);
  void measure(Nanos round_trip);
  [[nodiscard]] Nanos patience() const;

  Pace pace_;
  std::vector<State> chunks_;
  std::uint32_t next_ = 0;    // all chunks below have arrived
  std::uint64_t sent_ = 0;    // transmissions so far
  std::uint64_t newest_ = 0;  // the latest transmission that has arrived
  std::uint32_t credit_ = 0;
  unsigned back_off_ = 0;
  bool measured_ = false;
  Nanos round_trip_{}, deviation_{};
  std::size_t arrived_ = 0;
  std::size_t resent_ = 0;
};

}  // namespace jounce
