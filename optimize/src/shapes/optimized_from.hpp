// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/optimize/shape.hpp"

namespace jounce::optimize_detail {

/// optimize_shape() that starts from a shape near the result. The figures of that shape are the
/// units of the program, so that its numbers are of about size one. (The figures of the given shape
/// may be hundreds of times as large.) If `start` is empty, the search starts from the given shape.
/// Problems that are not convex always start from the given shape.
ShapeOutcome optimized_from(const ShapeProblem& problem, std::vector<Segment> start,
                            const KeepGoing& keep_going);

/// Returns the progress of a method whose number of rounds is unknown: 10 rounds count as half of
/// the work.
inline OptimizeProgress round_progress(int round, int evaluations, double reached) {
  return {.done = round / (round + 10.0),
          .round = round,
          .evaluations = evaluations,
          .reached = reached};
}

}  // namespace jounce::optimize_detail
