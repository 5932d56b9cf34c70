// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/solvers/interior_point.hpp"

namespace jounce::optimizer {

/// The root of the sum of squares.
double norm(const std::vector<double>& numbers);

/// A lower bound of the objective of a program for any x that keeps its constraints and lies within `range` of
/// the solution, by weak duality. It holds for any solution, and is close for a good one.
double weak_bound(const ConvexProgram& program, const ConvexSolution& solution,
                  const std::vector<double>& range);

}  // namespace jounce::optimizer
