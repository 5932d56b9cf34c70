// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "jounce/optimize/problem.hpp"

/// The free quantities of the knots of a cam, for the validation, the bounds and the solver.
namespace jounce::optimize_detail {

enum class Quantity : std::size_t { master, slave, geo_velocity, geo_acceleration };

constexpr std::array quantities{Quantity::master, Quantity::slave, Quantity::geo_velocity,
                                Quantity::geo_acceleration};
constexpr std::array quantity_names{"master", "slave", "geo_velocity", "geo_acceleration"};

constexpr std::size_t index(Quantity q) {
  return static_cast<std::size_t>(q);
}

/// The values of a knot, indexed by Quantity.
using Knot = std::array<double, 4>;
using Freedom = std::array<bool, 4>;  ///< true if a quantity is free, indexed by Quantity

inline bool any(const Freedom& f) {
  return f[0] || f[1] || f[2] || f[3];
}

/// Returns the bounds of a quantity; nullopt if it is not free.
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

/// Returns "start.free", "segment[3].free": segments count from 1, as in the spec.
inline std::string free_key(std::size_t knot) {
  return knot == 0 ? "start.free" : "segment[" + std::to_string(knot) + "].free";
}
inline std::string free_key(std::size_t knot, Quantity quantity) {
  return free_key(knot) + "." + quantity_names[index(quantity)];
}

/// Returns the knots of a cam, with all derivatives.
inline std::vector<Knot> knots_of(const CamSpec& cam) {
  std::vector<Knot> knots;
  for (const CamKnot& k : resolved_knots(cam))
    knots.push_back({k.master, k.slave, *k.geo_velocity, *k.geo_acceleration});
  return knots;
}

/// Returns the free quantities of each knot. The first and the last knot of a periodic cam are one
/// knot and have the same free quantities. A bound whose ends are equal frees nothing.
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

}  // namespace jounce::optimize_detail
