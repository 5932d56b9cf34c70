// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/numeric.hpp"

#include "profiles/src/solver/extremal.hpp"
#include "profiles/src/solver/zero.hpp"

// Members of the family by the duration of a phase, for jerks that are far apart. x is the time in
// which the acceleration of a half changes from s to z, g = s x + jp x^2/2 the velocity gained in
// this time, and n = v + s^2/(2 jd). Then (1) becomes
//
//   (8)   vp = n + k jp g + z h
//
// **jp is the small one.** While nothing is held, X = x1 + x2 runs. With S = z1 + z2 = s1 + s2 + jp
// X, equal vp give
//
//   (9)   x1 - x2 = (2 (n2 - n1)/(k jp) + (s2 - s1) X)/S,   dT/dX = k jp
//
// Exception: s1 + s2 far below zero. Then the rises take as long as whole ramps and keep their
// digits. The same equations apply to jerks that are not far apart while the acceleration keeps its
// sign. While one half holds z = L, x of the other half is the variable, and dT/dx = k jp (1 +
// z/L).
//
// **Otherwise** digits are lost only if the acceleration keeps its sign. One half holds L; the
// other has z = jd y - L, where y, the duration of the fall, may be short compared with L/jd. Then
//
//   (10)  h = (c - c' + k jd y (z - L)/2)/L,   dT/dy = k jd (1 + z/L),   c': of the half that holds

namespace jounce::profiles_detail {

bool Extremals::is_timed(const Stretch& p) const noexcept {
  if (p.held == Stretch::Held::one) return rises_slowly_ || p.hi <= 0;
  if (p.held != Stretch::Held::none) return false;
  const double s0 = half_[0].s;
  const double s1 = half_[1].s;
  if (!(uneven * (s0 + s1) > -(std::abs(s0) + std::abs(s1)))) return false;
  if (rises_slowly_) return true;
  // Also if the acceleration keeps its sign, and lasts long compared with its change.
  const bool keeps_sign = p.hi * p.hi <= q_ * (1 + rounding);
  return keeps_sign && (s0 + s1 >= 0 || ijd_ <= uneven * ijp_);
}

Extremal Extremals::timed_none(double x) const noexcept {
  const double s0 = half_[0].s;
  const double s1 = half_[1].s;
  const double sum = s0 + s1 + x / ijp_;
  const double apart = sum > 0 ? (-2 * excess_ * ijp_ * ik_ + (s1 - s0) * x) / sum : 0;
  Extremal e;
  e.rise = Vector2{x + apart, x - apart} / 2;
  e.z = Vector2{s0, s1} + e.rise / ijp_;
  e.fall = sum * ijd_;
  e.vp = half_[0].v + e.rise[0] * (s0 + e.z[0]) / 2 + square(e.z[0]) * ijd_ / 2;
  return e;
}

Extremal Extremals::timed_one(int free, double x) const noexcept {
  const auto f = static_cast<std::size_t>(free);
  const auto h = half_[f];
  const auto held = half_[1 - f];
  const double l = held.limit;
  const double z = rises_slowly_ ? h.s + x / ijp_ : x / ijd_ - l;
  Extremal e;
  e.z[f] = z;
  e.z[1 - f] = l;
  e.rise[f] = rises_slowly_ ? x : (z - h.s) * ijp_;
  e.rise[1 - f] = (l - held.s) * ijp_;
  e.fall = rises_slowly_ ? (z + l) * ijd_ : x;
  const double gained = e.rise[f] * (h.s + z) / 2;
  e.vp = h.v + gained + z * z * ijd_ / 2;
  const double apart = free == high_ ? k_ * q_ / 2 : -k_ * q_ / 2;  // c - c' of both halves
  const double over = rises_slowly_ ? (free == 0 ? excess_ : -excess_) + k_ / ijp_ * gained -
                                          k_ * (l - held.s) * (l + held.s) / 2
                                    : apart + k_ / ijd_ * x * (z - l) / 2;
  e.hold[1 - f] = std::max(over / l, 0.0);
  return e;
}

Extremal Extremals::timed(const Stretch& p, double x) const noexcept {
  return p.held == Stretch::Held::none ? timed_none(x) : timed_one(p.free, x);
}

/// The time at which the parameter of a stretch (z, or the sum of both) has the value z.
double Extremals::time_of(const Stretch& p, double z) const noexcept {
  if (p.held == Stretch::Held::none) return (z - (half_[0].s + half_[1].s)) * ijp_;
  const auto f = static_cast<std::size_t>(p.free);
  return rises_slowly_ ? (z - half_[f].s) * ijp_ : (z + half_[1 - f].limit) * ijd_;
}

double Extremals::time_lasting(const Stretch& p, double t) const noexcept {
  if (p.held == Stretch::Held::none) return ijp_ * ik_ * (t - (half_[0].s + half_[1].s) * ijd_);
  const auto f = static_cast<std::size_t>(p.free);
  const double begin = time_of(p, p.lo);
  const Extremal e = timed(p, begin);
  const double sum = e.z[f] + e.z[1 - f];
  // added to the square of the sum
  const double squares = 2 * ik_ * e.z[1 - f] * (t - duration(e));
  const double end = root(sum * sum + squares);
  return rises_slowly_ ? begin + ijp_ * (sum > 0 ? squares / (sum + end) : end - sum) : ijd_ * end;
}

Extremal Extremals::solve_time(const Stretch& p, double d, bool rising) const noexcept {
  const bool by_rise = rises_slowly_ || p.held == Stretch::Held::none;
  const double rate = k_ / (by_rise ? ijp_ : ijd_);  // dT/dx, without the holds
  const auto f = [&](double x, double& sign) {
    const Extremal e = timed(p, x);
    sign = distance(e) - d;
    const double held = p.held == Stretch::Held::one
                            ? e.fall / (e.z[static_cast<std::size_t>(1 - p.free)] * ijd_)
                            : 1;
    const auto h = half_[0];
    const double v = h.v + e.rise[0] * (h.s + e.z[0]) / 2 + e.z[0] * e.hold[0];
    return newton(sign, (v + e.z[0] * e.fall / 2) * rate * held, rising);  // (4)
  };
  // The ends of the stretch are not more exact than the numbers from which they follow: the
  // accelerations or, for slow rises, the velocities c.
  double terms = std::abs(half_[0].s) + std::abs(half_[1].s) + std::abs(p.lo);
  if (rises_slowly_ && p.lo != 0)
    terms += ik_ * (std::abs(half_[0].c) + std::abs(half_[1].c)) / std::abs(p.lo);
  const double slack = rounding * std::max(ijp_, ijd_) * terms;
  const double lo = time_of(p, p.lo) - slack;
  double hi = time_of(p, p.hi) + slack;
  if (p.hi == inf) {
    hi = std::max(2 * lo, slack);
    for (double sign = -1; (void)f(hi, sign), sign < 0;) hi *= 2;
  }
  return timed(p, zero(f, lo, hi, rising, hi));
}

}  // namespace jounce::profiles_detail
