#include "jounce/gear/googol_follow.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::googol {
namespace {

constexpr std::size_t small_each = 16;
constexpr std::size_t large_each = 512;

bool is_fifo(int fifo) {
  return fifo == 0 || fifo == 1;
}

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
  dir_ = dir;
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
  event_ = start;
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
  if (fifos_.space(fifo) == 0) return Refusal::full;
  if (!fifos_.follows_on(fifo, point)) return Refusal::bad_argument;
  fifos_.push(fifo, point);
  return Refusal::none;
}

Refusal FollowFifos::follow_clear(int fifo) {
  if (!follow_) return Refusal::wrong_mode;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  const bool awaited = waiting_ && fifo == first_;
  const bool next = fifos_.switch_queued() && fifo != fifos_.active();
  if (awaited || next || fifos_.in_use(fifo)) return Refusal::in_use;
  fifos_.clear(fifo);
  return Refusal::none;
}

Refusal FollowFifos::follow_start(int fifo, double master, double slave) {
  if (const Refusal refusal = when_at_rest(); refusal != Refusal::none) return refusal;
  if (!is_fifo(fifo)) return Refusal::bad_argument;
  if (master_ == 0) return Refusal::no_master;
  if (fifos_.size(fifo) == 0) return Refusal::empty;
  if (!std::isfinite(master) || !std::isfinite(slave)) return Refusal::bad_argument;
  first_ = fifo;
  slave_ = slave;
  waiting_ = event_.event == FollowEvent::pass;
  if (!waiting_) begin(master);
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

void FollowFifos::begin(double master) {
  waiting_ = false;
  origin_ = master;
  furthest_ = 0;
  fifos_.start(first_, 0, slave_);
}

/// How far along its tables the slave is: where one direction alone counts, as far as it ever was.
double FollowFifos::travel(double master) {
  const double gone = master - origin_;
  if (dir_ == 0 || !std::isfinite(gone)) return gone;
  furthest_ = std::max(furthest_, dir_ * gone);
  return furthest_;
}

Jet FollowFifos::step(const Sample& before, const Sample& now) {
  if (waiting_)
    if (const auto at = begin_of(event_, before, now)) begin(at->master[0]);
  if (waiting_) return {slave_, 0, 0, 0};
  const double behind = furthest_ - dir_ * (now.master[0] - origin_);
  const bool back = behind > 0 || (behind == 0 && dir_ * now.master[1] < 0);
  Jet f = fifos_.at(travel(now.master[0]));
  if (dir_ != 0 && back) return {f[0], 0, 0, 0};
  if (dir_ < 0) f = {f[0], -f[1], f[2], -f[3]};  // by the master, which runs backwards
  return f;
}

}  // namespace jounce::googol
