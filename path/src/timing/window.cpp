// SPDX-License-Identifier: Apache-2.0
#include "path/src/timing/window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

// s(t) is the average of a law s0 of second order over a window w. With accelerations up to A0,
//
//   (1)  |s(t) - s0(t)| <= A0 w^2 / 24
//
// A cap V over an interval of the path is extended by d = V w / 2 + A0 w^2 / 24 at both ends.
// Inside this zone, s0 moves by at most V w / 2 in half a window. So no instant of a window around
// a t with s(t) in the interval exceeds V. Accelerations average to at most A0. A local maximum of
// the velocity lasts at least w (because it is lowered), and a local minimum lasts 2 d / V >= w. So
// no window contains accelerations of both signs, and |jerk| <= A0 / w.
//
// Lowering: F(q) is the greatest p such that q lies in an interval of length >= p w
// over which v >= p.

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_root;

/// A corner of the profile: B = v^2 is linear between neighbors, with a slope of 0 or +-2 A0.
struct Knot {
  double q, v;
};

struct Interval {
  double from, to, velocity;
};

/// The lower envelope of the caps, each extended by (1) on both sides: intervals of constant
/// velocity with ascending places.
std::vector<Interval> envelope(std::span<const CappedLength> caps, double acceleration,
                               double window) {
  std::vector<Interval> wide;
  wide.reserve(caps.size());
  double at = 0;
  double whole = 0;
  for (const CappedLength& c : caps) whole += c.length;
  for (const CappedLength& c : caps) {
    const double d = c.velocity * window / 2 + acceleration * window * window / 24;
    wide.push_back({std::max(0.0, at - d), std::min(whole, at + c.length + d), c.velocity});
    at += c.length;
  }
  const auto begins = [](const Interval& a, const Interval& b) { return a.from < b.from; };
  if (!std::is_sorted(wide.begin(), wide.end(), begins))
    std::sort(wide.begin(), wide.end(), begins);
  // The slowest of the intervals that have begun is on top. Those that have ended stay in the heap
  // until they are on top.
  const auto faster = [](const Interval* a, const Interval* b) {
    return a->velocity > b->velocity;
  };
  std::vector<const Interval*> heap;
  std::vector<Interval> out;
  out.reserve(wide.size());
  double q = 0;
  for (std::size_t i = 0; i < wide.size() || !heap.empty();) {
    for (; i < wide.size() && wide[i].from <= q; ++i) {
      heap.push_back(&wide[i]);
      std::push_heap(heap.begin(), heap.end(), faster);
    }
    while (!heap.empty() && heap.front()->to <= q) {
      std::pop_heap(heap.begin(), heap.end(), faster);
      heap.pop_back();
    }
    if (heap.empty()) {
      if (i < wide.size()) q = wide[i].from;
      continue;
    }
    const Interval& slowest = *heap.front();
    // Up to its end, or to the start of a slower one.
    while (i < wide.size() && wide[i].from < slowest.to && wide[i].velocity >= slowest.velocity) {
      heap.push_back(&wide[i++]);
      std::push_heap(heap.begin(), heap.end(), faster);
    }
    const double next = i < wide.size() ? std::min(wide[i].from, slowest.to) : slowest.to;
    if (!out.empty() && out.back().velocity == slowest.velocity)
      out.back().to = next;
    else
      out.push_back({q, next, slowest.velocity});
    q = next;
  }
  return out;
}

