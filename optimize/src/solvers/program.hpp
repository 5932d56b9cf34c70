// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "optimize/src/knots/space.hpp"

/// A smooth problem with finitely many constraints over the free quantities z and a scalar t:
///
///     minimize t   subject to   factor * f(z) - offset - (relaxed ? t : 0) <= 0   for every row.
namespace jounce::optimizer {

struct Rms {};  ///< the rms acceleration of the whole cam
struct Spacing {
  std::size_t segment = 0;  ///< its length
};

struct Row {
  std::variant<Sample, Rms, Spacing> f;
  double factor = 1;
  double offset = 0;
  bool relaxed = false;  ///< an epigraph row
};

struct Program {
  const Space& space;
  const std::vector<Row>& rows;
  double least_t = 0;
  bool hold_masters = false;  ///< the rest of the problem is convex
};

/// factor * f - offset; adds its gradient by z.
double evaluate(const Space& space, const Row& row, std::span<const Knot> knots,
                std::span<double> gradient);

/// The same at knots that belong to `program`, whose held quantities have no slope: the steps of the solver are
/// combinations of gradients.
double evaluate(const Program& program, const Row& row, std::span<const Knot> knots,
                std::span<double> gradient);

/// The knots at z, kept apart: a line search may step to a point where two knots meet.
std::vector<Knot> separated_knots(const Space& space, std::span<const double> z);

}  // namespace jounce::optimizer
