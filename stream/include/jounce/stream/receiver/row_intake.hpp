// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/message/refusal.hpp"

namespace jounce {

/// Progress of an executor with a queue. Two numbers: one for each bank.
struct QueueLevel {
  std::array<std::uint64_t, 2> freed{};  ///< rows freed since it was opened
  std::int64_t played = 0;               ///< rows played to their end since it was opened
  wire::Progress progress = wire::Progress::none;
};

/// The arriving rows of one queue: sorted, checked, and never more than fit the free space. Holds
/// at most `credit` messages that have overtaken others.
class RowIntake {
 public:
  RowIntake(const wire::Queue& queue, std::uint32_t credit);

  /// Takes the rows that fit. Rows received before have no effect.
  void add(const wire::Rows& rows);

  /// Returns the rows that are now in order, each once; of both banks.
  [[nodiscard]] std::vector<wire::Rows> take();

  /// Drops the rows of this bank that are not played; its messages count again from `seq`.
  void clear(std::uint8_t bank, std::uint32_t seq);

  /// Returns true if there is something new to acknowledge.
  bool level(const QueueLevel& level);
  /// The first refusal stays.
  void refuse(Refused refused, std::int64_t row = -1);

  [[nodiscard]] wire::QueueAck ack(std::int64_t boot) const;
  /// True if there are enough rows for a start, or all.
  [[nodiscard]] bool filled(std::uint8_t bank) const;
  [[nodiscard]] const wire::Queue& queue() const { return queue_; }
  [[nodiscard]] bool refused() const { return static_cast<bool>(refused_); }

 private:
  struct Bank {
    std::uint32_t next = 0;   // message
    std::uint64_t rows = 0;   // rows before the next message
    std::uint64_t freed = 0;  // rows of these that were freed
    std::uint64_t begin = 0;  // first row since the last clear
    bool resumes = false;     // the next message repeats the number of rows before it
    bool ended = false;       // its last row was marked as last
    double x = 0;             // x at the end of its last row
    std::map<std::uint32_t, wire::Rows> held;  // at most credit_
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
