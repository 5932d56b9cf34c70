// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/detail/lanes.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "profiles/src/solver/tolerances.hpp"

// The fastest way over a distance between two velocities, a = 0 at both ends, under |v| <= V,
// |a| <= A, |j| <= J. Free of branches, so that a loop over many of them becomes vector code.
//
// A ramp over dv is point-symmetric: it covers its mean velocity times its duration
//
//   (1)  T(dv) = dv/A + tau   where dv >= A tau,   tau = A/J    (A is reached)
//   (2)  T(dv) = 2 sqrt(dv/J) otherwise
//
// Let l <= h be the two velocities, d = h - l, and D0 = (l + h)/2 T(d) the distance of the direct
// ramp. For a distance D >= D0 the motion goes up to a peak p >= h and down again; a shorter
// distance is the mirror image. The peak follows from D, by (1) or (2) for each of the two ramps:
//
//   (3)  both reach A, z = (p - h)/A:
//          A z^2 + (2h + A tau) z = D - (l + h)/2 (d/A + tau) - h tau,   duration 2z + d/A + 2 tau
//   (4)  only the ramp from l does, x = sqrt((p - h)/J):
//          J^2/(2A) x^4 + J x^3 + (h/tau + A/2) x^2 + 2h x = D - (l + h)/2 (d/A + tau),
//                                                                duration 2x + (d + J x^2)/A + tau
//   (5)  none does, x and y = sqrt((p - l)/J), q = x + y:  with y^2 - x^2 = d/J = m and
//        D/J = (x + y)((l + h)/J + x y),
//          q^4 + 4 (l + h)/J q^2 - 4 D/J q - m^2 = 0,                                  duration 2 q
//
// The required root is the largest one: if h < 0, D(p) falls before it grows. The polynomials are
// convex beyond that root.
namespace jounce::profiles_detail {

/// Magnitudes for which no product or quotient in these formulas overflows or underflows, for any
/// ratios. move_to() accepts a wider range, and is exact for these.
inline constexpr double least_magnitude = 1e-30;
inline constexpr double greatest_magnitude = 1e30;

template <class Real>
JOUNCE_INLINE Mask<Real> is_moderate(Real x) {  // zero included
  return magnitude(x) <= greatest_magnitude;
}
template <class Real>
JOUNCE_INLINE Mask<Real> is_magnitude(Real x) {
  return (x >= least_magnitude) & (x <= greatest_magnitude);
}
template <class Real>
JOUNCE_INLINE Mask<Real> is_way(Real x) {  // a distance of either sign, or zero
  return is_magnitude(magnitude(x)) | (x == 0);
}
template <class Real>
JOUNCE_INLINE Mask<Real> is_limit(Real x) {  // infinity included
  return (x >= least_magnitude) & ((x <= greatest_magnitude) | (x == __builtin_inf()));
}

/// Limits, and the quotients that all formulas use.
template <class Real>
struct Rates {
  Real a, j, inv_a, inv_j, tau, threshold;

  JOUNCE_INLINE Rates(Real acceleration, Real jerk)
      : a(acceleration), j(jerk), inv_a(1 / a), inv_j(1 / j), tau(a * inv_j), threshold(a * tau) {}

  /// Equations (1), (2): the smaller jerk time is valid, which is the time of (2) if the plateau
  /// would be negative.
  [[nodiscard]] JOUNCE_INLINE Real ramp(Real dv) const {
    return 2 * least(tau, square_root(dv * inv_j)) + greatest(dv * inv_a - tau, every<Real>(0));
  }
};

/// A quartic whose greatest root is required.
template <class Real>
struct Quartic {
  Real c4, c3, c2, c1, c0;

