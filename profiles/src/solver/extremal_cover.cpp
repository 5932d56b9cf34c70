// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "jounce/profiles/detail/lanes.hpp"
#include "jounce/profiles/detail/numeric.hpp"

#include "profiles/src/solver/extremal.hpp"
#include "profiles/src/solver/zero.hpp"

// Finds the member of the family that covers a given distance.
//
// While nothing is held, (1) gives z_low^2 - z_high^2 = q. With the sum S = z1 + z2, which grows
// with T by (2), z_high = (S - q/S)/2 and z_low = (S + q/S)/2, and (4) integrates to
//
//   (5)  d = K + k (m S + (k + 1/jd) S^3/24 - q^2/(8 jp S)),   m = (c1 + c2)/2
//
// While one half holds z = L, the peak acceleration x of the other half is the variable. With w the
// duration for which the held half holds at x = 0,
//
//   (6)  d = K' + k (c x + (L/(2 jd) + c/L) x^2/2 + (k + 1/jd) x^3/6 + k x^4/(8 L))
//
// While both hold, vp runs. With y = vp - vp1, (7) d = d1 + (1/L1 + 1/L2)((vp1 + L1 L2/(2 jd)) y +
// y^2/2).
// K = -sum of c s/jp + s^3/(6 jp^2) over both halves; K' is (3) of both halves at x = 0.

