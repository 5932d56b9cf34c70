#pragma once

#include <bit>
#include <cstdint>

// The fastest way over a distance between two velocities, a = 0 at both ends, under |v| <= V,
// |a| <= A, |j| <= J. Free of branches, so that a loop over many of them becomes vector code.
//
// A ramp over dv is point-symmetric: it covers its mean velocity times its duration
//
//   (1)  T(dv) = dv/A + tau   where dv >= A tau,   tau = A/J    (A is reached)
//   (2)  T(dv) = 2 sqrt(dv/J) otherwise
//
// Let l <= h be the two velocities, d = h - l, and D0 = (l + h)/2 T(d) the way of the direct ramp.
// For a distance D >= D0 the way goes up to a peak p >= h and down again; a shorter one is the
// mirror image. The peak follows from D, by (1) and (2) for either ramp:
//
//   (3)  both reach A, z = (p - h)/A:
//          A z^2 + (2h + A tau) z = D - (l + h)/2 (d/A + tau) - h tau,     duration 2z + d/A + 2 tau
//   (4)  only the ramp from l does, x = sqrt((p - h)/J):
//          J^2/(2A) x^4 + J x^3 + (h/tau + A/2) x^2 + 2h x = D - (l + h)/2 (d/A + tau),
//                                                                duration 2x + (d + J x^2)/A + tau
//   (5)  none does, x and y = sqrt((p - l)/J), q = x + y:  with y^2 - x^2 = d/J = m and
//        D/J = (x + y)((l + h)/J + x y),
//          q^4 + 4 (l + h)/J q^2 - 4 D/J q - m^2 = 0,                                  duration 2 q
//
// The root meant is the largest: where h < 0, D(p) dips before it grows. The polynomials are convex
// beyond it.
namespace jounce::detail {

#define JOUNCE_INLINE inline __attribute__((always_inline))

JOUNCE_INLINE double least(double a, double b) {
  return a < b ? a : b;
}
JOUNCE_INLINE double greatest(double a, double b) {
  return a > b ? a : b;
}
JOUNCE_INLINE double square_root(double x) {  // of what rounding makes negative: 0
  return __builtin_sqrt(greatest(x, 0));
}

/// The cube root within 4 %, for normal x > 0: a third of the exponent, linear in between.
JOUNCE_INLINE double rough_cube_root(double x) {
  const std::uint64_t third = ((std::bit_cast<std::uint64_t>(x) >> 32U) * 0x55555556U) >> 32U;
  return std::bit_cast<double>((third + 0x2a9f7893U) << 32U);
}

/// The cube root within an ulp or two, for normal x > 0: a series in 1 - r^3/x about the rough root r,
/// good to 1e-8, then one of Newton's steps.
JOUNCE_INLINE double cube_root(double x) {
  const double r = rough_cube_root(x);
  const double e = 1 - r * r * (r / x);
  const double series =
      1 + e * (1. / 3 + e * (2. / 9 + e * (14. / 81 +
                                           e * (35. / 243 + e * (91. / 729 + e * (728. / 6561))))));
  const double y = r * series;
  return y - (y - x / (y * y)) * (1. / 3);
}

/// Limits, with what every formula needs of them.
struct Rates {
  double a, j, inv_a, inv_j, tau, threshold;

  JOUNCE_INLINE Rates(double acceleration, double jerk)
      : a(acceleration), j(jerk), inv_a(1 / a), inv_j(1 / j), tau(a * inv_j), threshold(a * tau) {}

  /// (1), (2): the smaller jerk time is the one that holds; a negative plateau says that (2) does.
  [[nodiscard]] JOUNCE_INLINE double ramp(double dv) const {
    return 2 * least(tau, square_root(dv * inv_j)) + greatest(dv * inv_a - tau, 0);
  }
};

/// A quartic of which the largest root is wanted.
struct Quartic {
  double c4, c3, c2, c1, c0;

  /// Halley's next point: Newton's, with the curvature taken into account.
  [[nodiscard]] JOUNCE_INLINE double next(double x) const {
    const double f = (((c4 * x + c3) * x + c2) * x + c1) * x + c0;
    const double slope = ((4 * c4 * x + 3 * c3) * x + 2 * c2) * x + c1;
    const double half_bend = (6 * c4 * x + 3 * c3) * x + c2;
    return x - f * slope / (slope * slope - f * half_bend);
  }
};

struct Start {
  Quartic f;
  double x;  ///< above the root wanted, rarely by more than 60 %
};

/// A distance with its velocities in order, D >= D0.
struct Span {
  Rates rates;
  double D, l, h, d;
  bool mirrored;

