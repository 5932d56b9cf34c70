// SPDX-License-Identifier: Apache-2.0
// Which durations are possible, from first principles.
//
// Let x be what shall change by d, y = x', z = x'' and so on down to the control, each within its
// bounds. For a fixed duration T the admissible motions form a convex set (the dynamics are linear,
// the bounds are intervals) and the distance covered is linear in the motion, so the distances that
// can be covered form an interval [lo(T), hi(T)]: T is possible exactly if
//
//     lo(T) <= d <= hi(T),  and y can make *its* change in T.                             (1)
//
// The second half is the same question one order lower, so the set of possible T is found by
// recursion from order 1, where y itself is the control: T >= d / y_max, T >= d / y_min.
// lo is hi of the mirrored problem (everything negated, bounds swapped): only hi is derived.
//
// **Order 2** (y bounded by `top`, its rate by k up and m down). The largest distance in T is the
// area under the pointwise largest y: from y0 up with k, from y1 back with m, cut off at `top`:
//
//     u = (T + y0/k + y1/m) / (1/k + 1/m),  d hi / dT = min(u, top)                       (2)
//
// **Order 3** (v, a, j for y, z, control; k = jerk_max, m = -jerk_min). By the maximum principle the
// switching function of max of the integral of v is a convex parabola in t, so the jerk is
// +k, -m, +k, with a held where it meets its bounds:
//
//     a(t) = max(min(up(t), c - m t), down(t)),                                           (3)
//     up(t) = min(a0 + k t, a_max),  down(t) = max(a1 - k (T - t), a_min)
//
// The line c is found from the change of velocity, which grows with c at the rate of the falling
// phase's length (Newton, kept inside a bracket). If the velocity where a falls through zero
// passes v_max, v stays there: the motion rises to (v_max, 0) as fast as it can, cruises, and leaves
// as late as it can. The slope of hi is the Hamiltonian, which is constant along the motion; at the
// middle of the falling phase, of length D, it is
//
//     d hi / dT = v_mid + m D^2 / 8,  or v_max with a cruise                              (4)
//
// **Isolation of the roots** of hi(T) = d. With q = 1/k + 1/m, falling phase from p to n:
//     no hold:         p - n = w, p^2 - n^2 = K, T = q w + (a1 - a0)/k, slope = const
//                      + (w^2 (1/k + 2/m) + (K/w)^2 / k) / 8                              (5)
//     a_max held:      slope = const + q n^2 / 2 - a_max n / (2 m), T falls with n        (6)
//     a_min held:      slope = const + q p^2 / 2 - a_min p / (2 m), T grows with p        (7)
//     both, or cruise: slope grows with T, or is constant
// where K = (2/q) (v1 - v0 + (a0^2 - a1^2)/(2 k)). So between the T where the regime changes, and
// those where the slope of (5), (6), (7) turns (w^4 = K^2 / (1 + 2 k/m), n = a_max / (2 m q),
// p = a_min / (2 m q)), the slope is monotone; cut once more where it vanishes, hi is monotone, and
// a change of sign between neighbours is the only way to have a root. Nothing is sampled.
//
// **A start that runs out** of the velocity limit, a > 0, may meet a target that does, too, before either
// is out. Up to T = a/m every motion has a > 0, so that the velocity is monotone between both ends: hi
// and lo hold without a limit of velocity.
//
// **A start outside** is first brought to where its freedom begins (`freedom` in envelope.hpp): up to
// there only one motion is admissible. From there on, the envelope of its velocity rises with k and
// ends level on v_max. Then (3) holds unchanged: no motion with these jerks is above that arc; the
// farthest one follows it first, as `up` does, and where it passes v_max it stays there, from the end
// of the arc on. The nearest one never meets the envelope.
#include "profiles/proof/reachable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace jounce::proof {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

/// The largest distance in a given duration, and how it grows with it.
struct Reach {
  Real distance = 0;
  Real slope = 0;
};
using Farthest = std::function<Reach(Real)>;

