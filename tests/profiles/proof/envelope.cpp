// SPDX-License-Identifier: Apache-2.0
#include "profiles/proof/envelope.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::proof {
namespace {

/// A start that is outside by no more than this share of its terms is inside.
constexpr Real by_rounding = 1e-13L;

/// The boundary at which a predicate begins to hold; it holds at y and not at x.
template <class F>
Real bisected(F holds, Real x, Real y) {
  for (int i = 0; i < 200; ++i) {
    const Real mid = x + (y - x) / 2;
    if (mid <= std::min(x, y) || mid >= std::max(x, y)) break;
    (holds(mid) ? y : x) = mid;
  }
  return y;
}

Arc after(const Arc& arc, Real t, Real jerk) {
  return {t, arc.velocity(t), arc.acceleration(t), jerk};
}

/// The lowest possible velocity: the acceleration falls, or returns, to a_min and stays there.
std::vector<Arc> braking(Real v, Real a, const Side& s) {
  const bool below = a < s.a_min;
  Arc first{0, v, a, below ? s.rise : -s.fall};
  std::vector<Arc> arcs{first};
  if (std::isfinite(s.a_min)) {
    Arc hold = after(first, below ? (s.a_min - a) / s.rise : (a - s.a_min) / s.fall, 0);
    hold.a = s.a_min;
    arcs.push_back(hold);
  }
  return arcs;
}

const Arc& at(const std::vector<Arc>& arcs, Real t) {
  std::size_t i = arcs.size() - 1;
  while (i > 0 && arcs[i].begin > t) --i;
  return arcs[i];
}

/// Full braking, released at t: the arc on which the acceleration returns to 0.
Arc released(const std::vector<Arc>& brake, Real t, Real rise) {
  return after(at(brake, t), t, rise);
}

/// The velocity at which a released braking ends.
Real level(const Arc& release) {
  return release.velocity(release.begin - release.a / release.j);
}

/// The first instant at which braking is such that it can be released.
Real releasable(Real a, const Side& s) {
  if (a > 0) return a / s.fall;
  return a < s.a_min ? (s.a_min - a) / s.rise : 0;
}

Envelope level_return(const std::vector<Arc>& brake, Real first, const Side& s) {
  const auto inside = [&](Real t) { return level(released(brake, t, s.rise)) <= s.top; };
  Real late = first + std::max<Real>(std::abs(brake.front().a) / s.rise, 1e-30L);
  while (!inside(late)) late = first + 2 * (late - first);
  Envelope e;
  e.forced = bisected(inside, first, late);
  for (const Arc& arc : brake)
    if (arc.begin < e.forced) e.arcs.push_back(arc);
  const Arc release = released(brake, e.forced, s.rise);
  e.arcs.push_back(release);
  e.arcs.push_back({e.forced - release.a / s.rise, s.top, 0, 0});
  return e;
}

}  // namespace

Side upper(const Bounds& b) {
  return {b.velocity_max, b.acceleration_max, b.acceleration_min, b.jerk_max, -b.jerk_min};
}

Side lower(const Bounds& b) {
  return {-b.velocity_min, -b.acceleration_min, -b.acceleration_max, -b.jerk_min, b.jerk_max};
}

const Arc& Envelope::arc(Real t) const {
  return at(arcs, t);
}

namespace {

/// Envelope with the level return from its very beginning.
Envelope from_the_start(Real v, Real a, const Side& s) {
  const Arc limit{0, s.top, 0, 0};
  if (!std::isfinite(s.rise)) {  // the acceleration steps: braking at once
    if (v <= s.top) return {{limit}, 0};
    const Real t = (v - s.top) / -s.a_min;
    return {{{0, v, s.a_min, 0}, {t, s.top, 0, 0}}, t};
  }
  const std::vector<Arc> brake = braking(v, a, s);
  const Real first = releasable(a, s);
  const Real natural = a > 0 ? brake.front().velocity(a / s.fall) : level({0, v, a, s.rise});
  const Real terms = std::abs(s.top) + std::abs(v) + std::abs(natural);
  if (natural - s.top > by_rounding * terms) return level_return(brake, first, s);
  const Real into = std::max((a - s.a_max) / s.fall, a < s.a_min ? first : 0);
  if (v - s.top <= by_rounding * terms) return {{limit}, std::max<Real>(into, 0)};
  const Arc rising{0, v, a, s.rise};
  const Real t = bisected([&](Real x) { return rising.velocity(x) <= s.top; }, 0, -a / s.rise);
  return {{rising, {t, s.top, 0, 0}}, std::max<Real>(into, 0)};
}

/// The same from t on.
std::vector<Arc> cut(const std::vector<Arc>& arcs, Real t) {
  const Arc& now = at(arcs, t);
  std::vector<Arc> rest{after(now, t, now.j)};
  for (const Arc& arc : arcs)
    if (arc.begin > t) rest.push_back(arc);
  return rest;
}

}  // namespace

