#include "profiles/proof/envelope.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::proof {
namespace {

/// Where a predicate that holds at y and not at x begins to hold.
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

/// As low as the velocity can go: the acceleration falls, or returns, to a_min and stays there.
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

Envelope envelope(Real v, Real a, const Side& s) {
  const Arc limit{0, s.top, 0, 0};
  if (!std::isfinite(s.rise)) {  // the acceleration steps: braking at once
    if (v <= s.top) return {{limit}, 0};
    const Real t = (v - s.top) / -s.a_min;
    return {{{0, v, s.a_min, 0}, {t, s.top, 0, 0}}, t};
  }
  const std::vector<Arc> brake = braking(v, a, s);
  const Real first = releasable(a, s);
  const Real natural =
      a > 0 ? brake.front().velocity(a / s.fall) : level({0, v, a, s.rise});
  if (natural > s.top) return level_return(brake, first, s);
  const Real into = std::max((a - s.a_max) / s.fall, a < s.a_min ? first : 0);
  if (v <= s.top) return {{limit}, std::max<Real>(into, 0)};
  const Arc rising{0, v, a, s.rise};
  const Real t = bisected([&](Real x) { return rising.velocity(x) <= s.top; }, 0, -a / s.rise);
  return {{rising, {t, s.top, 0, 0}}, std::max<Real>(into, 0)};
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

Freedom freedom(const MotionState& from, const Bounds& b) {
  const Real v = from.velocity;
  const Real a = from.acceleration;
  const Real from_above = envelope(v, a, upper(b)).forced;
  const Real from_below = envelope(-v, -a, lower(b)).forced;
  if (from_above >= from_below)
    return along(braking(v, a, upper(b)), from.position, from_above);
  const Freedom f = along(braking(-v, -a, lower(b)), -from.position, from_below);
  return {f.time, -f.x, -f.v, -f.a};
}

namespace {

/// The distance of the stop that holds the deceleration x (> 0), from a stronger one.
Real stop_distance(const MotionState& from, Real rise, Real x) {
  const Arc up{0, from.velocity, from.acceleration, rise};
  const Arc hold = after(up, (-x - up.a) / rise, 0);
  const Real rest = level({0, hold.v, -x, rise});  // what the hold takes away
  const Arc last{hold.begin + rest / x, hold.v - rest, -x, rise};
  return along({up, hold, last}, 0, last.begin + x / rise).x;
}

/// The distance of the fastest change from rest to a velocity and acceleration.
Real change_distance(const MotionState& to, const Side& s) {
  const auto arcs = [&](Real high) {  // rise to `high`, fall to the end's acceleration
    return std::vector<Arc>{{0, 0, 0, s.rise}, {high / s.rise, high * high / (2 * s.rise), high, -s.fall}};
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
  const Real hold = (to.velocity - end(most).v) / most;  // all that follows is faster by hold * most
  const Real begin = most / s.rise;
  const Real v = most * begin / 2;
  return end(most).x + hold * (v + hold * most / 2) + hold * most * (length(most) - begin);
}

Bounds negated(const Bounds& b) {
  return {-b.velocity_max, -b.velocity_min, -b.acceleration_max, -b.acceleration_min,
          -b.jerk_max,     -b.jerk_min,     -b.position_max,     -b.position_min};
}

MotionState negated(const MotionState& s) {
  return {-s.position, -s.velocity, -s.acceleration};
}

/// Can be reached from rest without moving backwards.
bool forward(const MotionState& to, Real rise) {
  const Real a = to.acceleration;
  return to.velocity >= 0 && (a <= 0 || a * a <= 2 * rise * to.velocity);
}

}  // namespace

Bounds in_force(const MotionState& from, const MotionState& to, const Bounds& b, Real slack) {
  const Real d = Real{to.position} - from.position;
  if (d < 0) return negated(in_force(negated(from), negated(to), negated(b), slack));
  const Side s = upper(b);
  if (!(d > 0) || !std::isfinite(s.rise) || !(from.velocity > 0 && from.acceleration < s.a_min) ||
      level({0, from.velocity, from.acceleration, s.rise}) < 0 || !forward(to, s.rise))
    return b;
  const Real go = change_distance(to, s);
  const auto fits = [&](Real x) { return stop_distance(from, s.rise, x) + go <= d + slack; };
  if (fits(-s.a_min) || !fits(-from.acceleration)) return b;
  Bounds extended = b;
  extended.acceleration_min =
      static_cast<double>(-bisected(fits, -s.a_min, -from.acceleration));
  return extended;
}

}  // namespace jounce::proof
