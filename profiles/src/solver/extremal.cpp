// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/extremal.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/numeric.hpp"

namespace jounce::profiles_detail {
Extremals::Extremals(const End& from, const End& to, double dv, const Limits& limits,
                     const Jerks& jerks, int degenerate) noexcept
    : vmax_(limits.velocity),
      dv_(dv),
      ijp_(jerks.per_rise),
      ijd_(jerks.per_fall),
      k_(jerks.k),
      ik_(jerks.per_k),
      rises_slowly_(jerks.per_rise > uneven * jerks.per_fall),
      first_(degenerate) {
  half_.v = Vector2{from.velocity, to.velocity};
  half_.s = Vector2{from.acceleration, -to.acceleration};
  half_.limit = Vector2{limits.rise, limits.fall};
  const Vector2 s = half_.s;
  const Vector2 squares = s * s;
  half_.c = half_.v - squares * (ijp_ / 2);
  // A half begins at its own s, or where its z is zero.
  half_.gain = s > 0 ? squares * (ijd_ / 2) : -squares * (ijp_ / 2);
  half_.natural = half_.v + half_.gain;
  const Vector2 begun = greatest(s, Vector2{});
  half_.to_sat = k_ / 2 * (half_.limit - begun) * (half_.limit + begun);
  half_.sat = half_.natural + half_.to_sat;
  natural_ = std::max(half_.natural[0], half_.natural[1]);
  // c1 - c2 is computed from differences, so it keeps its digits if the velocities are large.
  const double s0 = half_[0].s;
  const double s1 = half_[1].s;
  const double dc = -dv - (s0 - s1) * (s0 + s1) * ijp_ / 2;
  excess_ = -dv + (s0 - s1) * (s0 + s1) * ijd_ / 2;
  high_ = dc >= 0 ? 0 : 1;
  q_ = 2 * ik_ * std::abs(dc);
  if (half_[static_cast<std::size_t>(first_)].s < 0 && high_ != first_) {  // only by rounding
    high_ = first_;
    q_ = 0;
  }
  const Vector2 start = -s * ijp_ * (half_.c + squares * (ijp_ / 6));
  mean_ = (half_[0].c + half_[1].c) / 2;
  cubic_ = (k_ + ijd_) / 24;
  inverse_ = q_ * q_ * ijp_ / 8;
  base_ = start[0] + start[1];
}

bool Extremals::has_early() const noexcept {
  const auto degenerate = half_[static_cast<std::size_t>(first_)];
  const auto room = half_[static_cast<std::size_t>(1 - first_)];
  const double tolerance = rounding * (std::abs(degenerate.c) + std::abs(room.c) +
                                       k_ * square(degenerate.s) + k_ * square(room.s));
  // difference between the c of both halves
  const double dc = high_ == first_ ? -k_ * q_ / 2 : k_ * q_ / 2;
  return room.s < 0 && degenerate.s > 0 && dc >= -tolerance &&
         dc + k_ * (room.s - degenerate.s) * (room.s + degenerate.s) / 2 >= -tolerance;
}

Extremal Extremals::at_peak(double vp, double beyond) const noexcept {
  Extremal e;
  e.vp = vp + beyond;
  const Vector2 zero{};
  const Vector2 s = half_.s;
  const Vector2 above = vp - half_.v - half_.gain + beyond;
  // A difference of a few last digits gets no phases.
  const Vector2 more = above <= every<Vector2>(rounding * std::abs(vp)) ? zero : above;
  const Vector2 begun = greatest(s, zero);
  // From the same difference as the rise, so that the fall brings the acceleration exactly back to
  // zero.
  const Vector2 free = square_root(begun * begun + 2 * ik_ * more);
  const Vector2 held = more - half_.to_sat;
  e.z = held > zero ? half_.limit : greatest(least(free, half_.limit), s);
  e.hold = greatest(held, zero) / half_.limit;
  e.rise = (e.z - s) * ijp_;
  if (rises_slowly_) {
    const Vector2 squares = held > zero ? (half_.limit - s) * (half_.limit + s) : 2 * ik_ * more;
    e.rise = e.z * s > zero ? squares / (e.z + s) * ijp_ : e.rise;
  }
  e.fall = (e.z[0] + e.z[1]) * ijd_;
  return e;
}

/// The member in which one half has no phase of rising acceleration, so its z is its initial
/// acceleration. The z of the other half has the given sign.
Extremal Extremals::beginning(int which, double sign) const noexcept {
  const auto i = static_cast<std::size_t>(which);
  const auto other = half_[1 - i];
  Extremal e;
  const double s = half_[i].s;
  e.vp = half_[i].v + ijd_ * s * s / 2;
  const double more = which == high_ ? q_ : -q_;
  double squares = 2 * ik_ * (which == 0 ? excess_ : -excess_);
  double z = 0;
  // The square of z, computed from the nearer z.
  const double square_of_z =
      std::abs(other.s) < std::abs(s) ? square(other.s) + squares : square(s) + more;
  // Below zero the limit of the other direction applies, which both ends keep.
  if (sign < 0 || square_of_z < other.limit * other.limit) {
    z = sign * root(square_of_z);
    e.fall = (z * s < 0 ? more / (z - s) : z + s) * ijd_;
    if (sign > 0 && z < other.s) {
      // The fall is more exact than the difference of the rounded accelerations.
      const bool is_rounding = other.s - z <= rounding * other.s;
      z = other.s;
      if (!is_rounding) e.fall = (z + s) * ijd_;
    }
  } else {
    z = other.limit;
    squares = (other.limit - other.s) * (other.limit + other.s);
    // Computed from the change of velocity, which includes rise and fall, because vp and sat may be
    // far above it.
    const double passed = ((z - other.s) * (z + other.s) * ijp_ + (z - s) * (z + s) * ijd_) / 2;
    e.hold = pair(0, std::max(((which == 1 ? dv_ : -dv_) - passed) / z, 0.0), which == 1);
    e.fall = (z + s) * ijd_;
  }
  e.z = pair(s, z, which == 1);
  e.rise = pair(0, rise(other, z, squares), which == 1);
  return e;
}

Extremal Extremals::mirrored(const Extremal& direct) const noexcept {
  const auto i = static_cast<std::size_t>(first_);
  const bool swaps = first_ == 1;
  Extremal e;  // the durations of rise and fall are exchanged
  e.z = pair(direct.z[1 - i], -half_.s[1 - i], swaps);
  e.vp = -half_.c[1 - i];
  e.fall = direct.rise[1 - i];
  e.hold = pair(direct.hold[1 - i], 0, swaps);
  e.rise = pair(direct.fall, 0, swaps);
  return e;
}

Extremal Extremals::first(Branch b) const noexcept {
  return beginning(b == Branch::main ? first_ : 1 - first_, 1);
}

Extremal Extremals::last_early() const noexcept {
  return beginning(first_, -1);
}

double Extremals::distance(const Extremal& e) const noexcept {
  const Vector2 risen = half_.v + e.rise * (half_.s + e.z) / 2;
  const Vector2 v = risen + e.hold * e.z;  // at the beginning and at the end of the fall
  const Vector2 rises = e.rise * ((half_.v + risen) / 2 - e.rise * (e.z - half_.s) / 12);
  const Vector2 holds = e.hold * (risen + v) / 2;
  const Vector2 ramps = rises + holds;
  const double d = ramps[0] + ramps[1];
  if (e.cruise == 0) return d + e.fall * ((v[0] + v[1]) / 2 + e.fall * (e.z[0] + e.z[1]) / 12);
  const Vector2 t = e.z * ijd_;
  const Vector2 falls = t * (v + t * e.z / 3);
  return d + (falls[0] + falls[1]) + e.vp * e.cruise;
}

int Extremals::stretches(Branch b, Stretches& out) const noexcept {
  using Held = Stretch::Held;
  int n = 0;
  const auto add = [&](Held held, int free, double lo, double hi) {
    if (hi > lo) out[static_cast<std::size_t>(n++)] = {held, free, lo, hi};
  };
  const int i = b == Branch::main ? first_ : 1 - first_;
  const auto a = half_[static_cast<std::size_t>(i)];
  const auto o = half_[static_cast<std::size_t>(1 - i)];
  // S as a function of the smaller z.
  const auto sum = [this](double z_high) {
    const double z_low = root(z_high * z_high + q_);
    return z_high < 0 ? q_ / (z_low - z_high) : z_low + z_high;
  };
  double vp = a.c + k_ * square(a.s) / 2;  // the current vp
  if (a.s < 0) {                           // below zero: a is the half with the greater c
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
  const int lower = half_[0].sat <= half_[1].sat ? 0 : 1;  // the half that saturates first
  const auto l = half_[static_cast<std::size_t>(lower)];
  const auto u = half_[static_cast<std::size_t>(1 - lower)];
  const auto z = [this](const Half<double>& h, double v) { return root(2 * ik_ * (v - h.c)); };
  const double c_high = half_[static_cast<std::size_t>(high_)].c;
  // At the beginning of the branch, both z are more exact than those computed from the velocities.
  const bool begins = a.s >= 0;
  const Extremal start = begins ? first(b) : Extremal{};
  const double to_none = std::min(l.sat, vmax_);
  if (vp < to_none) {
    const auto s_at = [&](double v) { return v == inf ? inf : sum(root(2 * ik_ * (v - c_high))); };
    add(Held::none, 0, begins ? start.z[0] + start.z[1] : s_at(vp), s_at(to_none));
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
  using Held = Stretch::Held;
  if (is_timed(p)) return timed(p, time_of(p, x));
  Extremal e;
  switch (p.held) {
    case Held::none: {
      const double r = q_ > 0 ? q_ / x : 0;
      const double z_high = (x - r) / 2;
      e.z = pair(z_high, (x + r) / 2, high_ == 1);
      e.vp = half_.c[static_cast<std::size_t>(high_)] + k_ * square(z_high) / 2;
      e.fall = x * ijd_;
      break;
    }
    case Held::one: {
      const auto f = static_cast<std::size_t>(p.free);
      e.z = pair(x, half_.limit[1 - f], p.free == 1);
      e.fall = (e.z[0] + e.z[1]) * ijd_;
      e.vp = half_[f].c + k_ * x * x / 2;
      e.hold = pair(0, std::max(held_beside(p.free, x), 0.0), p.free == 1);
      break;
    }
    case Held::both:
      return at_peak(x);
    case Held::cruise:
      e = at_peak(vmax_);
      e.cruise = x;
      return e;
  }
  e.rise = (e.z - half_.s) * ijp_;
  return e;
}

std::array<double, 7> Extremals::phases(const Extremal& e) const noexcept {
  const bool cruises = e.cruise > 0;
  double fall = e.fall;
  Vector2 rise = e.rise;
  if (!cruises && std::min(rise[0], rise[1]) < 0) {
    // A rise that is negative by rounding is subtracted from the other one, so the duration and the
    // final acceleration do not change. Its remainder is dropped.
    const std::size_t i = rise[0] < 0 ? 0 : 1;
    rise[1 - i] += rise[i];
    rise[i] = 0;
    const double less = -std::min(rise[1 - i], 0.0);
    // The fall compensates for this, unless it is only rounding of the acceleration.
    if (less > rounding * (std::abs(half_[0].s) + std::abs(half_[1].s)) * ijp_)
      fall += less * ijd_ / ijp_;
  }
  return {
      rise[0],   e.hold[0], cruises ? e.z[0] * ijd_ : fall, e.cruise, cruises ? e.z[1] * ijd_ : 0,
      e.hold[1], rise[1]};
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
    if (is_timed(p)) return timed(p, time_lasting(p, t));
    double x = 0;
    switch (p.held) {
      case Stretch::Held::none:
        x = (t + ends) / k_;
        break;
      case Stretch::Held::one: {
        const double l = half_[static_cast<std::size_t>(1 - p.free)].limit;
        const double w = k_ * l + held_beside(p.free, 0) - ends - t;
        x = -l + root(l * l - 2 * l * w / k_);
        break;
      }
      case Stretch::Held::both: {
        e = member(p, p.lo);
        const double per_velocity = 1 / half_[0].limit + 1 / half_[1].limit;
        x = (t - duration(e)) / per_velocity;
        if (std::min(e.rise[0], e.rise[1]) <= 0)  // rounding may have reduced a hold to zero
          x += (t - duration(at_peak(p.lo, x))) / per_velocity;
        return at_peak(p.lo, std::clamp(x, 0.0, p.hi - p.lo));
      }
      case Stretch::Held::cruise:
        x = t - duration(at_peak(vmax_));
        break;
    }
    return member(p, std::clamp(x, p.lo, p.hi));
  }
  return e;
}

}  // namespace jounce::profiles_detail