/// The fastest law of second order under an envelope, from rest to rest.
std::vector<Knot> fastest(std::span<const Interval> caps, double acceleration) {
  const std::size_t n = caps.size();
  const auto reach = [&](double v, double length) {
    return std::sqrt(v * v + 2 * acceleration * length);
  };
  std::vector<double> v(n + 1, 0.0);
  for (std::size_t i = 1; i < n; ++i) v[i] = std::min(caps[i - 1].velocity, caps[i].velocity);
  for (std::size_t i = 0; i + 1 < n; ++i)
    v[i + 1] = std::min(v[i + 1], reach(v[i], caps[i].to - caps[i].from));
  for (std::size_t i = n; i-- > 1;)
    v[i] = std::min(v[i], reach(v[i + 1], caps[i].to - caps[i].from));
  // A maximum has two knots, possibly at the same place: lowering it moves both.
  std::vector<Knot> knots;
  knots.reserve(4 * n + 1);
  knots.push_back({caps.front().from, 0});
  const auto add = [&](double q, double speed) {
    knots.push_back({std::max(q, knots.back().q), speed});
  };
  for (std::size_t i = 0; i < n; ++i) {
    const auto [from, to, top] = caps[i];
    const double free =
        std::sqrt((v[i] * v[i] + v[i + 1] * v[i + 1]) / 2 + acceleration * (to - from));
    const double peak = std::max({std::min(top, free), v[i], v[i + 1]});
    const auto way = [&](double speed) {
      return (peak - speed) * (peak + speed) / (2 * acceleration);
    };
    if (peak > v[i]) add(std::min(to, from + way(v[i])), peak);
    if (peak > v[i + 1]) add(std::min(to, to - way(v[i + 1])), peak);
    add(to, v[i + 1]);
    if (i + 1 < n) add(to, v[i + 1]);
  }
  return knots;
}

/// The function F: lowers each local maximum that is too short. `out` is the profile up to the last
/// knot that was read. A maximum is examined when the profile falls after it.
class Lowering {
 public:
  Lowering(std::vector<Knot> knots, double acceleration, double window)
      : in_(std::move(knots)), a_(acceleration), w_(window) {}

  std::vector<Knot> run() {
    const std::size_t n = in_.size();
    previous_.resize(n);
    next_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      previous_[i] = i - 1;
      next_[i] = i + 1;
    }
    std::size_t i = next_[0];
    while (i < n) {
      if (next_[i] < n && in_[next_[i]].v < in_[i].v && rises_to(i))
        i = lower(i);
      else
        i = next_[i];
    }
    std::vector<Knot> out;
    for (i = 0; i < n; i = next_[i]) out.push_back(in_[i]);
    return out;
  }

 private:
  /// True if the profile rises to the plateau that ends at knot i.
  [[nodiscard]] bool rises_to(std::size_t i) const {
    std::size_t first = i;
    while (previous_[first] < in_.size() && in_[previous_[first]].v == in_[i].v)
      first = previous_[first];
    return previous_[first] < in_.size() && in_[previous_[first]].v < in_[i].v;
  }

  /// Lowers the maximum whose plateau ends at knot i if it is too short; returns the knot from
  /// which to continue.
  std::size_t lower(std::size_t i) {
    const std::size_t n = in_.size();
    std::size_t left = i;
    while (in_[previous_[left]].v == in_[i].v) left = previous_[left];
    std::size_t right = i;
    double p = in_[i].v;
    double from = in_[left].q;
    double to = in_[right].q;
    if (to - from >= p * w_) return next_[i];
    while (true) {
      // Both flanks fall from here; the next level is that of the higher neighbor.
      const Knot& l = in_[previous_[left]];
      const Knot& r = in_[next_[right]];
      const double level = std::max(l.v, r.v);
      const double c = 1 / a_;
      const double k = to - from + c * p * p;
      const double q = 2 * k / (w_ + std::sqrt(w_ * w_ + 4 * c * k));
      const double next = std::max(q, level);
      const double shift = (p - next) * (p + next) / (2 * a_);
      from = next == l.v ? l.q : from - shift;
      to = next == r.v ? r.q : to + shift;
      p = next;
      bool left_ends = false;
      bool right_ends = false;
      if (next == l.v) left = previous_[left];
      if (next == r.v) right = next_[right];
      if (q >= level) break;
      // Flat stretches at this level belong to the plateau. If the profile rises after them, it is
      // not a maximum.
      if (next == l.v) {
        while (previous_[left] < n && in_[previous_[left]].v == p) left = previous_[left];
        from = in_[left].q;
        left_ends = previous_[left] >= n || in_[previous_[left]].v > p;
      }
      if (next == r.v) {
        while (next_[right] < n && in_[next_[right]].v == p) right = next_[right];
        to = in_[right].q;
        right_ends = next_[right] >= n || in_[next_[right]].v > p;
      }
      if (left_ends || right_ends || to - from >= p * w_) break;
    }
    return cut(left, right, from, to, p);
  }

  /// Replaces the part of the profile between both flanks by a plateau from `from` to `to`.
  std::size_t cut(std::size_t left, std::size_t right, double from, double to, double p) {
    const bool keeps_left = in_[left].v == p && in_[left].q == from;
    const bool keeps_right = in_[right].v == p && in_[right].q == to;
    if (!keeps_left) in_[left] = {from, p};
    if (!keeps_right) in_[right] = {to, p};
    next_[left] = right;
    previous_[right] = left;
    return next_[right];
  }

  std::vector<Knot> in_;
  std::vector<std::size_t> previous_, next_;
  double a_, w_;
};

}  // namespace

