// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimize/src/search/evaluations.hpp"

/// The phases of a search. Each evaluates through Evaluations, which keeps the best choice and
/// throws Stop.
namespace jounce::optimize_detail {

/// Result of multi_start().
struct MultiStartCounts {
  int searches = 0;  ///< number of local searches
  int agreeing = 0;  ///< number of local searches that ended at the best choice
};

/// Evaluates choices until one is possible, then sets the scales.
void first_evaluations(Evaluations& evaluations);

/// Runs the global phase: local searches from the best of random choices, until `share` of the
/// budget is used.
MultiStartCounts multi_start(Evaluations& evaluations, double share);

/// Runs local searches from the best choice until none gains. Returns false if the last one still
/// gained.
bool polish(Evaluations& evaluations);

/// Runs all phases of a search with one variable.
void search_line(Evaluations& evaluations);

/// Runs COBYLA from z with steps from `radius` down to `smallest`. Returns the best evaluation of
/// the run.
Evaluation run_cobyla(Evaluations& evaluations, const Choice& z, double radius, double smallest,
                      int max_evaluations);

/// Tries the best step of the linearized problem, at several lengths. Returns true if one of them
/// gained.
bool linearized_step(Evaluations& evaluations);

}  // namespace jounce::optimize_detail
