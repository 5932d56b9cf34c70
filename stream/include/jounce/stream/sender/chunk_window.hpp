// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Options for sending the chunks of a table. The defaults suit a local network and Linux's default
/// socket buffer, which holds 8 messages of 12.8 KB, or chunks of the same total length.
struct Pace {
  std::uint32_t window = 8;    ///< messages of 12.8 KB in transit, 1...64
  std::uint32_t chunk = 4096;  ///< doubles of a chunk, 4...7680: longer ones cost less per byte
  Nanos resend = std::chrono::milliseconds(6);     ///< minimum time until a chunk is sent again
  Nanos slowest = std::chrono::milliseconds(100);  ///< maximum: doubles while nothing arrives
  Nanos fast_resend =
      std::chrono::milliseconds(2);  ///< minimum, for a chunk that a later one has overtaken
};

/// The chunks of one table in transit: selects those to send now, and to send again. Selective
/// repeat within a window; the time until a repeat follows the measured round trip (RFC 6298) with
/// back-off. A chunk counts as missing if a chunk that was sent after it has arrived (RFC 8985).
/// Without an ack, the first repeat is one chunk alone: a receiver that was only delayed has all
/// the others already.
class ChunkWindow {
 public:
  ChunkWindow(std::uint32_t chunks, Pace pace);

  /// Returns true if at least one more chunk has arrived. An inconsistent ack changes nothing.
  bool acknowledge(const wire::Ack& ack, Nanos now);

  /// Returns the chunks to send now; they count as sent.
  [[nodiscard]] std::vector<std::uint32_t> due(Nanos now);

  [[nodiscard]] std::size_t arrived() const { return arrived_; }
  [[nodiscard]] std::size_t resent() const { return resent_; }

 private:
  struct State {
    Nanos sent{};
    std::uint64_t order = 0;  // number of its last transmission among all
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
