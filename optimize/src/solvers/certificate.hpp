// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/solvers/interior_point.hpp"

namespace jounce::optimizer {

/// The root of the sum of squares.
double norm(const std::vector<double>& numbers);

/// What the objective of a program cannot be below for any x that keeps its constraints and lies within
/// `range` of the solution, by weak duality: true whatever the solution is worth, close if it is good.
double weak_bound(const ConvexProgram& program, const ConvexSolution& solution,
                  const std::vector<double>& range);

}  // namespace jounce::optimizer
