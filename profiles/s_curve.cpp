#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/s_curve.hpp"

// A ramp between rest and velocity v under acceleration a and jerk j is point-symmetric, so that it
// covers v/2 times its duration:
//
//   (1)  T(v) = v/a + a/j     where v >= a^2/j   (a is reached)
//   (2)  T(v) = 2 sqrt(v/j)   otherwise
//   (3)  D(v) = v/2 (T1(v) + T2(v))   both ramps of the move
//
// The trapezoid is the limit j -> infinity of (1). The peak velocity of a move over h that does not
// cruise solves D(v) = h, with D increasing:
//
//   (4)  both by (1):  v^2 (1/a1 + 1/a2)/2 + v (a1/j1 + a2/j2)/2 = h
//   (5)  both by (2):  v^(3/2) (1/sqrt(j1) + 1/sqrt(j2)) = h
//   (6)  mixed, w = sqrt(v):  w^4/(2 a) + w^2 a/(2 j) + w^3/sqrt(k) = h   (a, j: the ramp by (1))

namespace jounce {
namespace {

struct Ramp {
  double a;
  double j;  // infinity: acceleration may step

  [[nodiscard]] double jerk_time() const { return a / j; }
  [[nodiscard]] double threshold() const { return a * jerk_time(); }
  [[nodiscard]] bool reaches_a(double v) const { return v >= threshold(); }
  [[nodiscard]] double duration(double v) const {  // (1), (2)
    return reaches_a(v) ? v / a + jerk_time() : 2 * std::sqrt(v / j);
  }
};

double peak_both_reach(const Ramp& r1, const Ramp& r2, double h) {  // (4)
  const double p = (1 / r1.a + 1 / r2.a) / 2;
  const double q = (r1.jerk_time() + r2.jerk_time()) / 2;
  return 2 * h / (q + std::sqrt(q * q + 4 * p * h));
}

double peak_none_reaches(const Ramp& r1, const Ramp& r2, double h) {  // (5)
  const double k = h / (1 / std::sqrt(r1.j) + 1 / std::sqrt(r2.j));
  return std::cbrt(k * k);
}

double peak_mixed(const Ramp& reaching, const Ramp& other, double h) {  // (6)
  const double c4 = 1 / (2 * reaching.a);
  const double c3 = 1 / std::sqrt(other.j);
  const double c2 = reaching.jerk_time() / 2;
  // Each term alone bounds the root from above; (6) is convex, so Newton descends from there.
  double w = std::min({std::sqrt(std::sqrt(h / c4)), std::cbrt(h / c3), std::sqrt(h / c2)});
  for (int i = 0; i < 60; ++i) {
    const double f = w * w * (c2 + w * (c3 + w * c4)) - h;
    const double df = w * (2 * c2 + w * (3 * c3 + w * 4 * c4));
    const double next = w - f / df;
    if (!(next < w)) break;
    w = next;
  }
  return w * w;
}

double peak_velocity(const Ramp& r1, const Ramp& r2, double h) {
  const double reach = peak_both_reach(r1, r2, h);
  if (r1.reaches_a(reach) && r2.reaches_a(reach)) return reach;
  const double none = peak_none_reaches(r1, r2, h);
  if (!r1.reaches_a(none) && !r2.reaches_a(none)) return none;
  return r1.threshold() < r2.threshold() ? peak_mixed(r1, r2, h) : peak_mixed(r2, r1, h);
}

/// One ramp between rest and v, as it stands in a profile.
struct Phases {
  double ramp = 0;     ///< s, of rising and of falling acceleration
  double plateau = 0;  ///< s, at the greatest acceleration
};

Phases phases(const Ramp& r, double v) {
  if (!r.reaches_a(v)) return {std::sqrt(v / r.j), 0};
  return {r.jerk_time(), v / r.a - r.jerk_time()};
}

void add_ramp(Profile& move, const Ramp& r, const Phases& phases, double sign) {
  if (std::isinf(r.j)) return move.add(phases.plateau, sign * r.a);
  move.add(phases.ramp, sign * r.j);
  move.add(phases.plateau, 0);
  move.add(phases.ramp, -sign * r.j);
}

Profile rest_to_rest(double from, double to, double velocity, const Ramp& accelerate,
                     const Ramp& decelerate) {
  const double h = std::abs(to - from);
  const double sign = to > from ? 1 : -1;
  const double peak = peak_velocity(accelerate, decelerate, h);
  const double v = std::min(peak, velocity);
  Phases up = phases(accelerate, v);
  Phases down = phases(decelerate, v);
  double cruise = velocity < peak ? h / v - (accelerate.duration(v) + decelerate.duration(v)) / 2 : 0;
  const double total = 2 * up.ramp + up.plateau + cruise + down.plateau + 2 * down.ramp;
  require_finite("duration", total);
  if (!(total > 0)) throw InputError("to", to, "is too close to `from` for a move");

  // Plateaus that only rounding made are dropped. A ramp that vanishes beside the move is refused:
  // in doubles it would have no length.
  const double dust = 1e-15 * total;
  for (double* plateau : {&up.plateau, &cruise, &down.plateau})
    if (*plateau <= dust) *plateau = 0;
  for (const auto& [ramp, jerk] : {std::pair{up.ramp, accelerate.j}, {down.ramp, decelerate.j}})
    if (!std::isinf(jerk) && ramp <= dust)
      throw InputError("jerk", jerk,
                       "is so high that its ramps vanish beside the move, which takes " +
                           number(total) + ": take a trapezoid");

  Profile move({from, 0, 0}, std::isinf(accelerate.j) ? 2 : 3);
  add_ramp(move, accelerate, up, sign);
  move.add(cruise, 0);
  add_ramp(move, decelerate, down, -sign);
  move.finish({to, 0, 0});
  return move;
}

void require_move(double from, double to, double velocity, double acceleration,
                  double deceleration) {
  require_finite("from", from);
  require_finite("to", to);
  if (from == to) throw InputError("to", to, "must differ from `from`: there is no move");
  require_finite("to - from", to - from);
  require_positive("velocity", velocity);
  require_positive("acceleration", acceleration);
  require_not_negative("deceleration", deceleration);
}

double or_else(double value, double fallback) {
  return value == 0 ? fallback : value;
}

}  // namespace

Profile trapezoid(const TrapezoidSpec& spec) {
  require_move(spec.from, spec.to, spec.velocity, spec.acceleration, spec.deceleration);
  constexpr double step = std::numeric_limits<double>::infinity();
  return rest_to_rest(spec.from, spec.to, spec.velocity, {spec.acceleration, step},
                      {or_else(spec.deceleration, spec.acceleration), step});
}

Profile s_curve(const SCurveSpec& spec) {
  require_move(spec.from, spec.to, spec.velocity, spec.acceleration, spec.deceleration);
  require_positive("jerk", spec.jerk);
  require_not_negative("deceleration_jerk", spec.deceleration_jerk);
  return rest_to_rest(
      spec.from, spec.to, spec.velocity, {spec.acceleration, spec.jerk},
      {or_else(spec.deceleration, spec.acceleration), or_else(spec.deceleration_jerk, spec.jerk)});
}

}  // namespace jounce
