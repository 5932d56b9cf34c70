// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/master.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce {

TableMaster::TableMaster(std::shared_ptr<const Table> table, double start)
    : table_(std::move(table)), start_(start) {
  if (table_->axis() != Domain::time)
    throw InputError("axis", name(table_->axis()), "must be time: a master is a function of time");
  require_finite("start", start);
}

Jet TableMaster::at(double time) noexcept {
  const double at = table_->start() + (time - start_);
  if (!(at >= table_->start())) return {table_->jet(table_->start())[0], 0, 0, 0};
  if (at <= table_->end() || repeats(table_->outside())) return table_->jet(at);
  return {table_->jet(table_->end(), Side::left)[0], 0, 0, 0};
}

void EncoderMaster::read(double time, double position) noexcept {
  tracked_.see(time, position);
  read_ = true;
  reading_ = {.received = time, .position = position};
}

Jet EncoderMaster::at(double time) noexcept {
  if (position_) read(time, position_());
  was_read_ = std::exchange(read_, false);
  taken_ = reading_;
  return tracked_.at(time);
}

double ClockOffset::local(const MasterSample& sample, bool& same) noexcept {
  if (!known || sample.clock != clock) base = sample.stamp_ns;
  const double stamp = static_cast<double>(sample.stamp_ns - base) / 1e9;
  const double seen = sample.received - stamp;
  same = known && sample.clock == clock;
  if (same && sample.received - half_since > window / 2) {
    least_before = std::exchange(least_now, seen);
    half_since = sample.received;
  }
  least_now = std::min(least_now, seen);
  const double least = std::min(least_before, least_now);  // (1)
  if (same && std::abs(least - offset) > step) same = false;
  if (!same) {
    offset = least_before = least_now = seen;
    half_since = sample.received;
  } else {
    const double most = slew * std::max(sample.received - last, 0.0);
    offset += std::clamp(least - offset, -most, most);
  }
  clock = sample.clock;
  known = true;
  last = sample.received;
  return stamp + offset;
}

Jet ExternalMaster::at(double time) noexcept {
  count_ = 0;
  for (MasterSample sample; count_ < most && samples_.pop(sample);) {
    taken_[count_++] = sample;
    if (!sample.valid || !std::isfinite(sample.received)) {
      tracked_.lose();
      continue;
    }
    bool same = true;
    const double local = clock_.local(sample, same);
    if (!same) tracked_.lose();
    tracked_.see(local, sample.position);
  }
  return tracked_.at(time);
}

}  // namespace jounce
