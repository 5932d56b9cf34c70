#include "profiles/proof/envelope.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::proof {
namespace {

constexpr Real forgiven = 1e-13L;  ///< beyond a limit by less is rounding

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
  const Real natural = a > 0 ? brake.front().velocity(a / s.fall) : level({0, v, a, s.rise});
  if (natural > s.top) {
    Envelope e = level_return(brake, first, s);
    const Arc& arc = brake.front();
    if (v < s.top && a > 0)
      e.passes = bisected([&](Real t) { return arc.velocity(t) >= s.top; }, 0, a / s.fall);
    return e;
  }
  const Real into = std::max((a - s.a_max) / s.fall, a < s.a_min ? first : 0);
  if (v <= s.top) return {{limit}, std::max<Real>(into, 0)};
  const Arc rising{0, v, a, s.rise};
  const Real t = bisected([&](Real x) { return rising.velocity(x) <= s.top; }, 0, -a / s.rise);
  return {{rising, {t, s.top, 0, 0}}, std::max<Real>(into, 0)};
}

namespace {

/// Positions along arcs.
Freedom along(const std::vector<Arc>& arcs, Real x, Real time) {
  Freedom f{time, x, 0, 0, 0};
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
  const Envelope above = envelope(v, a, upper(b));
  const Envelope below = envelope(-v, -a, lower(b));
  const Real passes = std::max(above.passes, below.passes);
  if (above.forced >= below.forced) {
    Freedom f = along(braking(v, a, upper(b)), from.position, above.forced);
    f.passes = passes;
    return f;
  }
  const Freedom f = along(braking(-v, -a, lower(b)), -from.position, below.forced);
  return {f.time, -f.x, -f.v, -f.a, passes};
}

Freedom acceleration_inside(const MotionState& from, const Bounds& b) {
  const Real a = from.acceleration;
  const Real down = (a - b.acceleration_max) / -Real{b.jerk_min};
  const Real up = (b.acceleration_min - a) / b.jerk_max;
  const Real j = down > 0 ? b.jerk_min : b.jerk_max;
  return along({{0, from.velocity, a, j}}, from.position, std::max({down, up, Real{0}}));
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

Bounds negated(const Bounds& b) {
  return {-b.velocity_max, -b.velocity_min, -b.acceleration_max, -b.acceleration_min,
          -b.jerk_max,     -b.jerk_min,     -b.position_max,     -b.position_min};
}

MotionState negated(const MotionState& s) {
  return {-s.position, -s.velocity, -s.acceleration};
}

}  // namespace

InForce in_force(const MotionState& from, const MotionState& to, const Bounds& b, bool longer) {
  const Real d = Real{to.position} - from.position;
  if (d < 0) {
    const InForce other = in_force(negated(from), negated(to), negated(b), longer);
    return {negated(other.bounds), other.hold};
  }
  const Side s = upper(b);
  const Real n = level({0, from.velocity, from.acceleration, s.rise});
  const bool rests = to.velocity == 0 && to.acceleration == 0;
  if (!(d > 0) || !rests || !std::isfinite(s.rise) || !(n > 0) ||
      !(from.acceleration < s.a_min * (1 + forgiven)))
    return {b};
  const auto fits = [&](Real x) { return stop_distance(from, s.rise, x) <= d; };
  if (fits(-s.a_min)) return {b};
  if (!fits(-from.acceleration)) return {b, n / -from.acceleration};
  InForce extended{b};
  const Real x = longer ? -from.acceleration : bisected(fits, -s.a_min, -from.acceleration);
  extended.bounds.acceleration_min =
      std::max(std::nextafter(static_cast<double>(-x), -HUGE_VAL), from.acceleration);
  return extended;
}

MotionState after_hold(const MotionState& s, Real t) {
  const Real v = s.velocity + t * s.acceleration;
  return {static_cast<double>(s.position + t * (s.velocity + v) / 2), static_cast<double>(v),
          s.acceleration};
}

}  // namespace jounce::proof
