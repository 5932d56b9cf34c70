// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/optimize/shape.hpp"

namespace jounce::optimizer {

/// optimize_shape() from a shape that is near the result. The figures of that shape are the units, so the
/// numbers of the program are of about size one; the figures of the given shape may differ by a factor of
/// hundreds. Without such a shape it starts from the given one. Problems that are not convex always start from
/// the given shape.
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