namespace jounce::profiles_detail {
namespace {

/// A power of two within a factor of 4 of the cube root. Unlike std::cbrt, it gives the same result
/// in units that differ by powers of two.
double about_cube_root(double x) {
  return x > 0 ? std::ldexp(1.0, (std::ilogb(x) + 3000) / 3 - 999) : 0;
}

}  // namespace

/// The sum for which of_sum is g, by (5).
double Extremals::solve_sum(double g, double lo, double hi, bool rising,
                            double guess) const noexcept {
  const auto f = [&](double s, double& sign) {
    const double ss = s * s;
    sign = ss * (mean_ + cubic_ * ss) - g * s - inverse_;            // s f
    const double slope = ss * (mean_ + 3 * cubic_ * ss) + inverse_;  // s^2 f'
    // A step in the square of s, of which f is almost linear.
    const double share = newton(sign, slope, rising);
    return s * share * (1 + std::clamp(share, -0.5, 0.5) / 2);
  };
  if (hi == inf) {
    hi = std::max({2 * lo, about_cube_root(std::abs(g) / cubic_),
                   std::sqrt(std::abs(mean_) / cubic_), std::sqrt(std::sqrt(inverse_ / cubic_))});
    guess = hi;
    for (double sign = -1; (void)f(hi, sign), sign < 0;) hi *= 2;
  }
  return zero(f, lo, hi, rising, guess);
}

/// The member of the stretch that covers the distance d, which must exist.
Extremal Extremals::solve(const Stretch& p, double d, bool rising, double guess) const noexcept {
  using Held = Stretch::Held;
  if (is_timed(p)) return solve_time(p, d, rising);
  double hi = p.hi;
  switch (p.held) {
    case Held::none:
      return member(p, solve_sum((d - base_) * ik_, p.lo, p.hi, rising, guess));
    case Held::one: {
      const auto x = half_[static_cast<std::size_t>(p.free)];
      const auto held = half_[static_cast<std::size_t>(1 - p.free)];
      const double l = held.limit;
      const double h0 = held_beside(p.free, 0);  // hold at x = 0; may be negative
      const double k0 = base_ + held.c * l * ijp_ + cube(l) * ijp_ * ijp_ / 6 +
                        h0 * (held.c + l * l * ijp_ / 2 + l * h0 / 2) + x.c * l * ijd_ -
                        cube(l) * ijd_ * ijd_ / 6;
      const double g = (d - k0) / k_;
      const double c2 = l * ijd_ / 4 + x.c / (2 * l);
      const double c3 = 4 * cubic_;
      const double c4 = k_ / (8 * l);
      const auto f = [&](double y, double& sign) {
        sign = y * (x.c + y * (c2 + y * (c3 + y * c4))) - g;
        return newton(sign, x.c + y * (2 * c2 + y * (3 * c3 + y * 4 * c4)), rising);
      };
      if (hi == inf) {
        hi = std::max(2 * std::abs(p.lo), l);
        guess = hi;
        for (double sign = -1; (void)f(hi, sign), sign < 0;) hi *= 2;
      }
      const double y = zero(f, p.lo, hi, rising, guess);
      const Extremal e = member(p, y);
      if (!(y > uneven * l)) return e;
      // The terms are y/L times as large as the sum over the phases, so one more step with that sum
      // follows.
      const double slope = k_ * (x.c + y * (2 * c2 + y * (3 * c3 + y * 4 * c4)));
      const double next = y - newton(distance(e) - d, slope, rising);
      return next > p.lo && next < hi ? member(p, next) : e;
    }
    case Held::both: {
      const Extremal e = at_peak(p.lo);
      const double h = slope(e);
      const double g = (d - distance(e)) / (1 / half_[0].limit + 1 / half_[1].limit);
      const double r = root(h * h + 2 * g);
      const double signed_root = rising ? r : -r;
      const double y = rising == (h > 0) ? 2 * g / (h + signed_root) : signed_root - h;
      const Extremal found = at_peak(p.lo, std::clamp(y, 0.0, p.hi - p.lo));
      if (std::min(e.rise[0], e.rise[1]) > 0) return found;
      // At the beginning, rounding may have reduced a hold of a few last digits to zero: one more
      // step.
      const double less =
          (distance(found) - d) / (slope(found) * (1 / half_[0].limit + 1 / half_[1].limit));
      return at_peak(p.lo, std::clamp(y - less, 0.0, p.hi - p.lo));
    }
    case Held::cruise:
      break;
  }
  Extremal e = at_peak(vmax_);
  e.cruise = (d - distance(e)) / vmax_;
  return e;
}

/// The zeros of (4) in a stretch, ascending.
int Extremals::turning(const Stretch& p, std::array<double, 2>& out) const noexcept {
  double lo = inf;
  double hi = inf;
  if (p.held == Stretch::Held::none) {
    const double w = mean_ * mean_ - 12 * cubic_ * inverse_;
    if (mean_ < 0 && w >= 0) {
      const double r = -mean_ + std::sqrt(w);
      lo = std::sqrt(2 * inverse_ / r);
      hi = std::sqrt(r / (6 * cubic_));
    }
  } else if (p.held == Stretch::Held::one) {
    const double c = half_[static_cast<std::size_t>(p.free)].c;
    const double l = half_[static_cast<std::size_t>(1 - p.free)].limit * ijd_ / 2;
    const double w = l * l - 2 * k_ * c;
    if (w >= 0) {
      lo = (-l - std::sqrt(w)) / k_;
      hi = (-l + std::sqrt(w)) / k_;
    }
  } else if (p.held == Stretch::Held::both) {
    lo = -half_[0].limit * half_[1].limit * ijd_ / 2;
  }
  int n = 0;
  for (const double x : {lo, hi})
    if (x > p.lo && x < p.hi) out[static_cast<std::size_t>(n++)] = x;
  return n;
}

int Extremals::covering(Branch b, double d, Members& out, int most) const noexcept {
  if (b == Branch::early && high_ == first_) return 0;  // this branch is no longer than rounding
  Stretches all;
  const int stretches_in_use = stretches(b, all);
  int found = 0;
  double before = distance(first(b));
  for (int i = 0; i < stretches_in_use && found < most; ++i) {
    Stretch piece = all[static_cast<std::size_t>(i)];
    const double end = piece.hi;
    // The distance may rise, fall and rise again. After it rises with both z > 0, it always rises.
    const Extremal begin = member(piece, piece.lo);
    std::array<double, 2> turns;
    const bool turns_somewhere = std::min(begin.z[0], begin.z[1]) < 0 || slope(begin) < 0;
    const int n = turns_somewhere ? turning(piece, turns) : 0;
    for (int k = 0; k <= n && found < most; ++k) {
      piece.hi = k < n ? turns[static_cast<std::size_t>(k)] : end;
      const double after = piece.hi == inf ? inf : distance(member(piece, piece.hi));
      if ((before < d) != (after < d))
        out[static_cast<std::size_t>(found++)] = solve(piece, d, after > before, piece.hi);
      before = after;
      piece.lo = piece.hi;
    }
  }
  return found;
}

Extremal Extremals::cover(double d, const Extremal& begin, double covered) const noexcept {
  Extremal lo = begin;
  double from = lo.z[0] + lo.z[1];
  const double g = (d - base_) * ik_;
  const bool is_below = half_[static_cast<std::size_t>(first_)].s < 0;  // below zero acceleration
  if (rises_slowly_ || (is_below && begin.hold[static_cast<std::size_t>(1 - first_)] > 0)) {
    Members members{begin};
    (void)covering(Branch::main, d, members, 1);
    return members[0];
  }
  if (is_below) {
    // The same formula applies on both sides of zero acceleration. But the distance may have risen
    // and fallen again before.
    // and fallen again, before that.
    lo.vp = natural_;
    const Stretch p{Stretch::Held::none, 0, from, std::sqrt(q_)};
    std::array<double, 2> turns;
    const int n = mean_ < 0 ? turning(p, turns) : 0;
    const bool rises_first = n > 0 && slope(begin) > 0;
    if (rises_first && of_sum(turns[0]) >= g)
      return member(p, solve_sum(g, from, turns[0], true, turns[0]));
    if (n > 0) from = turns[static_cast<std::size_t>(n - 1)];
    if (std::min({half_[0].sat, half_[1].sat, vmax_}) <= natural_) {  // there is nothing above
      const Extremal top = at_peak(natural_);
      const double reach = distance(top);
      if (reach >= d) return member(p, solve_sum(g, from, p.hi, true, p.hi));
      lo = top;
      covered = reach;
    }
  }
  const int lower = half_[0].sat <= half_[1].sat ? 0 : 1;
  const auto free = static_cast<std::size_t>(1 - lower);
  const double first_sat = std::min(half_[1 - free].sat, vmax_);
  const double second_sat = std::min(half_[free].sat, vmax_);
  // A stretch is almost linear in the square of its parameter.
  const auto guess = [](double x0, double x1, double share) {
    return std::sqrt(x0 * x0 + (x1 - x0) * (x1 + x0) * share);
  };
  if (first_sat > lo.vp) {
    if (first_sat == inf)
      return member({Stretch::Held::none, 0, from, inf}, solve_sum(g, from, inf, true, 0));
    const Extremal hi = at_peak(first_sat);
    const double to = hi.z[0] + hi.z[1];
    const double reach = of_sum(to);
    if (reach >= g) {
      const double begun = of_sum(from);
      return member({Stretch::Held::none, 0, from, to},
                    solve_sum(g, from, to, true, guess(from, to, (g - begun) / (reach - begun))));
    }
    lo = hi;
    covered = base_ + k_ * reach;
  }
  if (second_sat > lo.vp) {
    Stretch p{Stretch::Held::one, 1 - lower, lo.z[free], inf};
    if (second_sat == inf) return solve(p, d, true, 0);
    const Extremal hi = at_peak(second_sat);
    const double reach = distance(hi);
    if (reach >= d) {
      p.hi = hi.z[free];
      return solve(p, d, true, guess(p.lo, p.hi, (d - covered) / (reach - covered)));
    }
    lo = hi;
    covered = reach;
  }
  if (vmax_ > lo.vp) {
    const Extremal hi = vmax_ == inf ? lo : at_peak(vmax_);
    const double reach = vmax_ == inf ? inf : distance(hi);
    if (reach >= d) {
      const Stretch p{Stretch::Held::both, 0, lo.vp, vmax_};
      return solve(p, d, true, 0);
    }
    lo = hi;
    covered = reach;
  }
  lo.cruise = (d - covered) / vmax_;
  return lo;
}

/// The velocity of cruising() to about nine digits; NaN if these steps do not find it. A half that
/// passes zero acceleration at velocity c covers less than a cruise. With p = 1/jp, the difference
/// is
///
///   (11)  k (k + p) z^3/6 + h (z^2 (k + p) + h z)/2 - (vp - c) s p + s^3 p^2/6
double Extremals::cruise_velocity(double t, double d) const noexcept {
  const Vector2 c = half_.c;
  const Vector2 s = half_.s;
  const Vector2 limit = half_.limit;
  const Vector2 per_limit = 1 / limit;
  const Vector2 begun = s * ijp_;
  const double sum = k_ + ijp_;
  double vp = std::max(d / t, natural_);
  for (int i = 0; i < 8; ++i) {
    const Vector2 z = greatest(least(limit, square_root(2 * ik_ * (vp - c))), s);
    const Vector2 h = greatest(vp - half_.sat, Vector2{}) * per_limit;
    const Vector2 lasts = k_ * z + h - begun;
    const Vector2 lost = z * z * (k_ * sum / 6 * z + h * (sum / 2)) + h * h * z / 2 -
                         begun * (vp - c - begun * s / 6);
    const double cruise = t - (lasts[0] + lasts[1]);
    if (!(cruise > 0)) break;
    const double step = (d - vp * t + (lost[0] + lost[1])) / ((z[0] + z[1]) * ijd_ / 2 + cruise);
    vp += step;
    if (std::abs(step) <= 1e-5 * vp) return vp;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The motion whose peak velocity exceeds the natural one by `above`.
Extremal Extremals::cruising_above(double above, double t) const noexcept {
  Extremal e = at_peak(natural_, above);
  e.cruise = t - duration(e);
  return e;
}

/// The step: (distance of such a motion - d) / slope. The slope is (z1 + z2)/(2 jd) plus the
/// duration of the cruise.
double Extremals::cruising_step(const Extremal& e, double d, double& sign) const noexcept {
  sign = distance(e) - d;
  return sign / ((e.z[0] + e.z[1]) * ijd_ / 2 + e.cruise);
}

bool Extremals::soon_cruising(double t, double d, Extremal& out) const noexcept {
  const double guess = cruise_velocity(t, d) - natural_;
  if (!(guess > 0)) return false;
  double sign = 0;
  const double step = cruising_step(cruising_above(guess, t), d, sign);
  const double above = guess - step;
  if (!(std::abs(step) <= 1e-8 * above && natural_ + above <= vmax_)) return false;
  out = cruising_above(above, t);
  return out.cruise >= 0;
}

bool Extremals::cruising(double t, double d, double slack, Extremal& out) const noexcept {
  if (soon_cruising(t, d, out)) return true;
  const Extremal farthest = lasting(Branch::main, t);
  if (distance(farthest) < d - slack) return false;
  const auto f = [&](double above, double& sign) {
    return cruising_step(cruising_above(above, t), d, sign);
  };
  // If the ramps took no time, the peak velocity would be the mean velocity.
  out = cruising_above(zero(f, 0, farthest.vp - natural_, true, d / t - natural_), t);
  // Near the farthest member, rounding of the peak velocity may leave no time for a cruise.
  if (!(out.cruise > 0)) out = farthest;
  return true;
}

}  // namespace jounce::profiles_detail
