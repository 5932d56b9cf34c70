// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/row_intake.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jounce {
namespace {

/// True if each value that its order uses is finite; only a quadratic row may omit a v.
bool is_finite(const wire::Row& row) {
  const auto finite = [](double a, double b) { return std::isfinite(a) && std::isfinite(b); };
  const auto given = [](double v) { return std::isfinite(v) || std::isnan(v); };
  if (!finite(row.x_end, row.p_end)) return false;
  if (row.order == wire::RowOrder::linear) return true;
  if (row.order == wire::RowOrder::quadratic) return given(row.v_start) && given(row.v_end);
  return finite(row.v_start, row.v_end) &&
         (row.order == wire::RowOrder::cubic || finite(row.a_start, row.a_end));
}

}  // namespace

RowIntake::RowIntake(const wire::Queue& queue, std::uint32_t credit)
    : queue_(queue), credit_(credit) {}

std::uint32_t RowIntake::space(const Bank& bank) const {
  if (queue_.mode == wire::QueueMode::dynamic && &bank == &banks_[1]) return 0;
  const std::uint64_t waiting = bank.rows - std::min(bank.freed, bank.rows);
  return static_cast<std::uint32_t>(room(queue_) - std::min<std::uint64_t>(waiting, room(queue_)));
}

void RowIntake::add(const wire::Rows& rows) {
  if (refused_) return;
  Bank& bank = banks_[rows.bank];
  if (queue_.mode == wire::QueueMode::dynamic && rows.bank != 0)
    return refuse({wire::Refusal::bad_rows, "a dynamic queue has bank 0 only"});
  if (rows.seq < bank.next || rows.seq - bank.next >= credit_) return;
  bank.held.try_emplace(rows.seq, rows);
  advance(bank);
}

void RowIntake::advance(Bank& bank) {
  for (auto first = bank.held.begin(); first != bank.held.end() && first->first == bank.next;
       first = bank.held.begin()) {
    wire::Rows& rows = first->second;
    if (std::exchange(bank.resumes, false)) bank.begin = bank.freed = bank.rows = rows.first_row;
    if (!is_sound(bank, rows)) return;
    // Exceeds the available space: dropped, as if lost.
    if (rows.rows.size() > space(bank)) {
      bank.held.erase(first);
      return;
    }
    bank.rows += rows.rows.size();
    bank.x = rows.rows.back().x_end;
    bank.ended = rows.rows.back().last;
    ++bank.next;
    ready_.push_back(std::move(rows));
    bank.held.erase(first);
  }
}

/// Rejects the queue if a message does not continue at the end of the previous one.
bool RowIntake::is_sound(const Bank& bank, const wire::Rows& rows) {
  if (rows.first_row != bank.rows) {
    refuse({wire::Refusal::bad_rows, "message " + std::to_string(rows.seq) + " states that " +
                                         std::to_string(rows.first_row) + " rows precede it, but " +
                                         std::to_string(bank.rows) + " have arrived"});
    return false;
  }
  double x = bank.x;
  bool ended = bank.ended;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const wire::Row& row = rows.rows[i];
    const char* const rule = ended              ? "follows the last row"
                             : !is_finite(row)  ? "has a value that is not finite"
                             : !(row.x_end > x) ? "does not end later than the previous row"
                                                : nullptr;
    if (rule != nullptr) {
      const std::uint64_t number = bank.rows + i;
      refuse({wire::Refusal::bad_row, "row " + std::to_string(number + 1) + " " + rule},
             static_cast<std::int64_t>(number));
      return false;
    }
    x = row.x_end;
    ended = row.last;
  }
  return true;
}

std::vector<wire::Rows> RowIntake::take() {
  return std::exchange(ready_, {});
}

void RowIntake::clear(std::uint8_t number, std::uint32_t seq) {
  Bank& bank = banks_[number];
  bank.held.erase(bank.held.begin(), bank.held.lower_bound(seq));
  bank.next = std::max(bank.next, seq);
  bank.begin = bank.freed = bank.rows;
  bank.resumes = true;
  bank.ended = false;
  bank.x = 0;
  advance(bank);
}

bool RowIntake::level(const QueueLevel& level) {
  bool news = level.progress != level_.progress;
  for (std::size_t i = 0; i < banks_.size(); ++i) {
    Bank& bank = banks_[i];
    const std::uint64_t freed = std::clamp(level.freed[i], bank.freed, bank.rows);
    news |= freed != bank.freed;
    bank.freed = freed;
  }
  level_ = level;
  return news;
}

void RowIntake::refuse(Refused refused, std::int64_t row) {
  if (refused_) return;
  refused_ = std::move(refused);
  refused_row_ = row;
}

bool RowIntake::filled(std::uint8_t number) const {
  const Bank& bank = banks_[number];
  const std::uint64_t rows = bank.rows - bank.begin;
  return rows > 0 && (rows >= queue_.prefill || bank.ended);
}

wire::QueueAck RowIntake::ack(std::int64_t boot) const {
  wire::QueueAck ack{.boot = boot,
                     .queue = queue_.queue,
                     .played = level_.played,
                     .progress = level_.progress,
                     .refusal = refused_.refusal,
                     .row = refused_row_,
                     .reason = refused_.reason};
  for (std::size_t i = 0; i < banks_.size(); ++i) {
    const Bank& bank = banks_[i];
    ack.next[i] = bank.next;
    ack.space[i] = space(bank);
    for (const auto& [seq, rows] : bank.held)
      if (seq > bank.next) ack.mask[i] |= std::uint64_t{1} << (seq - bank.next - 1);
  }
  return ack;
}

}  // namespace jounce
