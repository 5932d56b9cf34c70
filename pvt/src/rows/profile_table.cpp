// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/profile_table.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/detail/local_velocities.hpp"

// A stage of length T from (p, v, a), at u = s T:
//
//   velocity linear to v1:      p + v T s + (v1 - v) T s^2 / 2                        (1)
//   acceleration linear to a1:  p + v T s + a T^2 s^2 / 2 + (a1 - a) T^2 s^3 / 6      (2)
//                               and ends with v + (a + a1) T / 2                      (3)
//
// The velocities of the cubic rule at points are those of the monotone filling: at most 3 times the
// smaller adjacent slope, so neither stage overshoots.

namespace jounce::pmc600 {
namespace {

/// The controller's error numbers for a wrong size, and for a stage without duration.
struct Errors {
  int size;
  int time;
};
constexpr Errors of_position{325, 326};
constexpr Errors of_velocity{350, 351};
constexpr Errors of_acceleration{375, 376};

std::string named(const std::string& rule, int error) {
  return rule + " (PMC600 error " + std::to_string(error) + ")";
}

int pairs_of(const ProfileTable& table, int error) {
  const auto given = table.points.size();
  if (given < 1 || given > most_points)
    throw InputError("point", std::to_string(given) + " points", named("must be 1 to 100", error));
  const int pairs = table.number_of_pairs.value_or(static_cast<int>(given));
  if (pairs < 1 || pairs > static_cast<int>(given))
    throw InputError("number_of_pairs", std::to_string(pairs),
                     named("must be 1 to " + std::to_string(given) + ", the points given", error));
  const int size = table.array_size.value_or(pairs);
  if (size < pairs || size > most_points)
    throw InputError(
        "array_size", std::to_string(size),
        named("must be " + std::to_string(pairs) + ", the points played, to 100", error));
  return pairs;
}

void require_valid(const ProfileTable& table, int pairs, int error) {
  for (const auto& [key, value] : {std::pair{"scale", table.scale},
                                   {"offset", table.offset},
                                   {"from", table.from},
                                   {"from_velocity", table.from_velocity},
                                   {"from_acceleration", table.from_acceleration}})
    require_finite(key, value);
  for (int i = 0; i < pairs; ++i) {
    const auto& [delta_time, value] = table.points[static_cast<std::size_t>(i)];
    const std::string key = "point[" + std::to_string(i + 1) + "].";
    if (!(delta_time > 0) || !std::isfinite(delta_time))
      throw InputError(key + "delta_time", delta_time, named("must be greater than 0", error));
    require_finite((key + "value").c_str(), value);
  }
}

/// The stages: their durations, and the values at their ends. `first` is the axis' own value.
struct Stages {
  std::vector<double> length;
  std::vector<double> value;  // one more than stages
};

Stages stages_of(const ProfileTable& table, double first, const Errors& errors) {
  const int pairs = pairs_of(table, errors.size);
  require_valid(table, pairs, errors.time);
  Stages stages{{}, {first}};
  double sum = 0;
  for (int i = 0; i < pairs; ++i) {
    const auto& [delta_time, value] = table.points[static_cast<std::size_t>(i)];
    sum = table.is_absolute ? value : sum + value;
    stages.length.push_back(delta_time);
    stages.value.push_back((table.is_absolute ? 0 : first) + table.scale * sum + table.offset);
  }
  return stages;
}

/// The velocity at each point; the last one is 0.
std::vector<double> velocities(const Stages& stages, double first) {
  const auto& [length, value] = stages;
  std::vector<double> v(value.size());
  v.front() = first;
  for (std::size_t i = 1; i < length.size(); ++i) {
    const double h = length[i - 1];
    const double k = length[i];
    v[i] = pvt_detail::between_chords(h, (value[i] - value[i - 1]) / h, k,
                                      (value[i + 1] - value[i]) / k);
  }
  return v;
}

Segment polynomial(double length, int degree, const std::array<double, 4>& c) {
  Segment f;
  f.length = length;
  f.degree = degree;
  for (std::size_t k = 0; k < c.size(); ++k) f.c[k] = c[k];
  while (f.degree > 0 && f.c[static_cast<std::size_t>(f.degree)] == 0) --f.degree;
  return f;
}

}  // namespace

Trajectory position_profile(const ProfileTable& table, PositionRule rule) {
  const Stages stages = stages_of(table, table.from, of_position);
  const std::vector<double> v = velocities(stages, table.from_velocity);
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < stages.length.size(); ++i) {
    const double p = stages.value[i];
    const double q = stages.value[i + 1];
    segments.push_back(rule == PositionRule::linear
                           ? line(stages.length[i], p, q)
                           : cubic(stages.length[i], p, v[i], q, v[i + 1]));
  }
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

Trajectory velocity_profile(const ProfileTable& table) {
  const auto [length, v] = stages_of(table, table.from_velocity, of_velocity);
  std::vector<Segment> segments;
  double p = table.from;
  for (std::size_t i = 0; i < length.size(); ++i) {  // (1)
    const double t = length[i];
    segments.push_back(polynomial(t, 2, {p, v[i] * t, (v[i + 1] - v[i]) * t / 2}));
    p += (v[i] + v[i + 1]) * t / 2;
  }
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

Trajectory acceleration_profile(const ProfileTable& table) {
  const auto [length, a] = stages_of(table, table.from_acceleration, of_acceleration);
  std::vector<Segment> segments;
  double p = table.from;
  double v = table.from_velocity;
  for (std::size_t i = 0; i < length.size(); ++i) {  // (2), (3)
    const double t = length[i];
    segments.push_back(
        polynomial(t, 3, {p, v * t, a[i] * t * t / 2, (a[i + 1] - a[i]) * t * t / 6}));
    p = value(segments.back(), 1);
    v += (a[i] + a[i + 1]) * t / 2;
  }
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

}  // namespace jounce::pmc600
