#include "jounce/profiles/detail/second_order.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::detail {
namespace {

constexpr double ulps = 0x1p-49;

}  // namespace

SecondOrder::SecondOrder(const MotionState& from, const MotionState& to, const Bounds& b) noexcept {
  const double d = to.position - from.position;
  up_ = {1, from.velocity, to.velocity, b.velocity_max, b.acceleration_max, -b.acceleration_min, d};
  down_ = {
      -1, -from.velocity, -to.velocity, -b.velocity_min, -b.acceleration_min, b.acceleration_max,
      -d};
  for (Way* w : {&up_, &down_}) w->vmax = std::max(w->vmax, w->natural());
  direct_ = up_.duration(up_.natural());
  direct_distance_ = up_.distance(up_.natural());
  rounding_ = ulps * (std::abs(from.position) + std::abs(to.position) +
                      direct_ * (std::abs(from.velocity) + std::abs(to.velocity)));
}

double SecondOrder::Way::duration(double peak) const noexcept {
  return (peak - v0) / rise + (peak - vf) / fall;
}

double SecondOrder::Way::distance(double peak) const noexcept {
  return (peak - v0) * (peak + v0) / (2 * rise) + (peak - vf) * (peak + vf) / (2 * fall);
}

double SecondOrder::Way::peak() const noexcept {
  const double square = (2 * d + v0 * v0 / rise + vf * vf / fall) / (1 / rise + 1 / fall);
  return std::max(std::sqrt(std::max(square, 0.0)), natural());
}

double SecondOrder::Way::above(double v, double other, double its_rate,
                               double peak) const noexcept {
  // (2) gives p^2 - v^2 without p.
  const double squares = (2 * d - (v - other) * (v + other) / its_rate) / (1 / rise + 1 / fall);
  return v > 0 ? std::max(squares, 0.0) / (peak + v) : peak - v;
}

void SecondOrder::Way::append_peak(double peak, Profile& out) const noexcept {
  out.add(above(v0, vf, fall, peak) / rise, sign * rise);
  out.add(above(vf, v0, rise, peak) / fall, -sign * fall);
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

void SecondOrder::Way::append(double peak, double cruise, Profile& out) const noexcept {
  out.add((peak - v0) / rise, sign * rise);
  out.add(cruise, 0);
  out.add((peak - vf) / fall, -sign * fall);
}

const SecondOrder::Way& SecondOrder::way() const noexcept {
  return up_.d >= direct_distance_ ? up_ : down_;
}

bool SecondOrder::is_direct() const noexcept {
  return std::abs(up_.d - direct_distance_) <= rounding_;
}

double SecondOrder::minimum() const noexcept {
  if (is_direct()) return direct_;
  const Way& w = way();
  const double peak = w.peak();
  if (peak <= w.vmax) return w.duration(peak);
  return w.duration(w.vmax) + (w.d - w.distance(w.vmax)) / w.vmax;
}

void SecondOrder::shortest(Profile& out) const noexcept {
  const Way& w = way();
  if (is_direct()) return w.append(w.natural(), 0, out);
  const double peak = w.peak();
  if (peak <= w.vmax)
    w.append_peak(peak, out);
  else
    w.append(w.vmax, (w.d - w.distance(w.vmax)) / w.vmax, out);
}

bool SecondOrder::lasting(double t, Profile& out) const noexcept {
  const Durations possible = durations();
  if (!possible.allows(t)) return false;
  if (t <= possible.minimum * (1 + ulps)) {
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
  // Between the two velocities: the change stops half-way to cruise. (Of a time that is rounding alone,
  // the quotient may be anything.)
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
  // With both velocities against the way, the farthest that can be reached along it first falls
  // back, and passes the target on its return.
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

}  // namespace jounce::detail
