// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "optimize/src/knots/exchange_method.hpp"

namespace jounce::optimizer {

/// Options of several starts on one machine.
struct MultiStartOptions {
  int evaluations = 0;  ///< for each start
  /// Called in the calling thread after each start and about 50 times a second, with the number of finished
  /// starts and the best of them. If it returns false, all starts end with their best so far.
  std::function<bool(std::size_t done, const std::optional<Merit>& best)> go_on;
  /// Returns true if a result makes later starts unnecessary.
  std::function<bool(const LocalSolution&)> enough;
};

/// exchange_method() from each start, on all cores. The results are in the order of the starts, and the same on any
/// number of cores unless go_on ends the run.
std::vector<LocalSolution> multi_start(const Subproblem& subproblem,
                                       const std::vector<Point>& starts,
                                       const MultiStartOptions& options);

}  // namespace jounce::optimizer