struct Cut {
  Farthest at;
  std::vector<Real> breaks;  ///< between these the slope is monotone
};

/// Zero of an increasing or decreasing f; f(x) and f(y) have different signs.
template <class F>
Real crossing(F f, Real x, Real y) {
  const bool rising = f(x) < 0;
  for (int i = 0; i < 128; ++i) {
    const Real mid = x + (y - x) / 2;
    if (mid <= x || mid >= y) break;
    ((f(mid) < 0) == rising ? x : y) = mid;
  }
  return rising ? y : x;  // the side on which f >= 0
}

void append(std::vector<Span>& spans, Real from, Real to) {
  if (!spans.empty() && spans.back().to >= from)
    spans.back().to = std::max(spans.back().to, to);
  else
    spans.push_back({from, to});
}

/// The part of [x, y] where a monotone f >= 0.
template <class F>
void keep_monotone(F f, Real x, Real y, std::vector<Span>& out) {
  const bool at_x = f(x) >= 0;
  const bool at_y = f(y) >= 0;
  if (at_x && at_y) append(out, x, y);
  if (at_x && !at_y) append(out, x, crossing(f, x, y));
  if (!at_x && at_y) append(out, crossing(f, x, y), y);
}

/// The part of `spans` where cut.at(T).distance >= d.
std::vector<Span> keep(const std::vector<Span>& spans, const Cut& cut, Real d) {
  const auto excess = [&](Real T) { return cut.at(T).distance - d; };
  const auto slope = [&](Real T) { return cut.at(T).slope; };
  std::vector<Span> out;
  for (const Span& span : spans) {
    std::vector<Real> at{span.from};
    for (const Real b : cut.breaks)
      if (b > span.from && b < span.to) at.push_back(b);
    std::sort(at.begin(), at.end());
    if (std::isfinite(span.to)) {
      at.push_back(span.to);
    } else {  // beyond the last break the slope only grows: go on until d is reached
      Real last = std::max<Real>(2 * at.back(), std::numeric_limits<double>::min());
      while (!(excess(last) >= 0 && slope(last) > 0) && last < 1e300L) last *= 2;
      at.push_back(last);
    }
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      if (const bool rising = slope(at[i]) < 0; rising != (slope(at[i + 1]) < 0)) {
        const Real turn = crossing(slope, at[i], at[i + 1]);
        keep_monotone(excess, at[i], turn, out);
        keep_monotone(excess, turn, at[i + 1], out);
      } else {
        keep_monotone(excess, at[i], at[i + 1], out);
      }
    }
    if (at.size() == 1) append(out, at[0], at[0]);
    if (!std::isfinite(span.to) && !out.empty() && out.back().to == at.back())
      out.back().to = infinity;
  }
  return out;
}

/// A quantity that is driven by its rate: where it starts and ends, and its bounds.
struct Level {
  Real from = 0, to = 0, min = 0, max = 0;

  [[nodiscard]] Level mirrored() const { return {-from, -to, -max, -min}; }
};

/// Equation (2).
Cut second_order(const Level& y, Real k, Real m) {
  const Real top = y.max;
  const Real u0 = y.from / k + y.to / m;
  const Real q = 1 / k + 1 / m;
  const Real cruise = top * q - u0;  // the T from which y reaches its bound
  const auto at = [=](Real T) -> Reach {
    const Real hold = std::max<Real>(T - cruise, 0);
    const Real u = hold > 0 ? top : (T + u0) / q;
    const Real up = hold > 0 ? top - y.from : (T + (y.to - y.from) / m) / q;
    const Real down = hold > 0 ? top - y.to : (T - (y.to - y.from) / k) / q;
    return {(u + y.from) * up / (2 * k) + (u + y.to) * down / (2 * m) + (hold > 0 ? top * hold : 0),
            u};
  };
  return {at, {cruise}};
}

