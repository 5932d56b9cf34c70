// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/brake.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/numeric.hpp"

#include "profiles/src/solver/velocity_change.hpp"

namespace jounce::profiles_detail {
namespace {

/// A violation by less than this share of the limit counts as rounding.
constexpr double bound_rounding = 1e-13;

MotionState after(Profile& profile, const MotionState& s, double t, double jerk) {
  profile.add(t, jerk);
  return {s.position + t * (s.velocity + t * (s.acceleration / 2 + t * (jerk / 6))),
          s.velocity + t * (s.acceleration + t * (jerk / 2)), s.acceleration + t * jerk};
}

/// The velocity limit that the natural velocity n exceeds: 1 the upper, -1 the lower, 0 none.
int violated(const MotionState& s, const Bounds& b, double n) {
  const double terms = rounding * (std::abs(s.velocity) + std::abs(n));
  if (n > b.velocity_max + (bound_rounding * b.velocity_max + terms)) return 1;
  return n < b.velocity_min + (bound_rounding * b.velocity_min - terms) ? -1 : 0;
}

/// Equation (8): the velocity returns to the limit and touches it. The natural velocity exceeds the
/// limit by `excess`. The phase ends where the acceleration begins to return to zero. `side` is 1
/// for the upper limit.
MotionState level_return(const MotionState& from, const Bounds& b, int side, double excess,
                         Profile& profile) {
  const double limit = side > 0 ? b.velocity_max : b.velocity_min;
  const double inwards = side > 0 ? b.jerk_min : b.jerk_max;
  const double back = side > 0 ? b.jerk_max : b.jerk_min;
  const double most = side > 0 ? -b.acceleration_min : b.acceleration_max;
  const double a = side * from.acceleration;
  const double k = 1 / std::abs(inwards) + 1 / std::abs(back);
  const double begun = std::min(a, 0.0);
  const double free = std::sqrt(begun * begun + 2 * excess / k);
  const double z = std::min(free, most);
  // a + z without cancellation, if the acceleration already has the required sign.
  const double change = a < 0 && free < most ? 2 * excess / (k * (z - a)) : z + a;
  const double hold = free > most ? (excess - k * (z - begun) * (z + begun) / 2) / most : 0;
  MotionState s = after(profile, from, change / std::abs(inwards), inwards);
  s.acceleration = -side * z;
  s = after(profile, s, hold, 0);
  return {s.position, limit + z * z / (2 * back), -side * z};
}

}  // namespace

bool is_inside(const MotionState& s, const Bounds& b, double tolerance) noexcept {
  const double v = s.velocity;
  const double a = s.acceleration;
  const double more = 1 + tolerance;
  if (a > b.acceleration_max * more || a < b.acceleration_min * more) return false;
  const double top = b.velocity_max * more;
  const double bottom = b.velocity_min * more;
  if (v > top || v < bottom) return false;
  // The point at which the acceleration has returned to zero, without a division:
  return a > 0 ? a * a <= 2 * -b.jerk_min * (top - v) : a * a <= 2 * b.jerk_max * (v - bottom);
}

double natural_velocity(const MotionState& s, const Bounds& b) noexcept {
  if (s.acceleration == 0) return s.velocity;
  const double jerk = s.acceleration > 0 ? b.jerk_min : b.jerk_max;
  return s.velocity - s.acceleration * s.acceleration / (2 * jerk);
}

MotionState acceleration_inside(const MotionState& from, const Bounds& b,
                                Profile& profile) noexcept {
  MotionState s = from;
  s.acceleration = std::clamp(from.acceleration, b.acceleration_min, b.acceleration_max);
  const double change = s.acceleration - from.acceleration;
  // Also applies to a last digit, which would act through a whole hold or cruise.
  if (change == 0) return s;
  const double jerk = change < 0 ? b.jerk_min : b.jerk_max;
  const double a = s.acceleration;
  s = after(profile, from, change / jerk, jerk);
  s.acceleration = a;
  return s;
}

int runs_out(const MotionState& s, const Bounds& b) noexcept {
  return violated(s, b, natural_velocity(s, b));
}

MotionState begin_inside(const MotionState& from, const Bounds& b, Profile& profile) noexcept {
  const MotionState s = acceleration_inside(from, b, profile);
  const double n = natural_velocity(s, b);
  const int side = violated(s, b, n);
  if (side == 0) return s;
  const double excess = side > 0 ? n - b.velocity_max : b.velocity_min - n;
  return level_return(s, b, side, excess, profile);
}

Braking braking_under_way(const MotionState& from, const MotionState& to,
                          const Bounds& b) noexcept {
  const double distance = to.position - from.position;
  const double way = distance < 0 ? -1 : 1;
  const double v = way * from.velocity;
  const double a = -way * from.acceleration;  // its deceleration
  const double most = way > 0 ? -b.acceleration_min : b.acceleration_max;
  const double rise = way > 0 ? b.jerk_max : -b.jerk_min;
  const double n = v - a * a / (2 * rise);
  const bool rests = to.velocity == 0 && to.acceleration == 0;
  if (!rests || distance == 0 || !(a > most * (1 + bound_rounding)) || !(n > 0)) return {};
  // Equation (10), for the part besides the ramp to zero acceleration.
  const double ramp = a / rise * (v - a * a / (3 * rise));
  const double e = rise * (way * distance - ramp);
  const double r = std::sqrt(e * e + n * n * n * rise);
  const double x = e > 0 ? n * n * rise / (e + r) : (r - e) / n;
  if (x <= most) return {};
  // Larger by a few digits, so that by rounding the axis stops before the target instead of after
  // it.
  if (x <= a) return {.limit = -way * std::min(x * (1 + 0x1p-48), a)};
  return {.hold = n / a};
}

Bounds extended(Bounds b, double acceleration) noexcept {
  (acceleration < 0 ? b.acceleration_min : b.acceleration_max) = acceleration;
  return b;
}

}  // namespace jounce::profiles_detail
