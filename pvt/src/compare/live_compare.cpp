// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/live_compare.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/profiles/curve/cycle_motion.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

// The walk of position_compare.cpp from the instant of one point to that of the next, piece by
// piece. Between two pieces it remembers on which side of the next point the axis was.

namespace jounce {

LiveCompare::LiveCompare(const PositionCompare& compare)
    : compare_(compare),
      pulses_(compare.mode == CompareMode::fifo_time || compare.mode == CompareMode::linear) {
  require_valid(compare);
  found_.reserve(8);
}

void LiveCompare::arm() {
  armed_ = true;
  next_ = 0;
  side_.reset();
  if (step_.output) off_in_ = 0;
}

const CompareStep& LiveCompare::step(double position, double velocity, double dt) {
  assert(dt > 0);
  elapsed_ += dt;
  step_.count = step_.lost = 0;
  if (std::isfinite(position)) {
    move(position, velocity);
    fire(dt);
  } else {
    piece_ = line(dt, position_, position_);
  }
  end_pulse(dt, dt);
  if (std::isfinite(position)) elapsed_ = 0;
  if (off_in_) *off_in_ -= dt;
  return step_;
}

/// Sets the piece from the previous position to this one, or the position alone if it is the first.
void LiveCompare::move(double position, double velocity) {
  const double from = placed_ ? position_ : position;
  const double mean = (position - from) / elapsed_;
  const bool known = std::isfinite(velocity) && std::isfinite(velocity_);
  piece_ = placed_ && known ? cycle_motion(from, velocity_, position, velocity, elapsed_)
                            : line(elapsed_, from, from + mean * elapsed_);
  const bool stood = position == from && velocity == 0 && velocity_ == 0;
  s_ = placed_ && !stood ? 0 : 1;
  if (!placed_) side_.reset();
  placed_ = true;
  position_ = position;
  velocity_ = velocity;
}

void LiveCompare::fire(double dt) {
  while (armed_ && next_ < compare_.points.size()) {
    const ComparePoint& point = compare_.points[next_];
    const auto s = reach(point.position);
    if (!s) return;
    ++next_;
    pass(point, *s, dt);
  }
}

/// The first s at or after s_ at which the piece has this value.
std::optional<double> LiveCompare::reach(double level) {
  const double flat = profiles_detail::two_roundings * (magnitude(piece_) + std::abs(level));
  const double here = value(piece_, s_) - level;
  const bool met = (compare_.mode == CompareMode::less && here < 0) ||
                   (compare_.mode == CompareMode::greater && here > 0);
  // At the end of the previous piece, missed by rounding.
  const bool passed = side_ && *side_ * here < 0;
  side_ = here;
  if (std::abs(here) <= flat || passed || met) return arrive(s_);
  if (s_ < 1) {
    Segment g = piece_;
    g.c[0] -= level;
    found_.clear();
    roots(g, flat, found_);
    const auto next = std::upper_bound(found_.begin(), found_.end(), s_);
    if (next != found_.end()) return arrive(*next);
    side_ = value(piece_, 1) - level;
    if (std::abs(*side_) <= flat) return arrive(1);
  }
  s_ = 1;
  return std::nullopt;
}

std::optional<double> LiveCompare::arrive(double s) {
  s_ = s;
  side_.reset();
  return s;
}

/// The axis passes a point at the part s of the piece.
void LiveCompare::pass(const ComparePoint& point, double s, double dt) {
  const double time = std::clamp(s * elapsed_ - (elapsed_ - dt), 0.0, std::nextafter(dt, 0));
  end_pulse(time, dt);
  const bool on = pulses_ || point.level;
  if (on != step_.output) {
    const double here = value(piece_, s);
    const double near = profiles_detail::rounded_input * (magnitude(piece_) + std::abs(here));
    emit(time, on, std::abs(here - point.position) <= near ? point.position : here);
  }
  if (pulses_) off_in_ = time + compare_.pulse;  // extends a pulse that is still on
}

/// Ends a pulse whose end is before that time.
void LiveCompare::end_pulse(double before, double dt) {
  if (!off_in_ || !(*off_in_ < before)) return;
  const double time = std::max(*off_in_, 0.0);
  emit(time, false, position_at(time, dt));
  off_in_.reset();
}

/// The position in this step, of the duration dt.
double LiveCompare::position_at(double time, double dt) const {
  return value(piece_, std::clamp(1 + (time - dt) / elapsed_, 0.0, 1.0));
}

void LiveCompare::emit(double time, bool on, double position) {
  step_.output = on;
  if (step_.count == CompareStep::most_edges)
    ++step_.lost;
  else
    step_.edge[step_.count++] = {time, on, position};
}

}  // namespace jounce
