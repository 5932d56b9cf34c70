// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "jounce/stream/message/message.hpp"

#include "stream/src/message/refusal.hpp"
#include "stream/src/receiver/row_intake.hpp"

namespace jounce {

/// Limits of the queues of a receiver.
struct QueueLimits {
  std::uint32_t most_rows = 0;  ///< greatest number of rows of one bank
  std::size_t most_queues = 0;  ///< greatest number of queues of one session
  std::uint32_t credit = 0;     ///< greatest number of messages in transit
};

/// The open queues of a session, each with an index of its own and the rows that arrive for it.
///
///     QueueIntake queues(limits);
///     if (Refused no = queues.add(queue)) ...               // an answer to its sender
///     if (const auto opened = queues.take_opened()) ...     // after every add() of a queue
///     queues.add(rows);
///     for (wire::Rows& ready : queues.take_rows()) ...      // in order, within the free space
///     for (wire::QueueAck ack : queues.acks(boot)) ...      // each due acknowledgment once
///     queues.clear();                                       // the session has ended
class QueueIntake {
 public:
  explicit QueueIntake(const QueueLimits& limits) : limits_(limits) {}

  /// Adds a queue. Returns a refusal if the queue is not valid or exceeds the limits, if it is over
  /// time and not in s, or if its index belongs to another queue. Other refusals are part of the
  /// acknowledgment of the queue.
  [[nodiscard]] Refused add(const wire::Queue& queue);
  /// Adds rows. Ignores rows that arrive before their queue.
  void add(const wire::Rows& rows);

  /// Returns the queue that the last add() has opened; nullopt: none.
  [[nodiscard]] std::optional<wire::Queue> take_opened();
  /// Returns the rows that are now in order, and were not returned before.
  [[nodiscard]] std::vector<wire::Rows> take_rows();
  [[nodiscard]] std::vector<wire::QueueAck> acks(std::int64_t boot);

  [[nodiscard]] bool is_open(std::uint32_t queue) const { return queues_.contains(queue); }
  /// True if the queue is open and was not rejected.
  [[nodiscard]] bool accepts(std::uint32_t queue) const;
  /// True if the bank has enough rows for a start, or all of its rows.
  [[nodiscard]] bool is_filled(std::uint32_t queue, std::uint8_t bank) const;

  // The next three functions have no effect on a queue that is not open.
  void level(std::uint32_t queue, const QueueLevel& level);
  /// Rejects a row (index in its bank, from 0), or the whole queue (-1).
  void refuse(std::uint32_t queue, Refused refused, std::int64_t row = -1);
  /// Drops the rows of this bank that were not played. The next message of the bank has the number
  /// `seq`.
  void clear_bank(std::uint32_t queue, std::uint8_t bank, std::uint32_t seq);

  /// Drops all queues.
  void clear() { queues_.clear(); }

 private:
  struct OpenQueue {
    RowIntake intake;
    bool ack_due = true;
  };

  [[nodiscard]] Refused exceeds(const wire::Queue& queue) const;
  [[nodiscard]] OpenQueue* find(std::uint32_t queue);
  [[nodiscard]] const RowIntake* intake_of(std::uint32_t queue) const;

  QueueLimits limits_;
  std::map<std::uint32_t, OpenQueue> queues_;
  std::optional<wire::Queue> opened_;
  std::vector<wire::Rows> ready_;
};

}  // namespace jounce
