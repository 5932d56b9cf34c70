// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "optimize/src/knots/improve.hpp"

namespace jounce::optimizer {

/// How several starts share a machine.
struct AttemptsOptions {
  int evaluations = 0;  ///< for each start
  /// Called in the calling thread after each start, and some 50 times a second, with how many are done and
  /// the best of them; false: all of them end with their best so far.
  std::function<bool(std::size_t done, const std::optional<Standing>& best)> go_on;
  /// True if a result leaves nothing to those after it: they are left out.
  std::function<bool(const Attempt&)> enough;
};

/// improve() from each start, on all cores; results in the order of the starts, the same on any number of
/// cores unless go_on ends them.
std::vector<Attempt> attempts(const Stage& stage, const std::vector<Point>& starts,
                              const AttemptsOptions& options);

}  // namespace jounce::optimizer
