// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimize/src/search/trials.hpp"

/// The phases of a search. All evaluate through Trials, which keeps the best, and end with Stop.
namespace jounce::optimizer {

struct Roamed {
  int searches = 0;  ///< number of local searches
  int agreeing = 0;  ///< number of these that led to the best
};

/// Evaluates points until one is possible, and determines the scales.
void survey(Trials& trials);

/// The global phase: local searches from the best of random places, up to `share` of the budget.
Roamed roam(Trials& trials, double share);

/// Local searches from the best until none gains. False: the last one still gained.
bool polish(Trials& trials);

/// All phases for one variable.
void walk_line(Trials& trials);

/// COBYLA from z with steps from `radius` down to `smallest`. Returns the best point of the run.
Trial descend(Trials& trials, const Choice& z, double radius, double smallest, int evaluations);

/// SLSQP from z, with central differences of the given step.
void slide(Trials& trials, const Choice& z, double step, int iterations);

/// Tries the best step of the linearized problem at several lengths. Returns true if one gained.
bool step_linearly(Trials& trials);

/// True if a gain justifies a further step.
bool is_gain(const Trials& trials, const Trial& before, const Trial& after);

}  // namespace jounce::optimizer
