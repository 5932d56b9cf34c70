#include "jounce/pvt/segment_fifos.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/pvt/detail/pt_link.hpp"

namespace jounce {

SegmentFifos::SegmentFifos(std::size_t most) {
  for (Fifo& fifo : fifos_) fifo.slots.resize(most);
}

void SegmentFifos::reset(const Layout& layout) {
  assert(!moving() && layout.each <= fifos_[0].slots.size());
  layout_ = layout;
  state_ = State::idle;
  for (Fifo& fifo : fifos_) fifo.size = 0;
  base_ = {};
  filling_ = active_ = 0;
  queued_ = false;
  passes_ = 0;
}

std::size_t SegmentFifos::space(int fifo) const {
  const auto left = [&](int i) { return layout_.each - size(i); };
  const std::size_t together = layout_.total - size(0) - size(1);
  if (!layout_.stream) return std::min(left(fifo), together);
  const int other = 1 - filling_;  // it takes over where it is empty
  return std::min(left(filling_) + (size(other) == 0 ? layout_.each : 0), together);
}

bool SegmentFifos::in_use(int fifo) const {
  return moving() && (layout_.stream || fifo == active_);
}

PtPoint SegmentFifos::last_pushed(int fifo) const {
  const auto last = [&](int i) { return fifos_[index(i)].slots[fifos_[index(i)].size - 1].point; };
  if (!layout_.stream) return size(fifo) > 0 ? last(fifo) : PtPoint{};
  if (size(filling_) > 0) return last(filling_);
  return size(1 - filling_) > 0 ? last(1 - filling_) : base_;
}

bool SegmentFifos::follows_on(int fifo, const PtPoint& point) const {
  return std::isfinite(point.x) && std::isfinite(point.position) && point.x > last_pushed(fifo).x;
}

void SegmentFifos::push(int fifo, const PtPoint& point) {
  assert(space(fifo) > 0 && follows_on(fifo, point));
  if (layout_.stream) {
    if (size(filling_) == layout_.each) filling_ = 1 - filling_;
    fifo = filling_;
  } else if (in_use(fifo)) {  // its passes so far were shorter than those to come
    table_ = origin_;
    turns_ = 0;
    known_rates_ = 0;
  }
  Fifo& to = fifos_[index(fifo)];
  to.slots[to.size++] = {point, 0};
}

void SegmentFifos::clear(int fifo) {
  assert(!in_use(fifo));
  fifos_[index(fifo)].size = 0;
  if (!layout_.stream) return;
  fifos_[index(1 - fifo)].size = 0;
  base_ = {};
  filling_ = active_ = 0;
}

void SegmentFifos::start(int fifo, double x, double position) {
  assert(!moving());
  if (!layout_.stream) active_ = fifo;
  assert(playing().size > 0);
  table_ = origin_ = {x, position};
  position_ = position;
  turns_ = 0;
  known_rates_ = 0;
  passes_ = 0;
  queued_ = false;
  rate_ = 0;
  state_ = State::moving;
  enter(0, true);
}

void SegmentFifos::queue_switch() {
  assert(moving() && !layout_.stream && size(1 - active_) > 0);
  queued_ = true;
}

PtPoint SegmentFifos::before(std::size_t slot) const {
  return slot > 0 ? playing().slots[slot - 1].point : base_;
}

/// Begins a segment with the rate that the one before ended with.
void SegmentFifos::enter(std::size_t slot, bool first) {
  slot_ = slot;
  Slot& at = playing().slots[slot];
  at.start_rate = detail::pt_link(before(slot), at.point, first, rate_).rate.start;
}

/// A segment once entered is `continued` from the rate it was entered with, whatever its type;
/// `even` and `stop` have their own.
double SegmentFifos::end_rate() const {
  const Slot& at = playing().slots[slot_];
  return detail::pt_link(before(slot_), at.point, false, at.start_rate).rate.end;
}

void SegmentFifos::next() {
  rate_ = end_rate();
  if (slot_ + 1 < playing().size)
    enter(slot_ + 1, false);
  else if (layout_.stream)
    end_stream_fifo();
  else
    end_pass();
}

void SegmentFifos::end_stream_fifo() {
  const PtPoint last = playing().slots[slot_].point;
  const bool more = size(1 - active_) > 0;
  if (!more) return stop();
  base_ = last;
  playing().size = 0;
  active_ = 1 - active_;
  enter(0, false);
}

void SegmentFifos::take_turns(std::int64_t turns) {
  const PtPoint last = playing().slots[playing().size - 1].point;
  turns_ += turns;
  const auto all = static_cast<double>(turns_);
  origin_ = {table_.x + all * last.x, table_.position + all * last.position};
}

void SegmentFifos::end_pass() {
  ++passes_;
  const bool again = loops_ < 1 || passes_ < loops_;
  if (!queued_ && !again) return stop();
  take_turns(1);
  if (queued_) {
    playing().size = 0;
    active_ = 1 - active_;
    queued_ = false;
    passes_ = 0;
    table_ = origin_;
    turns_ = 0;
    known_rates_ = 0;
  } else {
    pass_rates_ = {pass_rates_[1], pass_rates_[2], rate_};
    known_rates_ = std::min(known_rates_ + 1, 3);
  }
  enter(0, true);
}

/// The rate r with which a pass ends depends on the one before as s r + c: s is 0 where any segment
/// has a rate of its own, otherwise 1 or -1. So two passes change it by the same each time.
void SegmentFifos::skip_passes(double x) {
  if (layout_.stream || queued_ || slot_ != 0 || known_rates_ < 3) return;
  constexpr double countable = 9007199254740992;  // 2^53: beyond, the place in the pass is rounding
  const double ahead = (x - origin_.x) / playing().slots[playing().size - 1].point.x;
  if (!(ahead >= 4)) return;
  auto passes = static_cast<std::int64_t>(std::min(ahead, countable)) - 2;
  if (loops_ < 1 && ahead >= countable) return lose();
  if (loops_ >= 1) passes = std::min(passes, loops_ - 1 - passes_);
  if (passes < 2) return;
  const std::int64_t pairs = passes / 2;
  rate_ += static_cast<double>(pairs) * (rate_ - pass_rates_[0]);
  known_rates_ = 0;
  passes_ += 2 * pairs;
  take_turns(2 * pairs);
  enter(0, true);
}

/// Stands where the last segment ends. A stream is used up; a table is kept.
void SegmentFifos::stop() {
  constexpr double rounding = 1e-9;  // what a chain of quotients leaves where it comes to rest
  const Slot& at = playing().slots[slot_];
  const bool rests = std::abs(rate_) <= rounding * std::abs(at.start_rate - rate_);
  state_ = rests ? State::ended : State::cut_off;
  origin_.position += at.point.position;
  if (layout_.stream) clear(0);
}

void SegmentFifos::lose() {
  state_ = State::lost;
  origin_.position = position_;
  queued_ = false;
  if (layout_.stream) clear(0);
}

Jet SegmentFifos::here(double u) const {
  const Slot& at = playing().slots[slot_];
  const PtPoint from = before(slot_);
  const Segment segment = detail::segment_of(detail::pt_link(from, at.point, false, at.start_rate));
  Jet f = evaluate(segment, std::clamp((u - from.x) / segment.length, 0.0, 1.0));
  f[0] += origin_.position;
  return f;
}

Jet SegmentFifos::at(double x) {
  if (moving() && !std::isfinite(x)) lose();
  while (moving() && x - origin_.x >= playing().slots[slot_].point.x) {
    next();
    if (moving()) skip_passes(x);
  }
  const Jet f = moving() ? in_pass(x - origin_.x) : Jet{origin_.position, 0, 0, 0};
  position_ = f[0];
  return f;
}

Jet SegmentFifos::in_pass(double u) {
  while (slot_ > 0 && u < before(slot_).x) --slot_;
  if (u < before(0).x) return {origin_.position + before(0).position, 0, 0, 0};
  return here(u);
}

}  // namespace jounce