Envelope envelope(Real v, Real a, const Side& s) {
  Envelope e = from_the_start(v, a, s);
  if (e.arcs.size() < 2 || v >= s.top) return e;
  const auto outside = [&](Real t) { return e.velocity(t) > s.top; };
  e.arcs = cut(e.arcs, bisected(outside, 0, a / s.fall));
  e.arcs.insert(e.arcs.begin(), {0, s.top, 0, 0});
  return e;
}

namespace {

/// Positions along arcs.
Freedom along(const std::vector<Arc>& arcs, Real x, Real time) {
  Freedom f{time, x, 0, 0};
  for (std::size_t i = 0; i < arcs.size() && arcs[i].begin <= time; ++i) {
    const Arc& arc = arcs[i];
    const Real end = i + 1 < arcs.size() ? std::min(arcs[i + 1].begin, time) : time;
    const Real s = end - arc.begin;
    f.x += s * (arc.v + s * (arc.a / 2 + s * arc.j / 6));
    f.v = arc.velocity(end);
    f.a = arc.acceleration(end);
  }
  return f;
}

}  // namespace

namespace {

/// The one admissible motion at first: held, then braking towards one side or the other. Values
/// refer to the side towards which it brakes, which `sign` gives.
struct Forced {
  std::vector<Arc> arcs;
  Real sign = 1;
  Real x = 0;
  Real until = 0;
};

Forced forced(const MotionState& from, const Bounds& b, Real hold) {
  const Real v = from.velocity + hold * from.acceleration;
  const Real a = from.acceleration;
  const Real down = envelope(v, a, upper(b)).forced;
  const Real up = envelope(-v, -a, lower(b)).forced;
  Forced f = down >= up ? Forced{braking(v, a, upper(b)), 1, from.position, hold + down}
                        : Forced{braking(-v, -a, lower(b)), -1, -from.position, hold + up};
  for (Arc& arc : f.arcs) arc.begin += hold;
  if (hold > 0) f.arcs.insert(f.arcs.begin(), Arc{0, f.sign * from.velocity, f.sign * a, 0});
  return f;
}

Freedom at(const Forced& f, Real time) {
  const Freedom s = along(f.arcs, f.x, time);
  return {s.time, f.sign * s.x, f.sign * s.v, f.sign * s.a};
}

}  // namespace

Freedom freedom(const MotionState& from, const Bounds& b, Real hold) {
  const Forced f = forced(from, b, hold);
  return at(f, f.until);
}

std::vector<Freedom> forced_at(const MotionState& from, const Bounds& b, Real hold, Real v,
                               Real a) {
  const Forced f = forced(from, b, hold);
  std::vector<Freedom> states;
  if (!(f.until > 0)) return states;
  for (std::size_t i = 0; i < f.arcs.size(); ++i) {
    const Arc& arc = f.arcs[i];
    const Real end = i + 1 < f.arcs.size() ? std::min(f.arcs[i + 1].begin, f.until) : f.until;
    const Real t =
        arc.begin + (arc.j != 0 ? (f.sign * a - arc.a) / arc.j : (f.sign * v - arc.v) / arc.a);
    const Real slack = 1e-12L * f.until;
    if (t >= arc.begin - slack && t <= end + slack && arc.begin <= end)
      states.push_back(at(f, std::clamp(t, arc.begin, end)));
  }
  return states;
}

