#include "jounce/profiles/detail/extremal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// While nothing is held, (1) gives z_low^2 - z_high^2 = q. With the sum S = z1 + z2, which grows
// with T by (2), z_high = (S - q/S)/2 and z_low = (S + q/S)/2, and (4) integrates to
//
//   (5)  d = K + k (m S + (k + 1/jd) S^3/24 - q^2/(8 jp S)),   m = (c1 + c2)/2
//
// While one half holds z = L, the peak acceleration x of the other runs, with w = the held half's
// hold at x = 0,
//
//   (6)  d = K' + k (c x + (L/(2 jd) + c/L) x^2/2 + (k + 1/jd) x^3/6 + k x^4/(8 L))
//
// While both hold, vp runs: (7) d = d1 + (1/L1 + 1/L2) ((vp1 + L1 L2/(2 jd)) y + y^2/2), y = vp - vp1.
// K = -sum of c s/jp + s^3/(6 jp^2) over both halves; K' is (3) of both halves at x = 0.

namespace jounce::detail {
namespace {

constexpr double rounding = 0x1p-49;  // eight units in the last place
constexpr double inf = std::numeric_limits<double>::infinity();

double square(double x) {
  return x * x;
}
double cube(double x) {
  return x * x * x;
}
double root(double x) {
  return std::sqrt(std::max(x, 0.0));
}

/// A power of two within a factor of 4 of the cube root: the same in all units that are powers of two
/// of each other, which std::cbrt is not.
double about_cube_root(double x) {
  return x > 0 ? std::ldexp(1.0, (std::ilogb(x) + 3000) / 3 - 999) : 0;
}

/// Halley's step from where f has this value and derivatives; none (NaN) where f does not go the way
/// that it does at the zero.
double halley(double f, double first, double second, bool rising) {
  if ((first > 0) != rising) return std::numeric_limits<double>::quiet_NaN();
  return 2 * f * first / (2 * first * first - f * second);
}

/// The zero of a monotone f in [lo, hi], or the nearer end: by the steps that f answers with, from a
/// guess, kept inside by bisection. f says the sign of its value.
template <class F>
double zero(F f, double lo, double hi, bool rising, double guess) {
  double x = guess > lo && guess < hi ? guess : lo + (hi - lo) / 2;
  for (int i = 0; i < 100; ++i) {
    double sign = 0;
    const double step = f(x, sign);
    if (sign == 0) break;
    ((sign < 0) == rising ? lo : hi) = x;
    double next = x - step;
    const bool inside = next > lo && next < hi;
    // Convergence is quadratic at least: after such a step the next is lost in rounding.
    const bool done = std::abs(step) <= 1e-9 * std::abs(x);
    if (!inside || i > 60) {
      if (done) return next > lo ? hi : lo;
      next = lo + (hi - lo) / 2;
      if (!(next > lo && next < hi)) break;
    }
    x = next;
    if (done) break;
  }
  return x;
}

}  // namespace

Extremals::Extremals(const End& from, const End& to, const Limits& limits, const Jerks& jerks,
                     int degenerate) noexcept
    : vmax_(limits.velocity),
      ijp_(jerks.per_rise),
      ijd_(jerks.per_fall),
      k_(jerks.k),
      ik_(jerks.per_k),
      first_(degenerate) {
  const auto half = [this](double v, double s, double limit) {
    const double c = v - s * s * ijp_ / 2;
    // A half begins at its own s, or where its z passes zero.
    const double natural = s > 0 ? v + s * s * ijd_ / 2 : c;
    return Half{s, limit, c, c + k_ * limit * limit / 2, natural};
  };
  half_ = {half(from.velocity, from.acceleration, limits.rise),
           half(to.velocity, -to.acceleration, limits.fall)};
  natural_ = std::max(half_[0].natural, half_[1].natural);
  // c1 - c2 from differences, so that what is small does not drown in the velocities.
  const double s0 = half_[0].s;
  const double s1 = half_[1].s;
  const double dc = (from.velocity - to.velocity) - (s0 - s1) * (s0 + s1) * ijp_ / 2;
  high_ = dc >= 0 ? 0 : 1;
  q_ = 2 * ik_ * std::abs(dc);
  if (half_[static_cast<std::size_t>(first_)].s < 0 && high_ != first_) {  // by rounding alone
    high_ = first_;
    q_ = 0;
  }
  const auto start = [this](const Half& h) { return -h.s * ijp_ * (h.c + square(h.s) * ijp_ / 6); };
  mean_ = (half_[0].c + half_[1].c) / 2;
  cubic_ = (k_ + ijd_) / 24;
  inverse_ = q_ * q_ * ijp_ / 8;
  base_ = start(half_[0]) + start(half_[1]);
}

bool Extremals::has_early() const noexcept {
  const Half& degenerate = half_[static_cast<std::size_t>(first_)];
  const Half& room = half_[static_cast<std::size_t>(1 - first_)];
  const double tolerance = rounding * (std::abs(degenerate.c) + std::abs(room.c) +
                                       k_ * square(degenerate.s) + k_ * square(room.s));
  const double dc = high_ == first_ ? -k_ * q_ / 2 : k_ * q_ / 2;  // room.c - degenerate.c
  return room.s < 0 && degenerate.s > 0 && dc >= -tolerance &&
         dc + k_ * (room.s - degenerate.s) * (room.s + degenerate.s) / 2 >= -tolerance;
}

Extremal Extremals::at_peak(double vp) const noexcept {
  Extremal e;
  e.vp = vp;
  for (std::size_t i = 0; i < 2; ++i) {
    const Half& h = half_[i];
    if (vp - h.natural <= rounding * std::abs(vp)) {
      e.z[i] = std::max(h.s, 0.0);  // no phases for the sake of the last digits
    } else if (vp <= h.sat) {
      e.z[i] = std::max(std::min(root(2 * ik_ * (vp - h.c)), h.limit), h.s);
    } else {
      e.z[i] = h.limit;
      e.hold[i] = (vp - h.sat) / h.limit;
    }
  }
  return e;
}

/// The member at which one half has no phase of rising acceleration: its z is where it begins. The
/// other half's z has the given sign.
Extremal Extremals::beginning(int which, double sign) const noexcept {
  const auto i = static_cast<std::size_t>(which);
  const Half& other = half_[1 - i];
  Extremal e;
  const double s = half_[i].s;
  e.z[i] = s;
  e.vp = half_[i].c + k_ * s * s / 2;
  const double square_of_z = s * s + (which == high_ ? q_ : -q_);
  if (square_of_z < other.limit * other.limit) {
    const double z = sign * root(square_of_z);
    e.z[1 - i] = sign > 0 ? std::max(z, other.s) : z;
  } else {
    e.z[1 - i] = sign * other.limit;
    e.hold[1 - i] = std::max((e.vp - other.sat) / other.limit, 0.0);
  }
  return e;
}

Extremal Extremals::first(Branch b) const noexcept {
  return beginning(b == Branch::main ? first_ : 1 - first_, 1);
}

Extremal Extremals::last_early() const noexcept {
  return beginning(first_, -1);
}

double Extremals::duration(const Extremal& e) const noexcept {
  return k_ * (e.z[0] + e.z[1]) - (half_[0].s + half_[1].s) * ijp_ + e.hold[0] + e.hold[1] +
         e.cruise;
}

double Extremals::distance(const Extremal& e) const noexcept {
  const bool only_passes = e.hold[0] + e.hold[1] + e.cruise == 0 && std::min(e.z[0], e.z[1]) > 0;
  if (only_passes) return base_ + k_ * of_sum(e.z[0] + e.z[1]);
  double d = e.vp * ((e.z[0] + e.z[1]) * ijd_ + e.cruise);
  for (std::size_t i = 0; i < 2; ++i) {
    const Half& h = half_[i];
    const double z = e.z[i];
    const double t = e.hold[i];
    const double zz = z * z;
    const double p = ijp_ / 6;
    d += (z - h.s) * ijp_ * (h.c + (zz + z * h.s + h.s * h.s) * p) - zz * z * (ijd_ * ijd_ / 6);
    if (t > 0) d += t * (h.c + 3 * zz * p + z * t / 2);
  }
  return d;
}

int Extremals::stretches(Branch b, Stretches& out) const noexcept {
  using Held = Stretch::Held;
  int n = 0;
  const auto add = [&](Held held, int free, double lo, double hi) {
    if (hi > lo) out[static_cast<std::size_t>(n++)] = {held, free, lo, hi};
  };
  const int i = b == Branch::main ? first_ : 1 - first_;
  const auto& a = half_[static_cast<std::size_t>(i)];
  const auto& o = half_[static_cast<std::size_t>(1 - i)];
  // S in terms of the smaller z.
  const auto sum = [this](double z_high) {
    const double z_low = root(z_high * z_high + q_);
    return z_high < 0 ? q_ / (z_low - z_high) : z_low + z_high;
  };
  double vp = a.c + k_ * square(a.s) / 2;  // where we are
  if (a.s < 0) {                           // below zero: a is the high half
    const double end = b == Branch::main ? 0 : -root(2 * ik_ * (o.c + k_ * square(o.s) / 2 - a.c));
    double x = a.s;
    const double held_beyond = -root(square(o.limit) - q_);
    if (x < held_beyond) {
      const double to = std::min(held_beyond, end);
      add(Held::one, i, x, to);
      x = to;
    }
    if (x < end) add(Held::none, 0, sum(x), sum(end));
    if (b == Branch::early) return n;
    vp = a.c;
  } else if (b == Branch::early) {
    return n;
  }
  const int lower = half_[0].sat <= half_[1].sat ? 0 : 1;  // saturates first
  const auto& l = half_[static_cast<std::size_t>(lower)];
  const auto& u = half_[static_cast<std::size_t>(1 - lower)];
  const auto z = [this](const Half& h, double v) { return root(2 * ik_ * (v - h.c)); };
  const double c_high = half_[static_cast<std::size_t>(high_)].c;
  const double to_none = std::min(l.sat, vmax_);
  if (vp < to_none) {
    const auto s_at = [&](double v) { return v == inf ? inf : sum(root(2 * ik_ * (v - c_high))); };
    add(Held::none, 0, s_at(vp), s_at(to_none));
    vp = to_none;
  }
  const double to_one = std::min(u.sat, vmax_);
  if (vp < to_one) {
    add(Held::one, 1 - lower, z(u, vp), to_one == inf ? inf : z(u, to_one));
    vp = to_one;
  }
  if (vp < vmax_) add(Held::both, 0, vp, vmax_);
  if (vmax_ < inf) add(Held::cruise, 0, 0, inf);
  return n;
}

Extremal Extremals::member(const Stretch& p, double x) const noexcept {
  Extremal e;
  switch (p.held) {
    case Stretch::Held::none: {
      const auto hi = static_cast<std::size_t>(high_);
      const double r = q_ > 0 ? q_ / x : 0;
      e.z[hi] = (x - r) / 2;
      e.z[1 - hi] = (x + r) / 2;
      for (std::size_t i = 0; i < 2; ++i) e.z[i] = std::max(e.z[i], half_[i].s);
      e.vp = half_[hi].c + k_ * square(e.z[hi]) / 2;
      break;
    }
    case Stretch::Held::one: {
      const auto f = static_cast<std::size_t>(p.free);
      e.z[f] = x;
      e.z[1 - f] = half_[1 - f].limit;
      e.vp = half_[f].c + k_ * x * x / 2;
      e.hold[1 - f] = std::max((e.vp - half_[1 - f].sat) / half_[1 - f].limit, 0.0);
      break;
    }
    case Stretch::Held::both:
      e = at_peak(x);
      break;
    case Stretch::Held::cruise:
      e = at_peak(vmax_);
      e.cruise = x;
      break;
  }
  return e;
}

/// (5): the sum at which of_sum is g.
double Extremals::solve_sum(double g, double lo, double hi, bool rising,
                            double guess) const noexcept {
  const auto f = [&](double s, double& sign) {
    const double ss = s * s;
    sign = ss * (mean_ + cubic_ * ss) - g * s - inverse_;            // s f
    const double slope = ss * (mean_ + 3 * cubic_ * ss) + inverse_;  // s^2 f'
    const double curvature = 6 * cubic_ * ss * ss - 2 * inverse_;    // s^3 f''
    return s * halley(sign, slope, curvature, rising);
  };
  if (hi == inf) {
    hi = std::max({2 * lo, about_cube_root(std::abs(g) / cubic_),
                   std::sqrt(std::abs(mean_) / cubic_), std::sqrt(std::sqrt(inverse_ / cubic_))});
    guess = hi;
    for (double sign = -1; (void)f(hi, sign), sign < 0;) hi *= 2;
  }
  return zero(f, lo, hi, rising, guess);
}

/// Where in the stretch the distance d is covered; it is covered there.
double Extremals::solve(const Stretch& p, double d, bool rising, double guess) const noexcept {
  double hi = p.hi;
  switch (p.held) {
    case Stretch::Held::none:
      return solve_sum((d - base_) * ik_, p.lo, p.hi, rising, guess);
    case Stretch::Held::one: {
      const auto& x = half_[static_cast<std::size_t>(p.free)];
      const auto& held = half_[static_cast<std::size_t>(1 - p.free)];
      const double l = held.limit;
      const double h0 = (x.c - held.sat) / l;  // hold at x = 0, may be negative
      const double k0 = base_ + held.c * l * ijp_ + cube(l) * ijp_ * ijp_ / 6 +
                        h0 * (held.c + l * l * ijp_ / 2 + l * h0 / 2) + x.c * l * ijd_ -
                        cube(l) * ijd_ * ijd_ / 6;
      const double g = (d - k0) / k_;
      const double c2 = l * ijd_ / 4 + x.c / (2 * l);
      const double c3 = 4 * cubic_;
      const double c4 = k_ / (8 * l);
      const auto f = [&](double y, double& sign) {
        sign = y * (x.c + y * (c2 + y * (c3 + y * c4))) - g;
        return halley(sign, x.c + y * (2 * c2 + y * (3 * c3 + y * 4 * c4)),
                      2 * c2 + y * (6 * c3 + y * 12 * c4), rising);
      };
      if (hi == inf) {
        hi = std::max(2 * std::abs(p.lo), l);
        guess = hi;
        for (double sign = -1; (void)f(hi, sign), sign < 0;) hi *= 2;
      }
      return zero(f, p.lo, hi, rising, guess);
    }
    case Stretch::Held::both: {
      const Extremal e = at_peak(p.lo);
      const double h = slope(e);
      const double g = (d - distance(e)) / (1 / half_[0].limit + 1 / half_[1].limit);
      const double r = root(h * h + 2 * g);
      const double y = !rising ? -h - r : (h > 0 ? 2 * g / (h + r) : r - h);
      return std::clamp(p.lo + y, p.lo, p.hi);
    }
    case Stretch::Held::cruise: {
      const Extremal e = at_peak(vmax_);
      return (d - distance(e)) / vmax_;
    }
  }
  return p.lo;
}

/// Where (4) is zero in a stretch, ascending.
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
  if (b == Branch::early && high_ == first_) return 0;  // no longer than rounding
  Stretches all;
  const int stretches_in_use = stretches(b, all);
  int found = 0;
  double before = distance(first(b));
  for (int i = 0; i < stretches_in_use && found < most; ++i) {
    Stretch piece = all[static_cast<std::size_t>(i)];
    const double end = piece.hi;
    // The distance may rise, fall and rise again; once it rises with both z > 0 it goes on rising.
    const Extremal begin = member(piece, piece.lo);
    std::array<double, 2> turns;
    const bool turns_somewhere = std::min(begin.z[0], begin.z[1]) < 0 || slope(begin) < 0;
    const int n = turns_somewhere ? turning(piece, turns) : 0;
    for (int k = 0; k <= n && found < most; ++k) {
      piece.hi = k < n ? turns[static_cast<std::size_t>(k)] : end;
      const double after = piece.hi == inf ? inf : distance(member(piece, piece.hi));
      if ((before < d) != (after < d))
        out[static_cast<std::size_t>(found++)] =
            member(piece, solve(piece, d, after > before, piece.hi));
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
  if (half_[static_cast<std::size_t>(first_)].s < 0) {
    if (begin.hold[static_cast<std::size_t>(1 - first_)] > 0) {
      Members members{begin};
      (void)covering(Branch::main, d, members, 1);
      return members[0];
    }
    // The velocity passes zero acceleration with the same formula; but the distance may have risen,
    // and fallen again, before that.
    lo.vp = natural_;
    const Stretch p{Stretch::Held::none, 0, from, std::sqrt(q_)};
    std::array<double, 2> turns;
    const int n = mean_ < 0 ? turning(p, turns) : 0;
    const bool rises_first = n > 0 && slope(begin) > 0;
    if (rises_first && of_sum(turns[0]) >= g)
      return member(p, solve_sum(g, from, turns[0], true, turns[0]));
    if (n > 0) from = turns[static_cast<std::size_t>(n - 1)];
  }
  const int lower = half_[0].sat <= half_[1].sat ? 0 : 1;
  const auto free = static_cast<std::size_t>(1 - lower);
  const double first_sat = std::min(half_[1 - free].sat, vmax_);
  const double second_sat = std::min(half_[free].sat, vmax_);
  // In the square of its parameter, a stretch is about linear.
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
    if (second_sat == inf) return member(p, solve(p, d, true, 0));
    const Extremal hi = at_peak(second_sat);
    const double reach = distance(hi);
    if (reach >= d) {
      p.hi = hi.z[free];
      return member(p, solve(p, d, true, guess(p.lo, p.hi, (d - covered) / (reach - covered))));
    }
    lo = hi;
    covered = reach;
  }
  if (vmax_ > lo.vp) {
    const Extremal hi = vmax_ == inf ? lo : at_peak(vmax_);
    const double reach = vmax_ == inf ? inf : distance(hi);
    if (reach >= d) {
      const Stretch p{Stretch::Held::both, 0, lo.vp, vmax_};
      return member(p, solve(p, d, true, 0));
    }
    lo = hi;
    covered = reach;
  }
  lo.cruise = (d - covered) / vmax_;
  return lo;
}

Extremal Extremals::cruising(double t, double d, double top) const noexcept {
  // Of the peak velocity: the distance, whose slope is (z1 + z2)/(2 jd) plus the time at cruise.
  const auto at = [&](double vp) {
    Extremal e = at_peak(vp);
    e.cruise = t - duration(e);
    return e;
  };
  const auto f = [&](double vp, double& sign) {
    const Extremal e = at(vp);
    sign = distance(e) - d;
    return sign / ((e.z[0] + e.z[1]) * ijd_ / 2 + e.cruise);
  };
  // Without the time that the ramps take, the mean velocity would do.
  return at(zero(f, natural_, top, true, d / t));
}

std::array<double, 7> Extremals::phases(const Extremal& e) const noexcept {
  const bool cruises = e.cruise > 0;
  return {(e.z[0] - half_[0].s) * ijp_,
          e.hold[0],
          (cruises ? e.z[0] : e.z[0] + e.z[1]) * ijd_,
          e.cruise,
          cruises ? e.z[1] * ijd_ : 0,
          e.hold[1],
          (e.z[1] - half_[1].s) * ijp_};
}

Extremal Extremals::lasting(Branch b, double t) const noexcept {
  Stretches all;
  const int n = stretches(b, all);
  const double ends = (half_[0].s + half_[1].s) * ijp_;
  Extremal e = first(b);
  for (int i = 0; i < n; ++i) {
    const Stretch& p = all[static_cast<std::size_t>(i)];
    if (p.hi != inf) {
      e = member(p, p.hi);
      if (duration(e) < t) continue;
    }
    double x = p.lo;
    switch (p.held) {
      case Stretch::Held::none:
        x = (t + ends) / k_;
        break;
      case Stretch::Held::one: {
        const auto& free = half_[static_cast<std::size_t>(p.free)];
        const auto& held = half_[static_cast<std::size_t>(1 - p.free)];
        const double l = held.limit;
        const double w = k_ * l + (free.c - held.sat) / l - ends - t;
        x = -l + root(l * l - 2 * l * w / k_);
        break;
      }
      case Stretch::Held::both: {
        e = member(p, p.lo);
        x = p.lo + (t - duration(e)) / (1 / half_[0].limit + 1 / half_[1].limit);
        break;
      }
      case Stretch::Held::cruise:
        x = t - duration(at_peak(vmax_));
        break;
    }
    return member(p, std::clamp(x, p.lo, p.hi));
  }
  return e;
}

}  // namespace jounce::detail
