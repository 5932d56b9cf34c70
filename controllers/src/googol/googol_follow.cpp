// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/googol/googol_follow.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::googol {
namespace {

constexpr std::size_t small_each = 16;
constexpr std::size_t large_each = 512;

}  // namespace

FollowFifos::FollowFifos(std::size_t most)
    : fifos_(std::max(most, large_each)), most_(std::max(most, large_each)) {
  reset();
}

void FollowFifos::reset() {
  const std::size_t each = memory_ == small ? small_each : large_each;
  if (memory_ == dynamic)
    fifos_.reset({.each = max_segments_, .total = max_segments_, .stream = false});
  else
    fifos_.reset({.each = each, .total = 2 * each, .stream = false});
}

Refusal FollowFifos::when_at_rest() const {
  if (!follow_) return Refusal::wrong_mode;
  return busy() ? Refusal::moving : Refusal::none;
}

Refusal FollowFifos::prf_follow(int dir) {
  if (busy()) return Refusal::moving;
  if (std::abs(dir) > 1) return Refusal::bad_argument;
  follow_ = true;
  run_.dir = dir;
  reset();
  return Refusal::none;
}

Refusal FollowFifos::set_follow_master(int master) {
  if (const Refusal refusal = when_at_rest(); refusal != Refusal::none) return refusal;
  if (master < 1) return Refusal::bad_argument;
  master_ = master;
  return Refusal::none;
}

Refusal FollowFifos::set_follow_loop(std::int64_t loops) {
  if (!follow_) return Refusal::wrong_mode;
  fifos_.set_loops(loops);
  return Refusal::none;
}

Refusal FollowFifos::set_follow_event(const FollowStart& start) {
  if (const Refusal refusal = when_at_rest(); refusal != Refusal::none) return refusal;
  if (!std::isfinite(start.position) || std::abs(start.direction) != 1)
    return Refusal::bad_argument;
  run_.event = start;
  return Refusal::none;
}

Refusal FollowFifos::set_follow_max_segment(std::size_t segments) {
  if (const Refusal refusal = when_at_rest(); refusal != Refusal::none) return refusal;
  if (segments < 1 || segments > most_) return Refusal::bad_argument;
  max_segments_ = segments;
  return Refusal::none;
}

Refusal FollowFifos::set_follow_memory(int memory) {
  if (const Refusal refusal = when_at_rest(); refusal != Refusal::none) return refusal;
  if (memory < small || memory > dynamic) return Refusal::bad_argument;
  if (memory == dynamic && max_segments_ == 0) return Refusal::bad_argument;
  memory_ = static_cast<Memory>(memory);
  reset();
  return Refusal::none;
}

std::size_t FollowFifos::follow_space(int fifo) const {
  return follow_ && is_fifo(fifo) ? fifos_.space(fifo) : 0;
}

Refusal FollowFifos::follow_data(const PtPoint& point, int fifo) {
  if (!follow_) return Refusal::wrong_mode;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  return refusal_of(push(fifos_, fifo, point));
}

Refusal FollowFifos::follow_clear(int fifo) {
  if (!follow_) return Refusal::wrong_mode;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  return fifos_.clear(fifo) ? Refusal::none : Refusal::in_use;
}

Refusal FollowFifos::follow_start(int fifo, double master, double slave) {
  if (const Refusal refusal = when_at_rest(); refusal != Refusal::none) return refusal;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  if (master_ == 0) return Refusal::no_master;
  if (fifos_.size(fifo) == 0) return Refusal::empty;
  if (!std::isfinite(master) || !std::isfinite(slave)) return Refusal::bad_argument;
  fifos_.take(fifo);
  begin(run_, fifos_, master, slave);
  return Refusal::none;
}

Refusal FollowFifos::follow_switch(int fifo) {
  if (!follow_) return Refusal::wrong_mode;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  if (!fifos_.moving()) return Refusal::not_moving;
  if (fifo == fifos_.active()) return Refusal::in_use;
  if (fifos_.size(fifo) == 0) return Refusal::empty;
  fifos_.queue_switch();
  return Refusal::none;
}

Jet FollowFifos::step(const Sample& before, const Sample& now) {
  return jounce::step(run_, fifos_, before, now);
}

}  // namespace jounce::googol
