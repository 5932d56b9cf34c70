// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/solvers/interior_point.hpp"

namespace jounce::optimize_detail {

/// Returns the root of the sum of squares.
double norm(const std::vector<double>& numbers);

/// Returns a lower bound, by weak duality, of the objective of a program for any x that satisfies
/// its constraints and is within `range` of the solution. It is valid for any solution, and close
/// for a good one.
double weak_bound(const ConvexProgram& program, const ConvexSolution& solution,
                  const std::vector<double>& range);

}  // namespace jounce::optimize_detail
