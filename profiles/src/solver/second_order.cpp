// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/second_order.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/lanes.hpp"
#include "jounce/profiles/detail/numeric.hpp"

namespace jounce::profiles_detail {
namespace {

/// The rounding of the distance of the direct change.
double rounding_of(const MotionState& from, const MotionState& to, double direct) {
  return rounding * (std::abs(from.position) + std::abs(to.position) +
                     direct * (std::abs(from.velocity) + std::abs(to.velocity)));
}

}  // namespace

ShortestSecondOrder::ShortestSecondOrder(const MotionState& from, const MotionState& to,
                                         const Bounds& b) noexcept {
  const double amax = b.acceleration_max;
  const double amin = -b.acceleration_min;
  const double d = to.position - from.position;
  const double dv = to.velocity - from.velocity;
  const Vector2 per_limit = 1 / Vector2{amax, amin};
  const double both = amax * amin / (amax + amin);
  const double direct = std::abs(dv) * either(dv > 0, per_limit[0], per_limit[1]);
  const double excess = d - direct * (from.velocity + to.velocity) / 2;
  const bool is_direct = std::abs(excess) <= rounding_of(from, to, direct);
  const bool up = excess >= 0;
  const double sign = either(up, 1, -1);
  const Vector2 rate = pair(amax, amin, !up);  // rise, fall
  const Vector2 per_rate = pair(per_limit[0], per_limit[1], !up);
  const Vector2 v = sign * Vector2{from.velocity, to.velocity};
  const double natural = std::max(v[0], v[1]);
  const double vmax = std::max(either(up, b.velocity_max, -b.velocity_min), natural);

  const double twice = 2 * sign * d;
  const Vector2 ends = v * v * per_rate;
  const double square = (twice + ends[0] + ends[1]) * both;
  // Equation (2) without a cruise: the greater solution.
  const double peak = std::max(std::sqrt(std::max(square, 0.0)), natural);
  const bool passes = (peak <= vmax) & !is_direct;
  const double top = either(is_direct, natural, std::min(peak, vmax));
  // Equation (2) gives p^2 - v^2 without p, which is exact also if p and v are nearly equal.
  const double squares = (v[0] - v[1]) * (v[0] + v[1]);
  const Vector2 rest = twice + Vector2{-squares, squares} * Vector2{per_rate[1], per_rate[0]};
  const Vector2 from_here = every<Vector2>(either(passes, 0, inf));
  const Vector2 above = (v > from_here ? greatest(rest * both, Vector2{}) : top - v) /
                        (v > from_here ? peak + v : every<Vector2>(1));
  rise_ = sign * rate[0];
  fall_ = -sign * rate[1];
  rises_ = above[0] * per_rate[0];
  falls_ = above[1] * per_rate[1];
  const Vector2 ramps = (top - v) * (top + v) * per_rate;
  cruise_ = either(passes | is_direct, 0, (twice - (ramps[0] + ramps[1])) / (2 * top));
}

Profile ShortestSecondOrder::profile(const MotionState& from,
                                     const MotionState& to) const noexcept {
  return Profile(from, to, 2, {rise_, fall_}, {{lead_, 2}, {rises_, 1}, {cruise_, 0}, {falls_, 2}});
}

void ShortestSecondOrder::lead(double t, double a) noexcept {
  if (a == rise_)
    rises_ += t;
  else if (rises_ + cruise_ == 0)
    falls_ += t;
  else
    lead_ = t;
}

void ShortestSecondOrder::append(Profile& out) const noexcept {
  out.add(lead_, fall_);
  out.add(rises_, rise_);
  out.add(cruise_, 0);
  out.add(falls_, fall_);
}

Slowed slowed(const MotionState& s, const Bounds& b) noexcept {
  const double v = std::clamp(s.velocity, b.velocity_min, b.velocity_max);
  const double a = v < s.velocity ? b.acceleration_min : b.acceleration_max;
  const double t = (v - s.velocity) / a;
  return {t, a, {s.position + t * (s.velocity + v) / 2, v, 0}};
}

Profile shortest_second_order(const MotionState& from, const MotionState& to,
                              const Bounds& b) noexcept {
  const MotionState start{from.position, from.velocity, 0};
  if (from.velocity >= b.velocity_min && from.velocity <= b.velocity_max)
    return ShortestSecondOrder(start, to, b).profile(start, to);
  const Slowed inside = slowed(start, b);
  ShortestSecondOrder shortest(inside.state, to, b);
  shortest.lead(inside.time, inside.acceleration);
  return shortest.profile(start, to);
}

SecondOrder::SecondOrder(const MotionState& from, const MotionState& to, const Bounds& b) noexcept
    : shortest_(from, to, b) {
  const double d = to.position - from.position;
  up_ = {1, from.velocity, to.velocity, b.velocity_max, b.acceleration_max, -b.acceleration_min, d};
  down_ = {
      -1, -from.velocity, -to.velocity, -b.velocity_min, -b.acceleration_min, b.acceleration_max,
      -d};
  for (Way* w : {&up_, &down_}) w->vmax = std::max(w->vmax, w->natural());
  direct_ = up_.duration(up_.natural());
  direct_distance_ = up_.distance(up_.natural());
  rounding_ = rounding_of(from, to, direct_);
}

double SecondOrder::Way::duration(double peak) const noexcept {
  return (peak - v0) / rise + (peak - vf) / fall;
}

double SecondOrder::Way::distance(double peak) const noexcept {
  return (peak - v0) * (peak + v0) / (2 * rise) + (peak - vf) * (peak + vf) / (2 * fall);
}

void SecondOrder::Way::append_cruise(double spare, double excess, Profile& out) const noexcept {
  const double k = 1 / rise + 1 / fall;
  const double m = natural();
  const double more = std::max(excess - m * spare, 0.0);
  const double w = std::sqrt(std::max(spare * spare - 2 * k * more, 0.0));
  const double y = std::min({2 * more / (spare + w), spare / k, vmax - m});
  out.add((y + (m - v0)) / rise, sign * rise);
  out.add(spare - k * y, 0);
  out.add((y + (m - vf)) / fall, -sign * fall);
}

bool SecondOrder::is_direct() const noexcept {
  return std::abs(up_.d - direct_distance_) <= rounding_;
}

bool SecondOrder::lasting(double t, Profile& out) const noexcept {
  const Durations possible = durations();
  if (!possible.allows(t)) return false;
  if (t <= possible.minimum * (1 + rounding)) {
    shortest(out);
    return true;
  }
  const double spare = t - direct_;
  const double excess = up_.d - direct_distance_;
  for (const Way* w : {&up_, &down_})
    if (w->sign * excess > w->natural() * spare) {
      w->append_cruise(spare, w->sign * excess, out);
      return true;
    }
  // Between the two velocities: the change stops half-way for a cruise. (If the spare time is only
  // rounding, the quotient is arbitrary.)
  const double v = std::clamp(excess / spare, -down_.natural(), up_.natural());
  const double a = up_.vf > up_.v0 ? up_.rise : -up_.fall;
  out.add((v - up_.v0) / a, a);
  out.add(spare, 0);
  out.add((up_.vf - v) / a, a);
  return true;
}

Durations SecondOrder::durations() const noexcept {
  Durations out;
  out.minimum = minimum();
  // If both velocities point away from the target, the motion that goes farthest towards it first
  // moves back, and passes the target on its return.
  for (const Way* w : {&up_, &down_}) {
    const double p =
        std::sqrt(std::max((2 * w->d + w->v0 * w->v0 / w->rise + w->vf * w->vf / w->fall) /
                               (1 / w->rise + 1 / w->fall),
                           0.0));
    const bool falls_back = -p > w->natural();
    if (p > 0 && (falls_back || (w->natural() < 0 && is_direct()))) {
      const double back = p <= w->vmax
                              ? w->duration(p)
                              : w->duration(w->vmax) + (w->d - w->distance(w->vmax)) / w->vmax;
      out.blocked[out.count++] = {falls_back ? w->duration(-p) : direct_, back};
    }
  }
  return out;
}

}  // namespace jounce::profiles_detail
