// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/optimize/spline_times.hpp"

namespace jounce::optimizer {

/// The result of one start.
struct TimeAttempt {
  std::vector<double> intervals;  ///< s; for `shortest` the limits just hold
  double value = 0;               ///< value of the objective
  int evaluations = 0;
};

/// A local optimum from the given intervals. Only their ratios matter.
TimeAttempt improve(const SplineTimesSpec& spec, std::vector<double> intervals);

}  // namespace jounce::optimizer
