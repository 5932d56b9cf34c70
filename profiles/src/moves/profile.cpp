// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/profile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "jounce/profiles/detail/evaluate.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_root;

/// The state at the time dt (of either sign) after s, with the derivative of order `order` at
/// `value`.
Motion advanced(const MotionState& s, int order, double value, double t) {
  if (order == 1) return {s.position + t * value, value, 0, 0};
  if (order == 2)
    return {s.position + t * (s.velocity + t * (value / 2)), s.velocity + t * value, value, 0};
  const double jt = value * t;
  return {s.position + t * (s.velocity + t * (s.acceleration / 2 + jt / 6)),
          s.velocity + t * (s.acceleration + jt / 2), s.acceleration + jt, value};
}

/// The state at the other end of a phase. An acceleration that is zero except for rounding is set
/// to zero: it would act through a whole cruise.
MotionState passed(const MotionState& s, int order, const Profile::Phase& phase, double t) {
  const Motion m = advanced(s, order, phase.value, t);
  const bool is_rounding = std::abs(m.acceleration) <= 0x1p-48 * std::abs(s.acceleration);
  return {m.position, m.velocity, order == 3 && is_rounding ? 0 : m.acceleration};
}

Segment segment(const MotionState& begin, int order, const Profile::Phase& phase) {
  const double t = phase.duration;
  const Motion first = advanced(begin, order, phase.value, 0);
  Segment f;
  f.length = t;
  f.c = {first.position, first.velocity * t, first.acceleration * t * t / 2,
         first.jerk * t * t * t / 6};
  f.degree = first.jerk != 0 ? 3 : (first.acceleration != 0 ? 2 : 1);
  return f;
}

}  // namespace

std::uint8_t Profile::term_of(double value) noexcept {
  if (value == 0) return 0;
  std::size_t i = 0;
  while (i + 1 < level_.size() && level_[i] != value && level_[i] != 0) ++i;
  assert(level_[i] == value || level_[i] == 0);
  level_[i] = value;
  return static_cast<std::uint8_t>(i + 1);
}

void Profile::add(double duration, double value, double more) noexcept {
  if (!(duration > 0)) return;
  const auto code = static_cast<std::uint8_t>(term_of(value) + terms * term_of(more));
  if (count_ > 0 && code_[count_ - 1U] == code) {
    duration_[count_ - 1U] += duration;
    return;
  }
  assert(count_ < capacity);
  if (count_ == capacity) return;
  duration_[count_] = duration;
  code_[count_] = code;
  ++count_;
}

Profile Profile::scaled(double factor, const MotionState& start,
                        const MotionState& end) const noexcept {
  Profile f = *this;
  for (double& value : f.level_) value *= factor;
  f.start_ = start;
  f.end_ = end;
  return f;
}

Profile Profile::after(double t) const noexcept {
  const Motion now = at(t);
  Profile f(state_of(now), order_);
  f.level_ = level_;
  f.end_ = end_;
  for (std::size_t i = 0; i < count_; ++i) {
    const double left = std::min(duration_[i], duration_[i] - t);
    t -= std::min(t, duration_[i]);
    if (!(left > 0)) continue;
    f.duration_[f.count_] = left;
    f.code_[f.count_] = code_[i];
    ++f.count_;
  }
  return f;
}

double Profile::duration() const noexcept {
  double t = 0;
  for (std::size_t i = 0; i < count_; ++i) t += duration_[i];
  return t;
}

Motion Profile::at(double t) const noexcept {
  const double total = duration();
  if (!(t >= 0)) [[unlikely]] {
    if (std::isnan(t)) return point<OverTime>(profiles_detail::not_a_number);
    return {start_.position, start_.velocity, start_.acceleration, 0};
  }
  double left = total - t;
  if (!(left > 0)) return {end_.position, end_.velocity, end_.acceleration, 0};
  // The first half is computed from the start, the second backwards from the end, so small values
  // near both ends keep their digits.
  if (t < left) {
    MotionState s = start_;
    for (std::size_t i = 0;; ++i) {
      const Phase f = phase(i);
      if (t < f.duration || i + 1U == count_) return advanced(s, order_, f.value, t);
      s = passed(s, order_, f, f.duration);
      t -= f.duration;
    }
  }
  MotionState s = end_;
  for (std::size_t i = count_ - 1U;; --i) {
    const Phase f = phase(i);
    if (left <= f.duration || i == 0) return advanced(s, order_, f.value, -left);
    s = passed(s, order_, f, -f.duration);
    left -= f.duration;
  }
}

Trajectory Profile::curve() const {
  std::vector<Segment> segments;
  segments.reserve(count_);
  // A phase as short as the rounding of its end time is not a segment.
  const auto has_length = [](double length, double end) { return length > 0x1p-50 * end; };
  // The first half (at least one phase) is built from the start, the rest backwards from the end.
  // So each half is exact at its own end, and the rounding error is in the middle.
  const double total = duration();
  MotionState forward = start_;
  double t = 0;
  std::size_t i = 0;
  for (; i < count_ && (i == 0 || t + duration_[i] <= total / 2); ++i) {
    t += duration_[i];
    if (has_length(duration_[i], t)) segments.push_back(segment(forward, order_, phase(i)));
    forward = passed(forward, order_, phase(i), duration_[i]);
  }
  const std::size_t middle = segments.size();
  MotionState backward = end_;
  t = total;
  for (std::size_t k = count_; k-- > i; t -= duration_[k]) {
    backward = passed(backward, order_, phase(k), -duration_[k]);
    if (has_length(duration_[k], t)) segments.push_back(segment(backward, order_, phase(k)));
  }
  std::reverse(segments.begin() + static_cast<std::ptrdiff_t>(middle), segments.end());
  // A cruise in the middle absorbs the difference, if its velocity hardly changes. Otherwise the
  // position steps by the rounding of its value: far from 0, a velocity that absorbs it would exceed
  // the velocity limit.
  if (middle < segments.size() && segments[middle].degree == 1) {
    Segment& cruise = segments[middle];
    const Segment joined = line(cruise.length, forward.position, cruise.c[0] + cruise.c[1]);
    if (std::abs(joined.c[1] - cruise.c[1]) <= rounded_root * std::abs(cruise.c[1]))
      cruise = joined;
  }
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

}  // namespace jounce