  JOUNCE_INLINE Span(double distance, double entry, double exit, const Rates& r) : rates(r) {
    const double lower = least(entry, exit);
    const double upper = greatest(entry, exit);
    d = upper - lower;
    mirrored = distance < 0.5 * (lower + upper) * r.ramp(d);
    D = mirrored ? -distance : distance;
    l = mirrored ? -upper : lower;
    h = mirrored ? -lower : upper;
  }

  /// D less the way of a direct ramp that reaches A.
  [[nodiscard]] JOUNCE_INLINE double over() const {
    return D - 0.5 * (l + h) * (d * rates.inv_a + rates.tau);
  }

  /// z of (3).
  [[nodiscard]] JOUNCE_INLINE double both() const {
    const double b = 2 * h + rates.threshold;
    const double r = over() - h * rates.tau;
    const double w = square_root(b * b + 4 * rates.a * r);
    return b > 0 ? 2 * r / (b + w) : (w - b) * 0.5 * rates.inv_a;
  }

  /// Is (5) the case, not (4)? Asked of the peak at which the ramp from l just reaches A.
  [[nodiscard]] JOUNCE_INLINE bool none() const {
    const double p = l + rates.threshold;
    const double x = square_root(rates.tau * rates.tau - d * rates.inv_j);
    return d < rates.threshold && D < (l + p) * rates.tau + (h + p) * x;
  }

  /// (4). Without the positive terms above x^2 the root is larger; and it is at most tau.
  [[nodiscard]] JOUNCE_INLINE Start one_start() const {
    const double j_a = rates.j * rates.inv_a;
    const Quartic f{0.5 * rates.j * j_a, rates.j, h * j_a + 0.5 * rates.a, 2 * h, -over()};
    const double w = square_root(f.c1 * f.c1 - 4 * f.c2 * f.c0);
    const double x = f.c1 > 0 ? -2 * f.c0 / (f.c1 + w) : (w - f.c1) / (2 * f.c2);
    return {f, f.c2 > 0 ? least(x, rates.tau) : rates.tau};
  }

  /// (5). The root is at most that of q^4 + 4c q^2 = m^2 plus that of q^3 + 4c q = k.
  [[nodiscard]] JOUNCE_INLINE Start none_start() const {
    const double c = (l + h) * rates.inv_j;
    const double k = 4 * D * rates.inv_j;
    const double m = d * rates.inv_j;
    const double w = square_root(4 * c * c + m * m);
    const double s = square_root(c > 0 ? m * m / (2 * c + w) : w - 2 * c);
    const double t = k > 0 ? 1.04 * rough_cube_root(k) : 0;
    return {{1, 0, 4 * c, -k, -m * m}, s + (4 * c * t > k ? 0.25 * k / c : t)};
  }
};

/// How long a way takes, and the velocity at which it cruises or turns over, signed.
struct Way {
  double duration;
  double peak;
};

JOUNCE_INLINE Way both_way(const Span& s, double z) {
  return {2 * z + s.d * s.rates.inv_a + 2 * s.rates.tau, s.h + s.rates.a * z};
}
JOUNCE_INLINE Way one_way(const Span& s, double x) {
  const double rise = s.rates.j * x * x;
  return {2 * x + (s.d + rise) * s.rates.inv_a + s.rates.tau, s.h + rise};
}
JOUNCE_INLINE Way none_way(const Span& s, double q) {
  const double x = 0.5 * (q - s.d * s.rates.inv_j / q);
  return {2 * q, s.h + s.rates.j * x * x};
}

/// With a cruise at velocity v, whose duration tells whether there is one (>= 0).
struct Cruise {
  Way way;
  double duration;
};
JOUNCE_INLINE Cruise cruise_way(const Span& s, double v) {
  const double rise = s.rates.ramp(v - s.l);
  const double fall = s.rates.ramp(v - s.h);
  const double ramps = 0.5 * ((v + s.l) * rise + (v + s.h) * fall);
  const double cruise = (s.D - ramps) / v;
  return {{rise + cruise + fall, v}, cruise};
}

/// Halley's steps that settle nearly every root: each triples the number of correct digits.
constexpr int usual_steps = 4;
constexpr int most_steps = 64;

/// Has a step from `before` to `after` arrived? The next would change about the cube of this.
JOUNCE_INLINE bool settled(double before, double after) {
  return __builtin_fabs(after - before) <= 1e-5 * after;
}

inline double largest_root(const Start& start) {
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

/// The way under a velocity limit, which may be infinite, one branch at a time.
inline Way fastest(const Span& s, double velocity) {
  const Cruise cruise = cruise_way(s, velocity);
  if (cruise.duration >= 0) return cruise.way;
  const double z = greatest(s.both(), 0);
  if (z >= s.rates.tau) return both_way(s, z);
  return s.none() ? none_way(s, largest_root(s.none_start()))
                  : one_way(s, largest_root(s.one_start()));
}

}  // namespace jounce::detail
