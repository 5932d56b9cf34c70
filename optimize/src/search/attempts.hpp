// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "optimize/src/knots/improve.hpp"

namespace jounce::optimizer {

/// Options of several starts on one machine.
struct AttemptsOptions {
  int evaluations = 0;  ///< for each start
  /// Called in the calling thread after each start and about 50 times a second, with the number of finished
  /// starts and the best of them. If it returns false, all starts end with their best so far.
  std::function<bool(std::size_t done, const std::optional<Standing>& best)> go_on;
  /// Returns true if a result makes later starts unnecessary.
  std::function<bool(const Attempt&)> enough;
};

/// improve() from each start, on all cores. The results are in the order of the starts, and the same on any
/// number of cores unless go_on ends the run.
std::vector<Attempt> attempts(const Stage& stage, const std::vector<Point>& starts,
                              const AttemptsOptions& options);

}  // namespace jounce::optimizer
