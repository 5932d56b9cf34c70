// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/search/evaluations.hpp"

namespace jounce::optimizer {

/// A choice (a point of the search) as rows r_i(z) <= 0 for a solver: the objective f, the
/// constraints c_i divided by their usual sizes s_i and tightened by a small h, and one more row
/// r_0 for choices that cannot be computed:
///
///     (1)  possible:      f(z), c_i(z) / s_i + h,  r_0 = 0
///     (2)  not possible:  f(y), c_i(y) / s_i + h,  r_0 = |z - y|,   y the nearest possible choice known
///
/// Nothing is gained outside the possible choices, and r_0 leads back to them. No row is NaN.
struct SolverValues {
  double objective = 0;  ///< in units of its spread
  std::vector<double> rows;
};

/// Throws Stop, as Evaluations::at() does.
SolverValues solver_values(Evaluations& evaluations, const Choice& z, double margin);

/// Slopes of objective and rows in each variable by central differences, shorter at a bound.
std::vector<SolverValues> slopes(Evaluations& evaluations, const Choice& z, double margin,
                                 double difference);

}  // namespace jounce::optimizer