/// Equation (3) for one T and c: lengths and accelerations of rise, hold, fall, hold, rise.
struct Shape {
  Real up = 0, hold_high = 0, fall = 0, hold_low = 0, last = 0;
  Real high = 0, low = 0;
};

class ThirdOrder {
 public:
  ThirdOrder(const Level& v, const Level& a, Real k, Real m) : v_(v), a_(a), k_(k), m_(m) {}

  [[nodiscard]] Reach at(Real T) const;
  [[nodiscard]] std::vector<Real> breaks() const;

 private:
  [[nodiscard]] Shape shape(Real T, Real c) const;
  [[nodiscard]] Real gain(const Shape& s) const;
  [[nodiscard]] Shape solved(Real T) const;
  [[nodiscard]] Shape to_cruise() const;  // rise to, and fall from, (v_max, 0)
  [[nodiscard]] static Real total(const Shape& s) {
    return s.up + s.hold_high + s.fall + s.hold_low + s.last;
  }

  Level v_, a_;
  Real k_, m_;
};

Shape ThirdOrder::shape(Real T, Real c) const {
  Shape s;
  s.high = std::min(a_.from + k_ * (c - a_.from) / (k_ + m_), a_.max);
  s.low = std::max(c - m_ * (c - a_.to + k_ * T) / (k_ + m_), a_.min);
  s.low = std::min(s.low, s.high);
  s.up = std::max<Real>((s.high - a_.from) / k_, 0);
  s.fall = (s.high - s.low) / m_;
  s.last = std::max<Real>((a_.to - s.low) / k_, 0);
  s.hold_high = s.high < a_.max ? 0 : std::max<Real>((c - s.high) / m_ - s.up, 0);
  s.hold_low = std::max<Real>(T - s.up - s.hold_high - s.fall - s.last, 0);
  if (s.low > a_.min) s.hold_low = 0;
  return s;
}

Real ThirdOrder::gain(const Shape& s) const {
  return (a_.from + s.high) / 2 * s.up + (s.hold_high > 0 ? s.high * s.hold_high : 0) +
         (s.high + s.low) / 2 * s.fall + (s.hold_low > 0 ? s.low * s.hold_low : 0) +
         (s.low + a_.to) / 2 * s.last;
}

Shape ThirdOrder::solved(Real T) const {
  const Real wanted = v_.to - v_.from;
  Real lo = a_.from;
  Real hi = std::max(lo, a_.to + m_ * T);
  Real c = lo + (hi - lo) / 2;
  for (int i = 0; i < 200; ++i) {
    const Shape s = shape(T, c);
    const Real error = gain(s) - wanted;
    if (error == 0) break;
    (error < 0 ? lo : hi) = c;
    const Real newton = c - error / s.fall;
    const Real next = newton > lo && newton < hi ? newton : lo + (hi - lo) / 2;
    if (next == c || next <= lo || next >= hi) break;
    c = next;
  }
  return shape(T, c);
}

Shape ThirdOrder::to_cruise() const {
  const Real q = 1 / k_ + 1 / m_;
  const Real rise = v_.max - v_.from + a_.from * a_.from / (2 * k_);
  const Real fall = v_.max - v_.to + a_.to * a_.to / (2 * k_);
  Shape s;
  s.high = std::min(std::sqrt(std::max<Real>(2 * rise / q, 0)), a_.max);
  s.high = std::max(s.high, a_.from);
  s.low = std::max(-std::sqrt(std::max<Real>(2 * fall / q, 0)), a_.min);
  s.low = std::min(s.low, a_.to);
  s.up = (s.high - a_.from) / k_;
  s.fall = (s.high - s.low) / m_;
  s.last = (a_.to - s.low) / k_;
  if (s.high > 0) s.hold_high = std::max<Real>((rise - s.high * s.high * q / 2) / s.high, 0);
  if (s.low < 0) s.hold_low = std::max<Real>((fall - s.low * s.low * q / 2) / -s.low, 0);
  return s;
}

