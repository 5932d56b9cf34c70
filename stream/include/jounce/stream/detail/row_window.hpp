// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "jounce/stream/detail/chunk_window.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce {

/// The rows of one bank in transit. The class sends them by selective repeat, and never more than
/// the free space of the bank.
class RowWindow {
 public:
  /// `bank`: 0 or 1.
  explicit RowWindow(const wire::Queue& queue, std::uint8_t bank = 0, Pace pace = {});

  /// Returns the number of rows that push() accepts now. The number depends on the free space and
  /// on the messages in transit.
  [[nodiscard]] std::size_t wants() const;
  /// Adds rows. Requires 1 to min(wants(), 200) rows.
  void push(std::vector<wire::Row> rows);

  /// Processes an acknowledgment. Ignores an acknowledgment that is inconsistent or older than a
  /// previous one.
  void acknowledge(const wire::QueueAck& ack);

  /// Returns the messages to send now. They then count as sent.
  [[nodiscard]] std::vector<wire::Rows> due(Nanos now);

  /// Number of rows that the executor has.
  [[nodiscard]] std::uint64_t acknowledged() const { return before_; }
  /// True if no message is in transit.
  [[nodiscard]] bool idle() const { return under_way_.empty(); }
  /// Number of messages that were sent again.
  [[nodiscard]] std::size_t resent() const { return resent_; }
  /// Number of messages without repetitions.
  [[nodiscard]] std::size_t sent() const { return next_ + under_way_.size(); }

 private:
  struct Sent {
    wire::Rows rows = {};
    Nanos at{};
    std::uint32_t times = 0;
    bool arrived = false;
  };

  std::uint32_t queue_;
  std::uint8_t bank_;
  Pace pace_;
  std::deque<Sent> under_way_;  // the first is message next_
  std::uint32_t next_ = 0;
  std::uint64_t before_ = 0;  // rows before message next_
  std::uint64_t pushed_ = 0;  // rows of all messages
  std::uint64_t limit_ = 0;   // number of the last row with space
  unsigned back_off_ = 0;
  std::size_t resent_ = 0;
};

}  // namespace jounce
