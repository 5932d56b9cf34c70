// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/fill/demands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

// The cubic piece of length h and chord d with end velocities v0, v1 has
//
//   (1)  a(0) = (6 d - 4 v0 - 2 v1) / h,   a(1) = (-6 d + 2 v0 + 4 v1) / h,   a linear between
//   (2)  jerk = 6 (v0 + v1 - 2 d) / h^2
//
// So limits of acceleration and jerk are half planes of (v0, v1), and so is convexity, a >= 0 at
// both ends. |v| <= V at every place is a convex set with a curved edge. With w = V + v, the piece
// of velocity w has the chord D = V + d and must not run backwards: this is the region (1) of
// Fritsch and Carlson in local_velocities.cpp, times D. The same holds for V - v and V - d. The
// polygon below is inscribed: its corners are on the edge of the region.

namespace jounce::pvt_detail {
namespace {

constexpr double demand_resolution = 1e-9;  ///< relative, of a bisection
constexpr double demand_slack = 1e-13;

struct Corner {
  double alpha, beta;
};

/// Points on alpha^2 + alpha beta + beta^2 - 6 alpha - 6 beta + 9 = 0, from (3, 0) to (0, 3).
std::vector<Corner> corners_of_the_region() {
  const auto branch = [](double alpha, double sign) {
    return Corner{alpha, (6 - alpha + sign * std::sqrt(3 * alpha * (4 - alpha))) / 2};
  };
  return {{3, 0}, branch(3.75, -1),
          {4, 1}, branch(3.75, 1),
          {3, 3}, {branch(3.75, 1).beta, 3.75},
          {1, 4}, {branch(3.75, -1).beta, 3.75},
          {0, 3}};
}

/// The region as half planes: alpha times the first number plus beta times the second is at most
/// the third.
const std::vector<HalfPlane>& region() {
  static const std::vector<HalfPlane> planes = [] {
    const std::vector<Corner> corners = corners_of_the_region();
    std::vector<HalfPlane> all;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const double a = corners[i + 1].beta - corners[i].beta;
      const double b = corners[i].alpha - corners[i + 1].alpha;
      all.push_back({a, b, a * corners[i].alpha + b * corners[i].beta});
    }
    return all;
  }();
  return planes;
}

/// Adds: sign v >= -limit everywhere on the piece.
void add_velocity(Demand& demand, double limit, double sign, double chord) {
  const double d = limit + sign * chord;
  const double slack = demand_slack * limit;
  demand.add({-sign, 0, limit + slack});
  demand.add({0, -sign, limit + slack});
  for (const HalfPlane& plane : region())
    demand.add({sign * plane.a, sign * plane.b,
                plane.c * d - (plane.a + plane.b) * limit +
                    slack * (std::abs(plane.a) + std::abs(plane.b))});
}

/// Adds: |a v0 + b v1 - c| <= limit.
void add_band(Demand& demand, HalfPlane center, double limit) {
  const double slack = demand_slack * (limit + std::abs(center.c));
  demand.add({center.a, center.b, center.c + limit + slack});
  demand.add({-center.a, -center.b, -center.c + limit + slack});
}

int sign_of(double difference, double slack) {
  return difference > slack ? 1 : difference < -slack ? -1 : 0;
}

Turn turn_between(int first, int second) {
  if (first == 0 && second == 0) return Turn::neither;
  if (first >= 0 && second >= 0) return Turn::left;
  if (first <= 0 && second <= 0) return Turn::right;
  return Turn::any;
}

}  // namespace

Demand within_limits(const Limits& limits, double length, double chord) {
  Demand demand;
  if (limits.acceleration) {
    add_band(demand, {4, 2, 6 * chord}, *limits.acceleration * length);
    add_band(demand, {2, 4, 6 * chord}, *limits.acceleration * length);
  }
  if (limits.jerk) add_band(demand, {6, 6, 12 * chord}, *limits.jerk * length * length);
  if (limits.velocity) {
    add_velocity(demand, *limits.velocity, 1, chord);
    add_velocity(demand, *limits.velocity, -1, chord);
  }
  return demand;
}

double needed_stretch(const Limits& limits, double length, double chord, Gap from, Gap to) {
  const auto enough = [&](double factor) {
    return reached(within_limits(limits, length * factor, chord / factor), from, to).has_value();
  };
  double more = 1;
  while (!enough(more))
    if ((more *= 1.25) > 1e12) return std::numeric_limits<double>::infinity();
  double less = more / 1.25;
  while (more - less > demand_resolution * more)
    (enough((less + more) / 2) ? more : less) = (less + more) / 2;
  return more;
}

Demand turning(Turn turn, double chord, double slack) {
  Demand demand;
  if (turn == Turn::left || turn == Turn::neither) {
    demand.add({2, 1, 3 * (chord + slack)});
    demand.add({-1, -2, -3 * (chord - slack)});
  }
  if (turn == Turn::right || turn == Turn::neither) {
    demand.add({-2, -1, -3 * (chord - slack)});
    demand.add({1, 2, 3 * (chord + slack)});
  }
  return demand;
}

std::vector<Turn> turns_of(const Chords& chords, const std::vector<double>& slack, bool periodic) {
  const auto& d = chords.chord;
  const std::size_t pieces = d.size();
  const auto at = [&](std::size_t left, std::size_t right) {
    return sign_of(d[right] - d[left], slack[left] + slack[right]);
  };
  std::vector<int> knots(pieces + 1, 0);
  for (std::size_t i = 1; i < pieces; ++i) knots[i] = at(i - 1, i);
  if (periodic) knots.front() = knots.back() = at(pieces - 1, 0);
  std::vector<Turn> turns(pieces);
  for (std::size_t i = 0; i < pieces; ++i) turns[i] = turn_between(knots[i], knots[i + 1]);
  return turns;
}

std::vector<Gap> monotone_gaps(const Chords& chords, bool periodic) {
  const auto& d = chords.chord;
  const auto between = [](double d0, double d1) -> Gap {
    if (d0 > 0 && d1 > 0) return {0, 3 * std::min(d0, d1)};
    if (d0 < 0 && d1 < 0) return {3 * std::max(d0, d1), 0};
    return {0, 0};
  };
  std::vector<Gap> gaps(d.size() + 1);
  for (std::size_t i = 1; i < d.size(); ++i) gaps[i] = between(d[i - 1], d[i]);
  gaps.front() = periodic ? between(d.back(), d.front()) : between(d.front(), d.front());
  gaps.back() = periodic ? gaps.front() : between(d.back(), d.back());
  return gaps;
}

}  // namespace jounce::pvt_detail
