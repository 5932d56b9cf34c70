// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/optimize/shape.hpp"

namespace jounce::optimizer {

/// The end of a search for a shape with figures that are not convex.
struct NotConvexResult {
  enum class End {
    converged,  ///< a local result: no place breaks its row any more, and the last rounds gained nothing
    infeasible,  ///< no start met the limits, which is no proof
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

/// Minimizes the weighted sum from `given` and from a few shapes near it, which are drawn at random
/// from the seed. Constraints, ceilings and peaks hold at every place (an exchange method), as in
/// the convex solver. If ShapeProblem::refine is set, the pieces on which a peaked figure leaves or
/// meets its level are halved, and the search continues.
NotConvexResult search_shape(const ShapeProblem& problem, const std::vector<Segment>& given,
                             const KeepGoing& keep_going);

/// The given shape. If it has sines, whose products do not fit a segment: the spline with the same derivatives
/// at the knots.
std::vector<Segment> given_as_spline(const ShapeProblem& problem);

/// The same as an outcome of optimize_shape(): figures, limits and active constraints of the finished shape,
/// with a bound where one is known.
ShapeOutcome searched(const ShapeProblem& problem, const KeepGoing& keep_going);

}  // namespace jounce::optimizer
