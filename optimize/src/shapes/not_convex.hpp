// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/optimize/shape.hpp"

namespace jounce::optimizer {

/// Where a search for a shape with figures that are not convex ended.
struct NotConvexResult {
  enum class End {
    converged,   ///< local: no place breaks its row any more, and the last rounds gained nothing
    infeasible,  ///< no start met the limits: no proof
    stalled,     ///< evaluations, time or rounds ran out, or a figure was not finite
    cancelled,
  };
  End end = End::stalled;
  std::string why = {};             ///< infeasible, stalled: one sentence
  std::vector<Segment> shape = {};  ///< the best that met every limit, or else the least violated
  int rounds = 0;
  int evaluations = 0;
};

/// True if a figure of the problem needs this search rather than a convex program.
bool needs_search(const ShapeProblem& problem);

/// Minimises the weighted sum from `given` and, from the same seed, a few shapes beside it. Walls, ceilings
/// and peaks hold at every place (exchange), as in the convex solver. With ShapeProblem::refine pieces on
/// which a peaked figure leaves or meets its level are halved and the search goes on.
NotConvexResult search_shape(const ShapeProblem& problem, const std::vector<Segment>& given,
                             const KeepGoing& keep_going);

/// The given shape; where it has sines, products of which fit no segment, the spline with the same
/// derivatives at the knots.
std::vector<Segment> given_as_spline(const ShapeProblem& problem);

/// The same as the answer of optimize_shape(): figures, limits and what is active judged on the finished
/// shape, with a bound where one is known.
ShapeOutcome searched(const ShapeProblem& problem, const KeepGoing& keep_going);

}  // namespace jounce::optimizer
