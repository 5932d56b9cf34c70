// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/s_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "profiles/src/moves/duration.hpp"
#include "profiles/src/solver/span.hpp"

// A ramp between rest and velocity v with acceleration a and jerk j is point-symmetric, so it
// covers v/2 times its duration:
//
//   (1)  T(v) = v/a + a/j     where v >= a^2/j   (a is reached)
//   (2)  T(v) = 2 sqrt(v/j)   otherwise
//   (3)  D(v) = v/2 (T1(v) + T2(v))   both ramps of the move
//
// The trapezoid is the limit j -> infinity of (1). In a move over h without cruise, the peak
// velocity solves D(v) = h, where D increases:
//
//   (4)  both by (1):  v^2 (1/a1 + 1/a2)/2 + v (a1/j1 + a2/j2)/2 = h
//   (5)  both by (2):  j1 t^3 (1 + sqrt(j1/j2)) = h   for the jerk time t of the first ramp
//   (6)  mixed, w = sqrt(v):  w^4/(2 a) + w^3/sqrt(k) + w^2 a/(2 j) = h   (a, j: the ramp by (1))

namespace jounce {
namespace {

struct Limit {
  double a, j;
  double per_a = 1 / a;
  double per_j = 1 / j;
  double jerk_time = a * per_j;
  double threshold = a * jerk_time;  // the least velocity for which the ramp reaches a
};

/// One ramp between rest and the peak velocity.
struct RampPhases {
  double jerk;     ///< s, duration of the rise and of the fall of the acceleration
  double plateau;  ///< s, duration of the greatest acceleration

