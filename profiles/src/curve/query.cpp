// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/query.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "profiles/src/solver/span.hpp"

// Ramps and motions between velocities: solver/span.hpp, (1) to (5).
//
// The entry velocity of a single ramp over D to v, by (1) and (2) of e = entry - v:
//
//   (6)  A reached, z = e/A:         A z^2 + (2v + A tau) z = 2 (D - v tau)
//   (7)  otherwise, x = sqrt(e/J):   J x^3 + 2v x = D
//
// (7) is convex. Each of its two terms alone bounds its root, by at most 47 % too high.
//
// The fastest stop from (v, a) brings the acceleration to -+p, holds it there if p = A, and returns
// it to 0. v + a |a|/(2J) is the velocity at which the acceleration reaches 0 if it returns to 0 at
// once. If this velocity is > 0 (otherwise everything is mirrored), and while p <= A,
//
//   (8)  p = sqrt(J v + a^2/2)       from  (a^2 - p^2)/(2J) - p^2/(2J) = -v

namespace jounce {
namespace {

bool valid(const Ramp& ramp) {
  return profiles_detail::is_magnitude(ramp.acceleration) && profiles_detail::is_limit(ramp.jerk);
}

/// A state that advances with constant jerk.
struct Walk {
  double velocity, acceleration;
  Extent done = {};

  void go(double t, double jerk) {
    done.duration += t;
    done.distance += t * (velocity + t * (acceleration / 2 + t * jerk / 6));
    velocity += t * (acceleration + t * jerk / 2);
    acceleration += t * jerk;
  }
};

Extent jerk_limited_stop(double v, double a, double limit, double jerk) {
  const double p = std::min(std::sqrt(std::max(jerk * v + a * a / 2, 0.0)), limit);  // (8)
  Walk walk{v, a};
  walk.go(std::abs(a + p) / jerk, a > -p ? -jerk : jerk);
  walk.acceleration = -p;
  const double let_go = p * p / (2 * jerk);
  if (p == limit) walk.go(std::max(walk.velocity - let_go, 0.0) / p, 0);
  walk.velocity = let_go;  // exact, without the rounding of the previous phases
  walk.go(p / jerk, jerk);
  return walk.done;
}

using profiles_detail::rounded_digit;

/// The fastest motion. If the distance is too short for the direct ramp only by rounding of a
/// velocity that entry_velocity() has returned, it is this ramp.
std::optional<profiles_detail::Way<double>> way(double distance, const SpanEnds& ends,
                                                const Ramp& ramp) {
  const bool possible = valid(ramp) && profiles_detail::is_magnitude(distance) && ends.entry >= 0 &&
                        ends.exit >= 0 && ends.entry <= ends.velocity &&
                        ends.exit <= ends.velocity && profiles_detail::is_limit(ends.velocity) &&
                        profiles_detail::is_moderate(std::max(ends.entry, ends.exit));
  if (!possible) return std::nullopt;
  const profiles_detail::Rates<double> rates(ramp.acceleration, ramp.jerk);
  const profiles_detail::Span<double> span(distance, ends.entry, ends.exit, rates);
  if (!span.mirrored) return profiles_detail::fastest(span, ends.velocity);
  const double faster = std::max(ends.entry, ends.exit);
  const double spared = rates.ramp(std::max(span.d - rounded_digit * faster, 0.0));
  const double shortest = 0.5 * (ends.entry + ends.exit) * spared;
  if (distance < shortest * (1 - rounded_digit)) return std::nullopt;
  return profiles_detail::Way<double>{rates.ramp(span.d), faster};
}

}  // namespace

std::optional<Extent> ramp_between(double v0, double v1, const Ramp& ramp) noexcept {
  if (!valid(ramp) || !profiles_detail::is_moderate(v0) || !profiles_detail::is_moderate(v1))
    return std::nullopt;
  const double duration =
      profiles_detail::Rates<double>(ramp.acceleration, ramp.jerk).ramp(std::abs(v1 - v0));
  return Extent{duration, 0.5 * (v0 + v1) * duration};
}

std::optional<Extent> stopping(const Moving& now, const Ramp& ramp) noexcept {
  const auto [v, a] = now;
  if (!valid(ramp) || !profiles_detail::is_moderate(v) || !profiles_detail::is_moderate(a))
    return std::nullopt;
  if (std::isinf(ramp.jerk)) {
    const double duration = std::abs(v) / ramp.acceleration;
    return Extent{duration, v * duration / 2};
  }
  const double sign = v + a * std::abs(a) / (2 * ramp.jerk) < 0 ? -1 : 1;
  Extent stop = jerk_limited_stop(sign * v, sign * a, ramp.acceleration, ramp.jerk);
  stop.distance *= sign;
  return stop;
}

std::optional<double> entry_velocity(double distance, double exit_velocity,
                                     const Ramp& ramp) noexcept {
  const bool possible = valid(ramp) && distance >= 0 && profiles_detail::is_way(distance) &&
                        exit_velocity >= 0 && profiles_detail::is_moderate(exit_velocity);
  if (!possible) return std::nullopt;
  if (distance == 0) return exit_velocity;
  const profiles_detail::Rates<double> rates(ramp.acceleration, ramp.jerk);
  const double b = 2 * exit_velocity + rates.threshold;
  const double r = 2 * (distance - exit_velocity * rates.tau);
  const double z = 2 * r / (b + profiles_detail::square_root(b * b + 4 * rates.a * r));  // (6)
  if (z >= rates.tau) return exit_velocity + rates.a * z;
  const double cubic = 1.04 * profiles_detail::rough_cube_root(distance * rates.inv_j);
  const double x = profiles_detail::largest_root(
      {{0, rates.j, 0, 2 * exit_velocity, -distance},  // (7)
       2 * exit_velocity * cubic > distance ? distance / (2 * exit_velocity) : cubic});
  return exit_velocity + rates.j * x * x;
}

std::optional<double> peak_velocity(double distance, const SpanEnds& ends,
                                    const Ramp& ramp) noexcept {
  const auto found = way(distance, ends, ramp);
  return found ? std::optional(found->peak) : std::nullopt;
}

std::optional<double> minimum_duration(double distance, const SpanEnds& ends,
                                       const Ramp& ramp) noexcept {
  const auto found = way(distance, ends, ramp);
  return found ? std::optional(found->duration) : std::nullopt;
}

}  // namespace jounce
