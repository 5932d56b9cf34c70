// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "optimize/src/knots/free_quantities.hpp"
#include "optimize/src/knots/pieces.hpp"

namespace jounce::optimizer {

/// One free quantity. The solver's variable is z = (value - given) / scale.
struct Variable {
  std::size_t knot = 0;
  Quantity quantity = Quantity::master;
  bool seam = false;  ///< the other end of a periodic cam changes by the same amount
  double given = 0;
  double lower = 0;
  double upper = 0;
  double scale = 1;
};

/// A cam as a function of its free quantities.
struct Space {
  explicit Space(const CamProblem& problem);

  CamSpec given;
  std::vector<Knot> knots;  ///< knots of `given`
  std::vector<Variable> variables;
  std::vector<Piece> pieces;
  std::vector<Gram> grams;
  std::vector<bool> moves;           ///< by segment: true if a free quantity changes it
  std::vector<double> least_length;  ///< by segment: the least length
  double stroke = 1;  ///< range of the given slave positions, or a substitute where that is 0

  [[nodiscard]] double length() const { return knots.back()[0] - knots.front()[0]; }
  /// True if every constraint is linear and every objective convex: no master is free.
  [[nodiscard]] bool convex() const;
};

using Point = std::vector<double>;  ///< z, one for each variable

/// Moves z into the bounds, with the masters in order.
Point clamped(const Space& space, Point z);

std::vector<Knot> knots_at(const Space& space, std::span<const double> z);
CamSpec spec_at(const Space& space, std::span<const double> z);

/// The chain rule for (3), (4), (6): adds the gradient by the knots of `segment` to that by z.
void add_gradient(const Space& space, std::size_t segment, const KnotGradient& by_knots,
                  std::span<double> by_z);

/// A start: free masters are drawn within their bounds, and the other free quantities are read from the given
/// cam there. Number 0 is the given cam. Portable: splitmix64 of seed and number.
Point start_point(const Space& space, std::uint64_t seed, std::size_t number);

}  // namespace jounce::optimizer