  /// The next point of Halley's method: Newton's, corrected for the curvature.
  [[nodiscard]] JOUNCE_INLINE Real next(Real x) const {
    const Real f = (((c4 * x + c3) * x + c2) * x + c1) * x + c0;
    const Real slope = ((4 * c4 * x + 3 * c3) * x + 2 * c2) * x + c1;
    const Real half_bend = (6 * c4 * x + 3 * c3) * x + c2;
    return x - f * slope / (slope * slope - f * half_bend);
  }
};

template <class Real>
struct Start {
  Quartic<Real> f;
  Real x;  ///< above the root, rarely by more than 60 %
};

/// A distance with its velocities in ascending order; D >= D0.
template <class Real>
struct Span {
  Rates<Real> rates;
  Real D, l, h, d;
  Real direct;  ///< duration of the direct ramp
  Mask<Real> mirrored;
  Mask<Real> is_direct;  ///< D = D0 to rounding: a detour would be much longer

  JOUNCE_INLINE Span(Real distance, Real entry, Real exit, const Rates<Real>& r) : rates(r) {
    const Real lower = least(entry, exit);
    const Real upper = greatest(entry, exit);
    d = upper - lower;
    direct = r.ramp(d);
    const Real over = distance - 0.5 * (lower + upper) * direct;
    mirrored = over < 0;
    is_direct = magnitude(over) <= one_rounding * direct * (magnitude(lower) + magnitude(upper));
    D = mirrored ? -distance : distance;
    l = mirrored ? -upper : lower;
    h = mirrored ? -lower : upper;
  }

  /// D minus the distance of a direct ramp that reaches A.
  [[nodiscard]] JOUNCE_INLINE Real over() const {
    return D - 0.5 * (l + h) * (d * rates.inv_a + rates.tau);
  }

  /// The z of (3).
  [[nodiscard]] JOUNCE_INLINE Real both() const {
    const Real b = 2 * h + rates.threshold;
    const Real r = over() - h * rates.tau;
    const Real w = square_root(b * b + 4 * rates.a * r);
    return b > 0 ? 2 * r / (b + w) : (w - b) * 0.5 * rates.inv_a;
  }

  /// True if (5) applies instead of (4). This is decided at the peak at which the ramp from l just
  /// reaches A.
  [[nodiscard]] JOUNCE_INLINE Mask<Real> none() const {
    const Real p = l + rates.threshold;
    const Real x = square_root(rates.tau * rates.tau - d * rates.inv_j);
    return (d < rates.threshold) & (D < (l + p) * rates.tau + (h + p) * x);
  }

  /// The start for (4). Without the positive terms above x^2 the root is greater; and it is at most
  /// tau.
  [[nodiscard]] JOUNCE_INLINE Start<Real> one_start() const {
    const Real j_a = rates.j * rates.inv_a;
    const Quartic<Real> f{0.5 * rates.j * j_a, rates.j, h * j_a + 0.5 * rates.a, 2 * h, -over()};
    const Real w = square_root(f.c1 * f.c1 - 4 * f.c2 * f.c0);
    const Real x = f.c1 > 0 ? -2 * f.c0 / (f.c1 + w) : (w - f.c1) / (2 * f.c2);
    return {f, f.c2 > 0 ? least(x, rates.tau) : rates.tau};
  }

