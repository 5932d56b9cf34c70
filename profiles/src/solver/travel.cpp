// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/solver/travel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace jounce::profiles_detail {
namespace {

/// c0 + c1 u + c2 u^2/2 + c3 u^3/6 over a phase of the duration `t`.
struct Stretch {
  std::array<double, 4> c;
  double length;

  [[nodiscard]] double at(double u) const {
    return c[0] + u * (c[1] + u * (c[2] / 2 + u * (c[3] / 6)));
  }
};

/// The zeros of the slope c1 + c2 u + c3 u^2/2 inside the stretch, ascending; unused entries are 0.
std::array<double, 2> turns(const Stretch& s) {
  const double w = s.c[2] * s.c[2] - 2 * s.c[1] * s.c[3];
  std::array<double, 2> u{};
  if (!(w >= 0)) return u;
  const double q = -(s.c[2] + std::copysign(std::sqrt(w), s.c[2]));
  if (s.c[3] != 0) u[0] = q / s.c[3];
  if (q != 0) u[1] = 2 * s.c[1] / q;
  for (double& x : u)
    if (!(x > 0 && x < s.length)) x = 0;
  if (u[0] > u[1]) std::swap(u[0], u[1]);
  return u;
}

void go_to(double x, Travel& travel) {
  travel.path += std::abs(x - travel.distance);
  travel.distance = x;
  travel.lowest = std::min(travel.lowest, x);
  travel.highest = std::max(travel.highest, x);
}

void add(const Stretch& s, Travel& travel) {
  for (const double u : turns(s))
    if (u > 0) go_to(s.at(u), travel);
  go_to(s.at(s.length), travel);
}

constexpr double rounding_share = 1e-12;

bool lies_within(double lowest, double highest, double min, double max, double rounding) {
  const double slack = rounding_share * std::max(std::abs(lowest), std::abs(highest)) + rounding;
  return lowest >= min - slack && highest <= max + slack;
}

bool keeps_accelerations(const Profile& profile, const Bounds& b) {
  double a = profile.order() == 3 ? profile.start().acceleration : 0;
  double lowest = a;
  double highest = a;
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const auto [length, value] = profile.phase(i);
    if (profile.order() == 3 && !lies_within(value, value, b.jerk_min, b.jerk_max, 0)) return false;
    if (profile.order() == 3) a += value * length;
    if (profile.order() == 2) a = value;
    lowest = std::min(lowest, a);
    highest = std::max(highest, a);
  }
  return lies_within(lowest, highest, b.acceleration_min, b.acceleration_max, 0);
}

/// The travel of the derivative `which`: 0 (position) or 1 (velocity).
Travel along(const Profile& profile, std::size_t which, double velocity) {
  Travel travel;
  const auto order = static_cast<std::size_t>(profile.order());
  std::array<double, 4> d{0, profile.start().velocity - velocity, profile.start().acceleration, 0};
  if (which == 1) d = {0, profile.start().acceleration, 0, 0};
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const auto [length, value] = profile.phase(i);
    if (order == which) {  // the velocity itself steps
      go_to(value, travel);
      continue;
    }
    d[order - which] = order == 1 ? value - velocity : value;
    for (std::size_t k = order - which + 1; k < 4; ++k) d[k] = 0;
    const Stretch s{d, length};
    add(s, travel);
    d = {travel.distance, d[1] + length * (d[2] + length * (d[3] / 2)), d[2] + length * d[3], 0};
  }
  return travel;
}

}  // namespace

Travel travelled(const Profile& profile, double velocity) noexcept {
  return along(profile, 0, velocity);
}

Travel travelled_in_velocity(const Profile& profile) noexcept {
  return along(profile, 1, 0);
}

bool keeps(const Profile& profile, const Bounds& b) noexcept {
  const double v = profile.order() > 1 ? profile.start().velocity : 0;
  const double x = profile.start().position;
  const Travel speed = travelled_in_velocity(profile);
  const Travel way = travelled(profile);
  const double tolerance = 0x1p-46 * (std::abs(x) + std::abs(profile.end().position));
  return keeps_accelerations(profile, b) &&
         lies_within(v + speed.lowest, v + speed.highest, b.velocity_min, b.velocity_max, 0) &&
         lies_within(x + way.lowest, x + way.highest, b.position_min, b.position_max, tolerance);
}

bool turns_round(const Travel& travel, double share, double tolerance) noexcept {
  return travel.path - std::abs(travel.distance) > share * travel.path + tolerance;
}

}  // namespace jounce::profiles_detail
