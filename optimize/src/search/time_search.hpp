// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/optimize/spline_times.hpp"

namespace jounce::optimizer {

/// What one start led to.
struct TimeAttempt {
  std::vector<double> intervals;  ///< s; for `shortest` scaled so that the limits just hold
  double value = 0;               ///< value of the objective
  int evaluations = 0;
};

/// A local optimum from the given intervals, of which only the ratios count.
TimeAttempt improve(const SplineTimesSpec& spec, std::vector<double> intervals);

}  // namespace jounce::optimizer
