// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/optimize/shape.hpp"

namespace jounce::optimizer {

/// optimize_shape() from a shape that is near the answer: figures are counted in what they are there, so that the
/// numbers of the program are of about size one. Figures may differ from those of the given shape by a factor of
/// hundreds. None: from the given shape. What is not convex begins as it always does.
ShapeOutcome optimized_from(const ShapeProblem& problem, std::vector<Segment> start,
                            const KeepGoing& keep_going);

/// Progress of a method whose number of rounds is unknown: 10 rounds count as half of the work.
inline OptimizeProgress round_progress(int round, int evaluations, double reached) {
  return {.done = round / (round + 10.0),
          .round = round,
          .evaluations = evaluations,
          .reached = reached};
}

}  // namespace jounce::optimizer