  [[nodiscard]] double duration() const { return 2 * jerk + plateau; }
};

/// Equations (1), (2): the smaller jerk time is valid; it is that of (2) if the plateau would be
/// negative.
JOUNCE_INLINE RampPhases ramp_to(double v, const Limit& r) {  // (1), (2)
  if (v >= r.threshold) return {r.jerk_time, v * r.per_a - r.jerk_time};
  return {std::sqrt(v * r.per_j), 0};
}

JOUNCE_INLINE double way(double v, const Limit& r1, const Limit& r2) {  // (3)
  return v / 2 * (ramp_to(v, r1).duration() + ramp_to(v, r2).duration());
}

JOUNCE_INLINE double peak_both_reach(const Limit& r1, const Limit& r2, double h) {  // (4)
  const double p = (r1.per_a + r2.per_a) / 2;
  const double q = (r1.jerk_time + r2.jerk_time) / 2;
  return 2 * h / (q + std::sqrt(q * q + 4 * p * h));
}

JOUNCE_INLINE double peak_none_reaches(const Limit& r1, const Limit& r2, double h) {  // (5)
  const double ratio = r1.j == r2.j ? 1 : std::sqrt(r1.j / r2.j);
  const double k = r1.j * (1 + ratio);
  const double t = profiles_detail::cube_root(h / k, k / h);
  return r1.j * t * t;
}

double peak_mixed(const Limit& reaching, const Limit& other, double h) {  // (6)
  const profiles_detail::Quartic<double> f{reaching.per_a / 2, 1 / std::sqrt(other.j),
                                           reaching.jerk_time / 2, 0, -h};
  // Without the cubic term the root is greater.
  const double s = 2 * h / (f.c2 + std::sqrt(f.c2 * f.c2 + 4 * f.c4 * h));
  const double w = profiles_detail::largest_root({f, std::sqrt(s)});
  return w * w;
}

JOUNCE_INLINE double peak_velocity(const Limit& r1, const Limit& r2, double h) {
  const auto [low, high] = std::minmax(r1.threshold, r2.threshold);
  if (h >= way(high, r1, r2)) return peak_both_reach(r1, r2, h);
  if (h <= way(low, r1, r2)) return peak_none_reaches(r1, r2, h);
  return r1.threshold < r2.threshold ? peak_mixed(r1, r2, h) : peak_mixed(r2, r1, h);
}

/// Phases shorter than this share of a move are rounding.
constexpr double dust = 1e-15;

double swept(double duration, double total) {
  return duration > dust * total ? duration : 0;
}

/// A ramp that vanishes beside the move would have no length in doubles.
[[gnu::cold]] void refuse_jerk(double jerk, double total) {
  throw InputError("jerk", jerk,
                   "is so high that the ramps of the acceleration are too short to compute beside "
                   "the duration of the move, " +
                       six_digits(total) + " s: lower the jerk, or use profile = \"trapezoid\"");
}

[[gnu::cold]] void refuse(double from, double to, double velocity, double acceleration,
                          double deceleration) {
  require_finite("from", from);
  require_finite("to", to);
  if (from == to)
    throw InputError("to", to, "must differ from `from` = " + number(from) + ": there is no move");
  require_finite("to - from", to - from);
  require_positive("velocity", velocity);
  require_positive("acceleration", acceleration);
  require_not_negative("deceleration", deceleration);
}

bool positive(double x) {
  return x > 0 && x < INFINITY;
}
bool not_negative(double x) {
  return x >= 0 && x < INFINITY;
}

/// The distance of a move whose values are in range.
template <class Spec>
double distance_of(const Spec& s) {
  const double h = std::abs(s.to - s.from);
  const bool good = positive(h) && positive(s.velocity) && positive(s.acceleration) &&
                    not_negative(s.deceleration);
  if (!good) refuse(s.from, s.to, s.velocity, s.acceleration, s.deceleration);
  return h;
}

double or_else(double value, double fallback) {
  return value == 0 ? fallback : value;
}

/// The move over a distance h. If both limits are the same object, the compiler computes only one
/// ramp.
JOUNCE_INLINE Profile ramps_of(const SCurveSpec& spec, double h, const Limit& r1, const Limit& r2) {
  const bool cruises = h > way(spec.velocity, r1, r2);
  const double v = cruises ? spec.velocity : peak_velocity(r1, r2, h);
  const RampPhases up = ramp_to(v, r1);
  const RampPhases down = ramp_to(v, r2);
  const double cruise = cruises ? h / v - (up.duration() + down.duration()) / 2 : 0;
  const double total = up.duration() + cruise + down.duration();
  if (!positive(total)) profiles_detail::refuse_duration(spec.to, total);
  if (up.jerk <= dust * total) refuse_jerk(r1.j, total);
  if (down.jerk <= dust * total) refuse_jerk(r2.j, total);

  const double sign = std::copysign(1, spec.to - spec.from);
  return {{spec.from, 0, 0},
          {spec.to, 0, 0},
          3,
          {sign * r1.j, -sign * r1.j, sign * r2.j, -sign * r2.j},
          {{up.jerk, 1},
           {swept(up.plateau, total), 0},
           {up.jerk, 2},
           {swept(cruise, total), 0},
           {down.jerk, 4},
           {swept(down.plateau, total), 0},
           {down.jerk, 3}}};
}

}  // namespace

Profile trapezoid(const TrapezoidSpec& spec) {
  const double h = distance_of(spec);
  const double a = spec.acceleration;
  const double b = or_else(spec.deceleration, a);
  const double per_a = 1 / a;
  const double per_b = b == a ? per_a : 1 / b;
  const double peak = std::sqrt(2 * h / (per_a + per_b));
  const double v = std::min(peak, spec.velocity);
  const double up = v * per_a;
  const double down = v * per_b;
  const double cruise = h / v - (up + down) / 2;  // only rounding if there is no cruise
  const double total = up + cruise + down;
  if (!positive(total)) profiles_detail::refuse_duration(spec.to, total);

  const double sign = std::copysign(1, spec.to - spec.from);
  return {{spec.from, 0, 0},
          {spec.to, 0, 0},
          2,
          {sign * a, -sign * b},
          {{swept(up, total), 1}, {swept(cruise, total), 0}, {swept(down, total), 2}}};
}

Profile s_curve(const SCurveSpec& spec) {
  const double h = distance_of(spec);
  if (!positive(spec.jerk)) require_positive("jerk", spec.jerk);
  if (!not_negative(spec.deceleration_jerk))
    require_not_negative("deceleration_jerk", spec.deceleration_jerk);
  const Limit up{spec.acceleration, spec.jerk};
  const double deceleration = or_else(spec.deceleration, spec.acceleration);
  const double jerk = or_else(spec.deceleration_jerk, spec.jerk);
  if (deceleration == spec.acceleration && jerk == spec.jerk) return ramps_of(spec, h, up, up);
  return ramps_of(spec, h, up, {deceleration, jerk});
}

}  // namespace jounce
