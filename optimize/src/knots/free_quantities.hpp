// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "jounce/optimize/problem.hpp"

/// The free quantities of the knots of a cam: shared by the validation, the bounds and the solver.
namespace jounce::optimizer {

enum class Quantity : std::size_t { master, slave, geo_velocity, geo_acceleration };

constexpr std::array quantities{Quantity::master, Quantity::slave, Quantity::geo_velocity,
                                Quantity::geo_acceleration};
constexpr std::array quantity_names{"master", "slave", "geo_velocity", "geo_acceleration"};

constexpr std::size_t index(Quantity q) {
  return static_cast<std::size_t>(q);
}

/// A knot by quantity.
using Knot = std::array<double, 4>;
using Freedom = std::array<bool, 4>;

inline bool any(const Freedom& f) {
  return f[0] || f[1] || f[2] || f[3];
}

inline const std::optional<Bound>& bound_of(const FreeKnot& free, Quantity quantity) {
  switch (quantity) {
    case Quantity::master:
      return free.master;
    case Quantity::slave:
      return free.slave;
    case Quantity::geo_velocity:
      return free.geo_velocity;
    case Quantity::geo_acceleration:
      break;
  }
  return free.geo_acceleration;
}

/// "start.free", "segment[3].free": segments count from 1, as in the spec.
inline std::string free_key(std::size_t knot) {
  return knot == 0 ? "start.free" : "segment[" + std::to_string(knot) + "].free";
}
inline std::string free_key(std::size_t knot, Quantity quantity) {
  return free_key(knot) + "." + quantity_names[index(quantity)];
}

inline std::vector<Knot> knots_of(const CamSpec& cam) {
  std::vector<Knot> knots;
  for (const CamKnot& k : resolved_knots(cam))
    knots.push_back({k.master, k.slave, *k.geo_velocity, *k.geo_acceleration});
  return knots;
}

/// The free quantities of each knot. The two knots at the seam of a periodic cam have the same. A bound without
/// width frees nothing.
inline std::vector<Freedom> freedom(const CamProblem& problem) {
  std::vector<Freedom> all(problem.cam.segments.size() + 1);
  for (const FreeKnot& free : problem.free)
    for (const Quantity q : quantities) {
      const auto& bound = bound_of(free, q);
      all[free.knot][index(q)] = bound && bound->lower < bound->upper;
    }
  if (problem.cam.periodic)
    for (std::size_t i = 0; i < 4; ++i)
      all.front()[i] = all.back()[i] = all.front()[i] || all.back()[i];
  return all;
}

}  // namespace jounce::optimizer
