// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "optimize/src/knots/subproblem.hpp"

namespace jounce::optimize_detail {

/// Result of exchange_method().
struct LocalSolution {
  /// The best point: the least value among the points without violation; if there is none, the
  /// least violation.
  Point z;
  Merit merit;             ///< its value and violation
  bool converged = false;  ///< true if the method has ended by itself
  int evaluations = 0;     ///< number of evaluations
};

/// Runs the exchange method. It solves with the ceilings and the epigraph imposed at a few places,
/// finds the exact extrema of the result, adds the places where they exceed a ceiling or the
/// epigraph, and solves again. It ends when there is no such place and neither a restart nor the
/// linearized problem improves the result. `go_on` is called at each evaluation; if it returns
/// false, the run ends with the best result so far.
LocalSolution exchange_method(const Subproblem& subproblem, const Point& start, int max_evaluations,
                              const std::function<bool()>& go_on);

}  // namespace jounce::optimize_detail
