// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/optimize/shape.hpp"

namespace jounce::optimize_detail {

/// Result of a search for a shape with figures that are not convex.
struct NotConvexResult {
  enum class End {
    converged,   ///< a local result: no place exceeds its row, and the last rounds gained nothing
    infeasible,  ///< no start met the limits; this is no proof that none can
    stalled,     ///< evaluations, time or rounds ran out, or a figure was not finite
    cancelled,
  };
  End end = End::stalled;  ///< status at the end
  std::string why = {};    ///< reason, one sentence, for `infeasible` and `stalled`
  /// The best shape that meets every limit; if none does, the one that violates them least.
  std::vector<Segment> shape = {};
  int rounds = 0;       ///< number of rounds
  int evaluations = 0;  ///< number of evaluations
};

/// True if the problem has a figure that is not convex, and thus needs this search.
bool needs_search(const ShapeProblem& problem);

/// Minimizes the weighted sum from `given` and from a few shapes near it, which are drawn at random
/// from the seed. Constraints, ceilings and peaks hold at every place (an exchange method), as in
/// the convex solver. If ShapeProblem::refine is set, the pieces on which a peaked figure leaves or
/// meets its level are halved, and the search continues.
NotConvexResult search_shape(const ShapeProblem& problem, const std::vector<Segment>& given,
                             const KeepGoing& keep_going);

/// Returns the given shape. If it has sines, whose products do not fit into a segment, returns the
/// spline with the same derivatives at the knots.
std::vector<Segment> given_as_spline(const ShapeProblem& problem);

/// Returns the result of search_shape() as an outcome of optimize_shape(): figures, limits and
/// active constraints of the finished shape, with a bound if one is known.
ShapeOutcome searched(const ShapeProblem& problem, const KeepGoing& keep_going);

}  // namespace jounce::optimize_detail