namespace {

/// The distance of the stop that holds the deceleration x (> 0), from a stronger one.
Real stop_distance(const MotionState& from, Real rise, Real x) {
  const Arc up{0, from.velocity, from.acceleration, rise};
  const Arc hold = after(up, (-x - up.a) / rise, 0);
  const Real rest = level({0, hold.v, -x, rise});  // the reduction by the hold
  const Arc last{hold.begin + rest / x, hold.v - rest, -x, rise};
  return along({up, hold, last}, 0, last.begin + x / rise).x;
}

Bounds negated(const Bounds& b) {
  return {-b.velocity_max, -b.velocity_min, -b.acceleration_max, -b.acceleration_min,
          -b.jerk_max,     -b.jerk_min,     -b.position_max,     -b.position_min};
}

MotionState negated(const MotionState& s) {
  return {-s.position, -s.velocity, -s.acceleration};
}

}  // namespace

bool forward(const MotionState& to, const Bounds& bounds) {
  const Real a = to.acceleration;
  return to.velocity >= 0 && (a <= 0 || a * a <= 2 * Real{bounds.jerk_max} * to.velocity);
}

Real run_up(const MotionState& to, const Bounds& bounds) {
  const Side s = upper(bounds);
  const auto arcs = [&](Real high) {  // rise to `high`, fall to the end's acceleration
    return std::vector<Arc>{{0, 0, 0, s.rise},
                            {high / s.rise, high * high / (2 * s.rise), high, -s.fall}};
  };
  const auto length = [&](Real high) { return high / s.rise + (high - to.acceleration) / s.fall; };
  const auto end = [&](Real high) { return along(arcs(high), 0, length(high)); };
  const auto enough = [&](Real high) { return end(high).v >= to.velocity; };
  const Real least = std::max<Real>(to.acceleration, 0);
  Real most = s.a_max;
  if (!std::isfinite(most))
    for (most = std::max<Real>(least, 1e-30L); !enough(most);) most *= 2;
  if (enough(most)) {
    const Real high = bisected(enough, least, most);
    return end(high).x;
  }
  const Real hold =
      (to.velocity - end(most).v) / most;  // all that follows is faster by hold * most
  const Real begin = most / s.rise;
  const Real v = most * begin / 2;
  return end(most).x + hold * (v + hold * most / 2) + hold * most * (length(most) - begin);
}

Freedom fastest_stop(const MotionState& from, const Bounds& b) {
  const auto natural = [](Real v, Real a, const Side& s) {
    return a > 0 ? v + a * a / (2 * s.fall) : v - a * a / (2 * s.rise);
  };
  const auto stopped = [&](Real v, Real a, Side s) {
    s.top = 0;  // level with zero
    if (!(natural(v, a, s) > 0)) return along({{0, v, a, s.rise}}, 0, -a / s.rise);
    const Envelope e = from_the_start(v, a, s);
    if (e.arcs.size() == 1) return along({{0, v, a, s.rise}}, 0, -a / s.rise);  // 0 by rounding
    return along(e.arcs, 0, e.arcs.back().begin);
  };
  const Real v = from.velocity;
  const Real a = from.acceleration;
  if (natural(v, a, upper(b)) >= 0) return stopped(v, a, upper(b));
  const Freedom f = stopped(-v, -a, lower(b));
  return {f.time, -f.x, -f.v, -f.a};
}

Force in_force(const MotionState& from, const MotionState& to, const Bounds& b, Real slack) {
  const Real d = Real{to.position} - from.position;
  if (d < 0) {
    const Force f = in_force(negated(from), negated(to), negated(b), slack);
    return {negated(f.bounds), negated(f.longer), f.hold};
  }
  const Side s = upper(b);
  const bool rests = to.velocity == 0 && to.acceleration == 0;
  const bool harder = from.velocity > 0 && from.acceleration < s.a_min * (1 + by_rounding);
  if (!(d > 0) || !rests || !harder || !std::isfinite(s.rise)) return {b, b, 0};
  const Real natural = level({0, from.velocity, from.acceleration, s.rise});
  if (!(natural > 0)) return {b, b, 0};
  const auto fits = [&](Real x) { return stop_distance(from, s.rise, x) <= d + slack; };
  if (fits(-s.a_min)) return {b, b, 0};
  if (!fits(-from.acceleration)) return {b, b, natural / -from.acceleration};
  Force f{b, b, 0};
  const Real x = bisected(fits, -s.a_min, -from.acceleration);
  f.bounds.acceleration_min =  // rounded to where it fits
      std::max(std::nextafter(static_cast<double>(-x), -HUGE_VAL), from.acceleration);
  f.longer.acceleration_min = from.acceleration;
  return f;
}

}  // namespace jounce::proof
