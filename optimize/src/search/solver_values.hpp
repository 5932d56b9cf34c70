// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/search/evaluations.hpp"

namespace jounce::optimize_detail {

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

/// Returns the values at a choice. `margin`: h of (1). Throws Stop like Evaluations::at().
SolverValues solver_values(Evaluations& evaluations, const Choice& z, double margin);

/// Returns the slopes of objective and rows with respect to each variable, by central differences;
/// the step is shorter at a bound.
std::vector<SolverValues> slopes(Evaluations& evaluations, const Choice& z, double margin,
                                 double difference);

}  // namespace jounce::optimize_detail
