// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimize/src/search/trials.hpp"

/// What a search is made of. All of it asks through Trials, which keeps the best, and ends with Stop.
namespace jounce::optimizer {

struct Roamed {
  int searches = 0;  ///< local ones
  int agreeing = 0;  ///< agreeing of these, that led to the best
};

/// Asks here and there until something is possible, and settles the scales.
void survey(Trials& trials);

/// The global phase: local searches from the best of random places, at most to `share` of the budget.
Roamed roam(Trials& trials, double share);

/// Local searches from the best until nothing gains; false: it still gained when it was given up.
bool polish(Trials& trials);

/// Everything for one variable.
void walk_line(Trials& trials);

/// COBYLA from z in steps of `radius` down to `smallest`; where it ended.
Trial descend(Trials& trials, const Choice& z, double radius, double smallest, int evaluations);

/// SLSQP from z with central differences of a step.
void slide(Trials& trials, const Choice& z, double step, int iterations);

/// The best step of the linearised problem from the best, at several lengths; whether one gained.
bool step_linearly(Trials& trials);

/// A gain that is worth a further step.
bool is_gain(const Trials& trials, const Trial& before, const Trial& after);

}  // namespace jounce::optimizer
