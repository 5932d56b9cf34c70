// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/row_window.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace jounce {

RowWindow::RowWindow(const wire::Queue& queue, std::uint8_t bank, Pace pace)
    : queue_(queue.queue), bank_(bank), pace_(pace) {}

std::size_t RowWindow::wants() const {
  const std::size_t messages =
      pace_.window - std::min<std::size_t>(under_way_.size(), pace_.window);
  return std::min<std::size_t>(limit_ - pushed_, messages * wire::rows_each);
}

void RowWindow::push(std::vector<wire::Row> rows) {
  assert(!rows.empty() && rows.size() <= wire::rows_each && rows.size() <= wants());
  const std::size_t count = rows.size();
  const auto seq = next_ + static_cast<std::uint32_t>(under_way_.size());
  under_way_.push_back({.rows = {queue_, bank_, seq, pushed_, std::move(rows)}});
  pushed_ += count;
}

void RowWindow::acknowledge(const wire::QueueAck& ack) {
  const std::uint32_t next = ack.next[bank_];
  if (next < next_ || next - next_ > under_way_.size()) return;
  for (std::uint32_t i = next - next_; i > 0; --i) {
    before_ += under_way_.front().rows.rows.size();
    under_way_.pop_front();
    ++next_;
    back_off_ = 0;
  }
  for (std::size_t i = 0; i < 64 && i + 1 < under_way_.size(); ++i)
    if ((ack.mask[bank_] >> i & 1U) != 0) under_way_[i + 1].arrived = true;
  limit_ = std::max(limit_, before_ + ack.space[bank_]);
}

std::vector<wire::Rows> RowWindow::due(Nanos now) {
  const auto last_arrived = std::find_if(under_way_.rbegin(), under_way_.rend(),
                                         [](const Sent& sent) { return sent.arrived; });
  const auto holes = static_cast<std::size_t>(under_way_.rend() - last_arrived);  // below it
  const Nanos late = std::min(pace_.slowest, pace_.resend * (1 << std::min(back_off_, 10U)));
  bool any_late = false;
  std::vector<wire::Rows> due;
  for (std::size_t i = 0; i < under_way_.size(); ++i) {
    Sent& sent = under_way_[i];
    const Nanos wait = i < holes ? std::min(late, pace_.fast_resend) : late;
    if (sent.arrived || (sent.times > 0 && now - sent.at < wait)) continue;
    if (sent.times > 0) ++resent_;
    any_late |= sent.times > 0 && now - sent.at >= late;
    sent.at = now;
    ++sent.times;
    due.push_back(sent.rows);
  }
  if (any_late) ++back_off_;
  return due;
}

}  // namespace jounce
