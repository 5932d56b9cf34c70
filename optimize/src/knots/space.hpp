// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "optimize/src/knots/free_quantities.hpp"
#include "optimize/src/knots/pieces.hpp"

namespace jounce::optimize_detail {

/// One free quantity. The variable of the solver is z = (value - given) / scale.
struct Variable {
  std::size_t knot = 0;                  ///< index of the knot
  Quantity quantity = Quantity::master;  ///< the quantity
  bool seam = false;  ///< true: the other end of a periodic cam changes by the same amount
  double given = 0;   ///< value in the given cam
  double lower = 0;   ///< lower bound
  double upper = 0;   ///< upper bound
  double scale = 1;   ///< unit of the variable
};

/// A cam as a function of its free quantities.
struct Space {
  explicit Space(const CamProblem& problem);

  CamSpec given;                     ///< the given cam
  std::vector<Knot> knots;           ///< knots of `given`
  std::vector<Variable> variables;   ///< the free quantities
  std::vector<Piece> pieces;         ///< pieces of the cam
  std::vector<Gram> grams;           ///< G of each segment
  std::vector<bool> moves;           ///< for each segment: true if a free quantity changes it
  std::vector<double> least_length;  ///< for each segment: its least length
  double stroke = 1;  ///< range of the given slave positions, or a substitute if that is 0

  /// Length of the cam.
  [[nodiscard]] double length() const { return knots.back()[0] - knots.front()[0]; }
  /// True if every constraint is linear and every objective convex: no master position is free.
  [[nodiscard]] bool convex() const;
};

using Point = std::vector<double>;  ///< values of z, one for each variable

/// Returns z within the bounds, with masters that ascend.
Point clamped(const Space& space, Point z);

/// Returns the knots, and the spec, at z.
std::vector<Knot> knots_at(const Space& space, std::span<const double> z);
CamSpec spec_at(const Space& space, std::span<const double> z);

/// Applies the chain rule for (3), (4), (6): adds the gradient with respect to the knots of
/// `segment` to the gradient with respect to z.
void add_gradient(const Space& space, std::size_t segment, const KnotGradient& by_knots,
                  std::span<double> by_z);

/// Returns the start with this number; 0: the given cam. Free masters are drawn at random within
/// their bounds, and the other free quantities have the values of the given cam at these masters.
/// The result is the same on every platform (splitmix64 of seed and number).
Point start_point(const Space& space, std::uint64_t seed, std::size_t number);

}  // namespace jounce::optimize_detail