/// One stretch of constant jerk, in place.
struct Point {
  Real x, v, a;

  void advance(Real t, Real j) {
    x += t * (v + t * (a / 2 + t * j / 6));
    v += t * (a + t * j / 2);
    a += t * j;
  }
};

Reach ThirdOrder::at(Real T) const {
  if (std::isfinite(v_.max)) {
    const Shape s = to_cruise();
    if (const Real cruise = T - total(s); cruise >= 0) {
      Point p{0, v_.from, a_.from};
      p.advance(s.up, k_);
      p.advance(s.hold_high, 0);
      p.advance(s.high / m_, -m_);
      Point back{0, v_.to, a_.to};  // from the target, against time
      back.advance(-s.last, k_);
      back.advance(-s.hold_low, 0);
      back.advance(s.low / m_, -m_);
      return {p.x + v_.max * cruise - back.x, v_.max};
    }
  }
  const Shape s = solved(T);
  Point p{0, v_.from, a_.from};
  p.advance(s.up, k_);
  p.advance(s.hold_high, 0);
  Point mid = p;
  mid.advance(s.fall / 2, -m_);
  p.advance(s.fall, -m_);
  p.advance(s.hold_low, 0);
  p.advance(s.last, k_);
  return {p.x, mid.v + m_ * s.fall * s.fall / 8};  // (4)
}

std::vector<Real> ThirdOrder::breaks() const {
  const Real k = k_;
  const Real m = m_;
  const Real q = 1 / k + 1 / m;
  const Real rest = (a_.to - a_.from) / k;
  const Real K = 2 / q * (v_.to - v_.from + (a_.from * a_.from - a_.to * a_.to) / (2 * k));
  const Real A = a_.max;
  const Real N = a_.min;
  const auto free = [&](Real w) { return q * w + rest; };
  const auto high_held = [&](Real n) {
    return q * (A - n) + q / 2 * (n * n - A * A + K) / A + rest;
  };
  const auto low_held = [&](Real p) {
    return q * (p - N) + q / 2 * (p * p - N * N - K) / -N + rest;
  };
  const Real to_high = std::sqrt(A * A - K);
  const Real to_low = std::sqrt(N * N + K);
  std::vector<Real> t{free(A + to_high),
                      free(A - to_high),
                      free(to_low - N),
                      free(-to_low - N),
                      high_held(N),
                      low_held(A),
                      free(std::sqrt(std::sqrt(K * K / (1 + 2 * k / m)))),
                      high_held(A / (2 * m * q)),
                      low_held(N / (2 * m * q)),
                      total(to_cruise())};
  std::erase_if(t, [](Real x) { return !std::isfinite(x); });
  return t;
}

Cut third_order(const Level& v, const Level& a, Real k, Real m) {
  const ThirdOrder f(v, a, k, m);
  return {[f](Real T) { return f.at(T); }, f.breaks()};
}

/// Both halves of (1): hi of the problem and of its mirror image.
std::vector<Span> between(const std::vector<Span>& spans, const Cut& hi, const Cut& lo, Real d,
                          Real slack) {
  return keep(keep(spans, hi, d - slack), lo, -d - slack);
}

std::vector<Span> first(const Level& x, Real min, Real max, Real slack) {
  const Real d = x.to - x.from;
  return {{std::max({(d - slack) / max, (d + slack) / min, Real{0}}), infinity}};
}

std::vector<Span> second(const Level& x, const Level& y, Real min, Real max, Real slack_x,
                         Real slack_y) {
  return between(first(y, min, max, slack_y), second_order(y, max, -min),
                 second_order(y.mirrored(), -min, max), x.to - x.from, slack_x);
}

}  // namespace

