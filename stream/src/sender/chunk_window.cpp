// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/chunk_window.hpp"

#include <algorithm>

namespace jounce {

ChunkWindow::ChunkWindow(std::uint32_t chunks, Pace pace) : pace_(pace), chunks_(chunks) {}

bool ChunkWindow::acknowledge(const wire::Ack& ack, Nanos now) {
  const auto count = static_cast<std::uint32_t>(chunks_.size());
  if (ack.next > count) return false;
  credit_ = ack.credit;
  bool news = false;
  for (std::uint32_t seq = next_; seq < ack.next; ++seq) news |= mark(seq, now);
  for (std::uint32_t i = 0; i < 64 && ack.next + 1 + i < count; ++i)
    if ((ack.mask >> i & 1U) != 0) news |= mark(ack.next + 1 + i, now);
  while (next_ < count && chunks_[next_].arrived) ++next_;
  if (news) back_off_ = 0;
  return news;
}

bool ChunkWindow::mark(std::uint32_t seq, Nanos now) {
  State& chunk = chunks_[seq];
  if (chunk.arrived) return false;
  chunk.arrived = true;
  ++arrived_;
  // For a chunk sent twice, the ack does not show which transmission arrived; an ack soon after the
  // last one is hardly for that.
  if (chunk.times == 1) measure(now - chunk.sent);
  if (chunk.times == 1 || now - chunk.sent >= round_trip_ / 2)
    newest_ = std::max(newest_, chunk.order);
  return true;
}

void ChunkWindow::measure(Nanos round_trip) {
  if (!measured_) {
    round_trip_ = round_trip;
    deviation_ = round_trip / 2;
    measured_ = true;
    return;
  }
  const Nanos error = std::max(round_trip_ - round_trip, round_trip - round_trip_);
  deviation_ = (3 * deviation_ + error) / 4;
  round_trip_ = (7 * round_trip_ + round_trip) / 8;
}

Nanos ChunkWindow::patience() const {
  const Nanos once = std::max(pace_.resend, round_trip_ + 4 * deviation_);
  return std::max(once, std::min(pace_.slowest, once * (1 << std::min(back_off_, 10U))));
}

std::vector<std::uint32_t> ChunkWindow::due(Nanos now) {
  const auto count = static_cast<std::uint32_t>(chunks_.size());
  const std::uint32_t end = next_ + std::min({pace_.window, credit_, count - next_});
  const Nanos late = patience();
  const Nanos hole = std::max(pace_.fast_resend, round_trip_);
  bool any_late = false;
  std::vector<std::uint32_t> due;
  for (std::uint32_t seq = next_; seq < end; ++seq) {
    State& chunk = chunks_[seq];
    if (chunk.arrived) continue;
    const Nanos age = now - chunk.sent;
    if (chunk.times > 0) {
      const bool overtaken = chunk.order < newest_ && age >= hole;
      if (!overtaken && (age < late || (any_late && back_off_ == 0))) continue;
      any_late |= !overtaken || age >= late;
      ++resent_;
    }
    chunk.sent = now;
    chunk.order = ++sent_;
    ++chunk.times;
    due.push_back(seq);
  }
  if (any_late) ++back_off_;
  return due;
}

}  // namespace jounce
