// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "optimize/src/knots/subproblem.hpp"

namespace jounce::optimizer {

struct LocalSolution {
  Point z;  ///< the best point: the least value without violation, or else the least violation
  Merit merit;
  bool converged = false;
  int evaluations = 0;
};

/// The exchange method. Solves with the ceilings and the epigraph imposed at a few places, finds the exact
/// extrema of the result, adds the places where they break a ceiling or exceed the epigraph, and solves again.
/// It ends when there is no such place and neither a restart nor the linearized problem gains anything. `go_on`
/// is called at each evaluation; false ends the run with the best so far.
LocalSolution exchange_method(const Subproblem& subproblem, const Point& start, int max_evaluations,
                              const std::function<bool()>& go_on);

}  // namespace jounce::optimizer
