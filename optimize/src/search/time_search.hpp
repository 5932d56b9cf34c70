// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/optimize/spline_times.hpp"

namespace jounce::optimize_detail {

/// The result of one start.
struct TimeAttempt {
  std::vector<double> intervals;  ///< intervals, s; for `shortest`, one limit is just reached
  double value = 0;               ///< value of the objective
  int evaluations = 0;            ///< number of evaluations
};

/// Returns a local optimum from these intervals, of which only the ratios matter.
TimeAttempt improve(const SplineTimesSpec& spec, std::vector<double> intervals);

}  // namespace jounce::optimize_detail
