// SPDX-License-Identifier: Apache-2.0
// A program and another one with the same motion: the durations are equal.
#include <algorithm>
#include <cmath>

#include "jounce/profiles/error.hpp"

#include "path/proof/workloads.hpp"

namespace jounce::path_proof {
namespace {

constexpr double same = 1e-9;
/// Rounding of the points bends two lines in one direction; they are planned with 1e-7 less (decision 0090, 15).
constexpr double nearly_straight = 1e-7;

double duration_of(const Case& c, int parts = 1) {
  return plan(program_of(c, parts), c.limits).duration();
}

/// True if two lines in a row have one direction.
bool goes_straight(const Case& c) {
  for (std::size_t i = 1; i < c.legs.size(); ++i) {
    const Point& at = c.from(i);
    const double before = distance(c.from(i - 1), at);
    const double behind = distance(at, c.legs[i].to);
    double square = 0;
    for (std::size_t k = 0; k < c.axes; ++k) {
      const double change =
          (c.legs[i].to[k] - at[k]) / behind - (at[k] - c.from(i - 1)[k]) / before;
      square += change * change;
    }
    if (square < 1e-18) return true;
  }
  return false;
}

Outcome compared(const Case& c, double T, double twin, const std::string& how) {
  const double tolerance = goes_straight(c) ? nearly_straight : same;
  if (std::abs(twin - T) <= tolerance * T) return {};
  return outcome(c, "lasts " + text(T) + " s, " + how + ": " + text(twin));
}

Case mirrored(const Case& c) {
  return mapped(c, [](Point p) {
    for (double& x : p) x = -x;
    return p;
  });
}

Case in_reversed_axes(const Case& c) {
  Case twin = mapped(c, [&](Point p) {
    std::reverse(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(c.axes));
    return p;
  });
  std::ranges::reverse(twin.limits.axes);
  for (Leg& leg : twin.legs) std::ranges::reverse(leg.settings.axes);
  return twin;
}

/// Each junction passes at the velocity of its neighbors: a point within a line has no junction of its own.
Outcome cut(Random& r, Case c) {
  for (Leg& leg : c.legs) leg.settings.junction = Junction::look_ahead;
  const int parts = 2 + r.below(4);
  return compared(c, duration_of(c), duration_of(c, parts),
                  "cut in " + std::to_string(parts) + " parts");
}

/// Only the path has limits.
Outcome rotated(Random& r, Case c) {
  if (c.path_axes < 2) return {};
  c.limits.axes.assign(c.axes, {});
  for (Leg& leg : c.legs) leg.settings.axes.clear();
  c.limits.path.acceleration = std::min(c.limits.path.acceleration, 2000.0);
  c.limits.path.jerk = std::min(c.limits.path.jerk, 1e5);
  c.limits.path.total_acceleration = std::min(c.limits.path.total_acceleration, 3000.0);
  const double angle = r.uniform(0, 1000);
  const Case turned = mapped(c, [angle](const Point& p) {
    Point q = p;
    q[0] = std::cos(angle) * p[0] - std::sin(angle) * p[1];
    q[1] = std::sin(angle) * p[0] + std::cos(angle) * p[1];
    return q;
  });
  return compared(c, duration_of(c), duration_of(turned), "rotated by " + text(angle) + " rad");
}

Outcome twins(Random& r, const Case& c) try {
  const int kind = r.below(6);
  if (kind == 0) return compared(c, duration_of(c), duration_of(mirrored(c)), "mirrored");
  if (kind == 1) return cut(r, c);
  if (kind == 2) {
    const double length = r.below(2) > 0 ? 1e6 : 1e-6;
    return compared(c, duration_of(c), duration_of(scaled(c, length, 1)), "in units of 1e-+6");
  }
  if (kind == 3) {
    const double time = r.below(2) > 0 ? 1e3 : 1e-3;
    return compared(c, duration_of(c), duration_of(scaled(c, 1, time)) / time,
                    "in units of 1e-+3 s");
  }
  if (kind == 4)
    return compared(c, duration_of(c), duration_of(in_reversed_axes(c)), "in reversed axes");
  return rotated(r, c);
} catch (const InputError& error) {
  return outcome(c, std::string("rejected: ") + error.what());
}

}  // namespace

Outcome twins_of_lines(Random& r, Worst&) {
  return twins(r, lines(r));
}

Outcome twins_of_arcs(Random& r, Worst&) {
  return twins(r, arcs(r));
}

Outcome twins_of_averages(Random& r, Worst&) {
  return twins(r, averages(r));
}

/// Without arcs and averages: with limits that change, rounding decides there about zones and ramps.
Outcome twins_of_limited(Random& r, Worst&) {
  return twins(r, limited(r, true));
}

}  // namespace jounce::path_proof
