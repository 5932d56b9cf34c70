// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "optimize/src/knots/exchange_method.hpp"

namespace jounce::optimize_detail {

/// Options of multi_start().
struct MultiStartOptions {
  int evaluations = 0;  ///< greatest number of evaluations of each start
  /// Called in the calling thread after each start and about 50 times a second, with the number of
  /// finished starts and the best result. If it returns false, all starts end with their best
  /// results so far.
  std::function<bool(std::size_t done, const std::optional<Merit>& best)> go_on;
  /// Returns true if this result makes later starts unnecessary.
  std::function<bool(const LocalSolution&)> enough;
};

/// Runs exchange_method() from each start, on all cores. The results are in the order of the
/// starts. They do not depend on the number of cores, unless go_on ends the run.
std::vector<LocalSolution> multi_start(const Subproblem& subproblem,
                                       const std::vector<Point>& starts,
                                       const MultiStartOptions& options);

}  // namespace jounce::optimize_detail
