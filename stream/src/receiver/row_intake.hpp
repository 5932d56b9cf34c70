// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "jounce/stream/detail/queue_level.hpp"
#include "jounce/stream/message/message.hpp"

#include "stream/src/message/refusal.hpp"

namespace jounce {

/// The arriving rows of one queue. The class puts them into order, checks them, and never accepts
/// more rows than the free space holds. It keeps at most `credit` messages that have arrived before
/// their predecessors.
class RowIntake {
 public:
  /// `credit`: greatest number of messages in transit.
  RowIntake(const wire::Queue& queue, std::uint32_t credit);

  /// Adds rows, if they fit into the free space. Rows that were already received have no effect.
  void add(const wire::Rows& rows);

  /// Returns the rows of both banks that are now in order and were not returned before.
  [[nodiscard]] std::vector<wire::Rows> take();

  /// Drops the rows of this bank. The next message of the bank has the number `seq`.
  void clear(std::uint8_t bank, std::uint32_t seq);

  /// Reports the progress of the axis. Returns true if an acknowledgment is due.
  bool level(const QueueLevel& level);
  /// Rejects the queue. Only the first call has an effect.
  void refuse(Refused refused, std::int64_t row = -1);

  /// Returns the acknowledgment. `boot`: number of this start of the executor.
  [[nodiscard]] wire::QueueAck ack(std::int64_t boot) const;
  /// True if the bank has enough rows for a start, or all of its rows.
  [[nodiscard]] bool filled(std::uint8_t bank) const;
  /// The queue as it was opened.
  [[nodiscard]] const wire::Queue& queue() const { return queue_; }
  /// True if the queue was rejected.
  [[nodiscard]] bool refused() const { return static_cast<bool>(refused_); }

 private:
  struct Bank {
    std::uint32_t next = 0;   // number of the next message
    std::uint64_t rows = 0;   // rows before the next message
    std::uint64_t freed = 0;  // number of these rows that were freed
    std::uint64_t begin = 0;  // first row since the last clear
    bool resumes = false;     // true if the next message sets the number of rows before it
    bool ended = false;       // true if the last row of the stream has arrived
    double x = 0;             // x at the end of the last row
    std::map<std::uint32_t, wire::Rows> held;  // early messages, at most credit_
  };

  void advance(Bank& bank);
  [[nodiscard]] bool is_sound(const Bank& bank, const wire::Rows& rows);
  [[nodiscard]] std::uint32_t space(const Bank& bank) const;

  wire::Queue queue_;
  std::uint32_t credit_;
  std::array<Bank, 2> banks_;
  std::vector<wire::Rows> ready_;
  QueueLevel level_;
  Refused refused_;
  std::int64_t refused_row_ = -1;
};

}  // namespace jounce
