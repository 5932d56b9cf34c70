// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "optimize/src/knots/space.hpp"

/// A smooth problem with finitely many constraints over the free quantities z and a scalar t:
///
///     minimize t   subject to   factor * f(z) - offset - (relaxed ? t : 0) <= 0   for every row.
namespace jounce::optimize_detail {

struct Rms {};  ///< the rms acceleration of the whole cam
/// The length of a segment.
struct Spacing {
  std::size_t segment = 0;  ///< index of the segment
};

/// One constraint.
struct Row {
  std::variant<Sample, Rms, Spacing> f;  ///< the function f
  double factor = 1;
  double offset = 0;
  bool relaxed = false;  ///< true: an epigraph row, which contains t
};

/// The problem for a solver.
struct Program {
  const Space& space;
  const std::vector<Row>& rows;
  double least_t = 0;         ///< lower bound of t
  bool hold_masters = false;  ///< true: masters are fixed, and the problem is convex
};

/// Returns factor * f - offset; adds its gradient with respect to z to `gradient`.
double evaluate(const Space& space, const Row& row, std::span<const Knot> knots,
                std::span<double> gradient);

/// The same for `program`. Quantities that it holds have the gradient 0: the steps of the solver
/// are combinations of gradients.
double evaluate(const Program& program, const Row& row, std::span<const Knot> knots,
                std::span<double> gradient);

/// Returns the knots at z, at a distance from each other: a line search may try a point where two
/// knots meet.
std::vector<Knot> separated_knots(const Space& space, std::span<const double> z);

}  // namespace jounce::optimize_detail
