// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "optimize/src/knots/stage.hpp"

namespace jounce::optimizer {

struct Attempt {
  Point z;  ///< the best found: least value without violation, or else the least violation
  Standing standing;
  bool converged = false;
  int evaluations = 0;
};

/// The exchange method: solve with the ceilings and the epigraph imposed at a few places, find the
/// exact extrema of the result, add the places where they break a ceiling or exceed the epigraph,
/// solve again, until none does and neither a restart nor the linearised problem gains anything. `go_on` is
/// asked at each evaluation; false ends it with the best so far.
Attempt improve(const Stage& stage, const Point& start, int max_evaluations,
                const std::function<bool()>& go_on);

}  // namespace jounce::optimizer