namespace {

/// The velocity at which the acceleration vanishes, if it is brought there by jerk j.
Real at_rest(Real v, Real a, Real j) {
  return v - a * a / (2 * j);
}

/// Start of second order: brakes until the velocity is inside.
Freedom braked(const MotionState& from, const Bounds& b) {
  const Real v = from.velocity;
  const Real down = (v - b.velocity_max) / -b.acceleration_min;
  const Real up = (b.velocity_min - v) / b.acceleration_max;
  const Real t = std::max({down, up, Real{0}});
  const Real a = v > 0 ? b.acceleration_min : b.acceleration_max;
  return {t, from.position + t * (v + t * a / 2), v + t * a, 0};
}

std::vector<Span> later(std::vector<Span> spans, Real time) {
  for (Span& s : spans) s = {s.from + time, s.to + time};
  return spans;
}

/// A quantity from where the freedom begins.
Level level(Real from, double to, Real min, Real max) {
  return {from, to, min, max};
}

}  // namespace

namespace {

/// All the durations under one set of bounds.
std::vector<Span> durations_of(const MotionState& from, const MotionState& to, const Bounds& b,
                               Real hold, const Slack& slack) {
  const bool third = std::isfinite(b.jerk_max);
  const Freedom free = third ? freedom(from, b, hold) : braked(from, b);
  const Level x = level(free.x, to.position, -infinity, infinity);
  const Level v = level(free.v, to.velocity, b.velocity_min, b.velocity_max);
  const Level a = level(free.a, to.acceleration, b.acceleration_min, b.acceleration_max);
  const Real k = third ? b.jerk_max : b.acceleration_max;
  const Real m = third ? -b.jerk_min : -b.acceleration_min;
  return later(third
                   ? between(second(v, a, -m, k, slack.velocity, slack.acceleration),
                             third_order(v, a, k, m), third_order(v.mirrored(), a.mirrored(), m, k),
                             x.to - x.from, slack.position)
                   : second(x, v, -m, k, slack.position, slack.velocity),
               free.time);
}

/// The instants of the forced stretch at which the motion is at the target.
std::vector<Span> passing(const MotionState& from, const MotionState& to, const Bounds& b,
                          Real hold, const Slack& slack, bool position) {
  std::vector<Span> at;
  const auto near = [](Real x, Real y, Real e) { return std::abs(x - y) <= e; };
  for (const Freedom& s : forced_at(from, b, hold, to.velocity, to.acceleration))
    if (near(s.v, to.velocity, slack.velocity) && near(s.a, to.acceleration, slack.acceleration) &&
        (!position || near(s.x, to.position, slack.position)))
      at.push_back({s.time, s.time});
  return at;
}

/// The durations of the motions that meet the target while the start runs out of its limit. One order
/// lower without the position.
std::vector<Span> on_the_way_out(const MotionState& from, const MotionState& to, const Bounds& b,
                                 const Slack& slack, bool position) {
  const bool down = from.acceleration < 0;
  const Side s = down ? lower(b) : upper(b);
  const Real sign = down ? -1 : 1;
  Point p{0, sign * from.velocity, sign * from.acceleration};
  const Real into = std::max<Real>((p.a - s.a_max) / s.fall, 0);
  p.advance(into, -s.fall);
  const Real left = p.a / s.fall;
  if (!(p.a > 0) || p.v > s.top || p.v + p.a * left / 2 <= s.top) return {};
  const Level v{p.v, sign * to.velocity, -infinity, infinity};
  const Level a{p.a, sign * to.acceleration, s.a_min, s.a_max};
  std::vector<Span> spans = second(v, a, -s.fall, s.rise, slack.velocity, slack.acceleration);
  if (position)
    spans = between(spans, third_order(v, a, s.rise, s.fall),
                    third_order(v.mirrored(), a.mirrored(), s.fall, s.rise),
                    sign * (Real{to.position} - from.position) - p.x, slack.position);
  std::erase_if(spans, [left](const Span& span) { return span.from > left; });
  for (Span& span : spans) span.to = std::min(span.to, left);
  return later(spans, into);
}

/// All spans together.
std::vector<Span> merged(std::vector<Span> some, const std::vector<Span>& more) {
  for (const Span& s : more) append(some, s.from, s.to);
  return some;
}

/// The part of the spans from T on, and T itself.
std::vector<Span> from_on(const std::vector<Span>& spans, Real T) {
  std::vector<Span> part{{T, T}};
  for (const Span& s : spans)
    if (s.to >= T) append(part, std::max(s.from, T), s.to);
  return part;
}

}  // namespace