std::vector<RawPhase> spread_law(std::span<const CappedLength> caps, double acceleration,
                                 double window) {
  // A billionth longer, so that rounding never lets a window see both signs of acceleration.
  const double longer = window * (1 + rounded_input);
  const std::vector<Interval> held = envelope(caps, acceleration, longer);
  const std::vector<Knot> knots = Lowering(fastest(held, acceleration), acceleration, longer).run();
  std::vector<RawPhase> out;
  out.reserve(knots.size());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const auto& [q0, v0] = knots[i];
    const auto& [q1, v1] = knots[i + 1];
    // The duration of a slope is computed from its velocities, because lengths far from 0 have few
    // digits.
    const double duration = v0 != v1  ? std::abs(v1 - v0) / acceleration
                            : q1 > q0 ? (q1 - q0) / v0
                                      : 0;
    if (duration > 0) out.push_back({duration, v0, v1});
  }
  return out;
}

std::vector<LawPhase> averaged(std::span<const RawPhase> raw, double window, double length) {
  struct Change {
    double left;          ///< duration until the next change
    double acceleration;  ///< acceleration after this change
    double velocity;      ///< velocity at this change
  };
  std::vector<Change> changes;
  for (const RawPhase& p : raw) changes.push_back({p.duration, (p.v1 - p.v0) / p.duration, p.v0});
  changes.push_back({std::numeric_limits<double>::infinity(), 0, raw.back().v1});
  // Durations are counted down: the difference of two times since the start would have few digits in a long law.
  std::vector<LawPhase> out;
  LawPhase now{};
  std::size_t i = 0;  // next change of the leading edge
  std::size_t k = 0;  // next change of the trailing edge
  double lead = 0;    // time until change i
  double trail = window;
  double since = 0;  // time since change i - 1
  double ahead = 0;
  double behind = 0;
  while (k < changes.size()) {
    const double h = std::min(lead, trail);
    if (h > rounded_root * window) {
      now.duration = h;
      now.jerk = (ahead - behind) / window;
      // A whole window within one phase: its acceleration; at rest or in a cruise its velocity, too.
      if (ahead == behind && i > 0 && since >= window * (1 - rounded_input)) {
        now.acceleration = ahead;
        now.jerk = 0;
        if (ahead == 0) now.velocity = changes[i - 1].velocity;
      }
      out.push_back(now);
      now.position += h * (now.velocity + h * (now.acceleration / 2 + h * now.jerk / 6));
      now.velocity += h * (now.acceleration + h * now.jerk / 2);
      now.acceleration += h * now.jerk;
    }
    const bool leads = lead <= trail;
    lead -= h;
    trail -= h;
    since += h;
    if (leads) {
      ahead = changes[i].acceleration;
      lead = changes[i++].left;
      since = 0;
    } else {
      behind = changes[k].acceleration;
      trail = changes[k++].left;
    }
  }
  const double factor = length / now.position;
  for (LawPhase& p : out) {
    p.duration *= factor;
    p.position *= factor;
    p.acceleration /= factor;
    p.jerk /= factor * factor;
  }
  return out;
}

}  // namespace jounce