  /// The start for (5). The root is at most the sum of the roots of q^4 + 4c q^2 = m^2 and of q^3 +
  /// 4c q = k.
  [[nodiscard]] JOUNCE_INLINE Start<Real> none_start() const {
    const Real c = (l + h) * rates.inv_j;
    const Real k = 4 * D * rates.inv_j;
    const Real m = d * rates.inv_j;
    const Real w = square_root(4 * c * c + m * m);
    const Real s = square_root(c > 0 ? m * m / (2 * c + w) : w - 2 * c);
    const Real t = k > 0 ? 1.04 * rough_cube_root(k) : every<Real>(0);
    const Real zero = every<Real>(0);
    return {{zero + 1, zero, 4 * c, -k, -m * m}, s + (4 * c * t > k ? 0.25 * k / c : t)};
  }
};

/// The duration of a motion, and the signed velocity at which it cruises or reverses its
/// acceleration.
template <class Real>
struct Way {
  Real duration;
  Real peak;
};

template <class Real>
JOUNCE_INLINE Way<Real> both_way(const Span<Real>& s, Real z) {
  return {2 * z + s.d * s.rates.inv_a + 2 * s.rates.tau, s.h + s.rates.a * z};
}
template <class Real>
JOUNCE_INLINE Way<Real> one_way(const Span<Real>& s, Real x) {
  const Real rise = s.rates.j * x * x;
  return {2 * x + (s.d + rise) * s.rates.inv_a + s.rates.tau, s.h + rise};
}
template <class Real>
JOUNCE_INLINE Way<Real> none_way(const Span<Real>& s, Real q) {
  const Real x = 0.5 * (q - s.d * s.rates.inv_j / q);
  return {2 * q, s.h + s.rates.j * x * x};
}

/// A motion with a cruise at the velocity v; it exists if the duration of its cruise is >= 0.
template <class Real>
struct Cruise {
  Way<Real> way;
  Real duration;
};
template <class Real>
JOUNCE_INLINE Cruise<Real> cruise_way(const Span<Real>& s, Real v) {
  const Real rise = s.rates.ramp(v - s.l);
  const Real fall = s.rates.ramp(v - s.h);
  const Real ramps = 0.5 * ((v + s.l) * rise + (v + s.h) * fall);
  const Real cruise = (s.D - ramps) / v;
  return {{rise + cruise + fall, v}, cruise};
}

/// From rest to rest over D > 0: l = h = d = 0. Then (3) is A z^2 + A tau z = D, and (5) is q^3 = 4
/// D/J.
template <class Real>
JOUNCE_INLINE Way<Real> rest_way(const Rates<Real>& r, Real D, Real velocity) {
  const Real z = 2 * D / (r.threshold + square_root(r.threshold * r.threshold + 4 * r.a * D));
  const Real q = cube_root(4 * D * r.inv_j, 0.25 * r.j / D);
  const Mask<Real> reach = z >= r.tau;
  const Real turning = reach ? 2 * (z + r.tau) : 2 * q;
  const Real turn = reach ? r.a * z : 0.25 * r.j * q * q;
  const Mask<Real> cruises = turn > velocity;
  return {cruises ? D / velocity + r.ramp(velocity) : turning, cruises ? velocity : turn};
}

/// Number of Halley's steps that is sufficient for nearly every root: each step triples the number
/// of correct digits.
constexpr int usual_steps = 4;
constexpr int most_steps = 64;

/// True if the step from `before` to `after` is the last one: the next relative change is about the
/// cube of this one.
template <class Real>
JOUNCE_INLINE Mask<Real> settled(Real before, Real after) {
  return magnitude(after - before) <= last_cubic_step * after;
}

inline double largest_root(const Start<double>& start) {
  double before = start.x;
  double x = start.x;
  const auto step = [&] {
    before = x;
    x = start.f.next(x);
  };
  for (int i = 0; i < usual_steps; ++i) step();
  for (int i = usual_steps; i < most_steps && !settled(before, x); ++i) step();
  return x;
}

/// The motion with a velocity limit, which may be infinite. Computes one branch at a time.
inline Way<double> fastest(const Span<double>& s, double velocity) {
  if (s.is_direct) return {s.direct, s.h};
  if (velocity < __builtin_inf())
    if (const Cruise<double> cruise = cruise_way(s, velocity); cruise.duration >= 0)
      return cruise.way;
  const double z = greatest(s.both(), 0.0);
  if (z >= s.rates.tau) return both_way(s, z);
  return s.none() ? none_way(s, largest_root(s.none_start()))
                  : one_way(s, largest_root(s.one_start()));
}

}  // namespace jounce::profiles_detail
