// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimize/src/search/evaluations.hpp"

/// The phases of a search. All evaluate through Evaluations, which keeps the best, and end with Stop.
namespace jounce::optimizer {

struct MultiStartCounts {
  int searches = 0;  ///< number of local searches
  int agreeing = 0;  ///< number of these that led to the best
};

/// Evaluates points until one is possible, and determines the scales.
void first_evaluations(Evaluations& evaluations);

/// The global phase: local searches from the best of random places, up to `share` of the budget.
MultiStartCounts multi_start(Evaluations& evaluations, double share);

/// Local searches from the best until none gains. False: the last one still gained.
bool polish(Evaluations& evaluations);

/// All phases for one variable.
void search_line(Evaluations& evaluations);

/// COBYLA from z with steps from `radius` down to `smallest`. Returns the best point of the run.
Evaluation run_cobyla(Evaluations& evaluations, const Choice& z, double radius, double smallest,
                      int max_evaluations);

/// SLSQP from z, with central differences of the given step.
void run_slsqp(Evaluations& evaluations, const Choice& z, double step, int iterations);

/// Tries the best step of the linearized problem at several lengths. Returns true if one gained.
bool linearized_step(Evaluations& evaluations);

/// True if a gain justifies a further step.
bool is_gain(const Evaluations& evaluations, const Evaluation& before, const Evaluation& after);

}  // namespace jounce::optimizer