std::vector<Span> reachable(const MotionState& from, const MotionState& to, const Bounds& b,
                            const Slack& slack) {
  if (!std::isfinite(b.acceleration_max) && !std::isfinite(b.jerk_max))
    return first({from.position, to.position, -infinity, infinity}, b.velocity_min, b.velocity_max,
                 slack.position);
  const Force force = in_force(from, to, b, slack.position);
  std::vector<Span> spans = durations_of(from, to, force.bounds, force.hold, slack);
  if (std::isfinite(b.jerk_max))
    spans = merged(merged(on_the_way_out(from, to, b, slack, true),
                          passing(from, to, force.bounds, force.hold, slack, true)),
                   spans);
  if (force.longer != force.bounds && !spans.empty())
    spans = from_on(durations_of(from, to, force.longer, 0, slack), spans.front().from);
  // One that is its target may also stay, outside too; afterwards it has to come inside.
  if (from == to && (spans.empty() || spans.front().from > 0)) spans.insert(spans.begin(), Span{});
  return spans;
}

std::vector<Span> reachable_velocity(const MotionState& from, double velocity, double acceleration,
                                     const Bounds& b, const Slack& slack) {
  if (!std::isfinite(b.jerk_max))  // braking is the fastest, for every quantity outside
    return first({from.velocity, velocity, b.velocity_min, b.velocity_max}, b.acceleration_min,
                 b.acceleration_max, slack.velocity);
  if (from.velocity == velocity && from.acceleration == acceleration) return {Span{}};
  const Freedom free = freedom(from, b);
  const Level v = level(free.v, velocity, b.velocity_min, b.velocity_max);
  const Level a = level(free.a, acceleration, b.acceleration_min, b.acceleration_max);
  const MotionState to{0, velocity, acceleration};
  return merged(
      merged(on_the_way_out(from, to, b, slack, false), passing(from, to, b, 0, slack, false)),
      later(second(v, a, b.jerk_min, b.jerk_max, slack.velocity, slack.acceleration), free.time));
}

namespace {

bool inside(double x, double min, double max) {
  return x >= min && x <= max;
}

}  // namespace

bool safe_start(const MotionState& s, const Bounds& b) {
  if (!inside(s.velocity, b.velocity_min, b.velocity_max)) return false;
  if (!std::isfinite(b.jerk_max)) return true;
  if (!inside(s.acceleration, b.acceleration_min, b.acceleration_max)) return false;
  const Real v = at_rest(s.velocity, s.acceleration, s.acceleration > 0 ? b.jerk_min : b.jerk_max);
  return v >= b.velocity_min && v <= b.velocity_max;
}

bool safe_target(const MotionState& s, const Bounds& b) {
  if (!inside(s.velocity, b.velocity_min, b.velocity_max)) return false;
  if (!std::isfinite(b.jerk_max)) return true;
  if (!inside(s.acceleration, b.acceleration_min, b.acceleration_max)) return false;
  const Real v = at_rest(s.velocity, s.acceleration, s.acceleration > 0 ? b.jerk_max : b.jerk_min);
  return v >= b.velocity_min && v <= b.velocity_max;
}

bool contains(const std::vector<Span>& spans, Real T) {
  return std::any_of(spans.begin(), spans.end(),
                     [T](const Span& s) { return T >= s.from && T <= s.to; });
}

}  // namespace jounce::proof
