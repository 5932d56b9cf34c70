// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/gear/follow_plan.hpp"

namespace jounce::gear_detail {

/// A place where the slave's position and ratio are known. `zone`: number of the sync zone that
/// ends here.
struct FollowKnot {
  double master = 0;
  double slave = 0;
  std::optional<double> ratio = {};
  std::optional<std::size_t> zone = {};
};

/// The start, and the points and zones of a plan in the order of the master, with all ratios.
/// Throws InputError like follow_table().
std::vector<FollowKnot> follow_knots(const FollowPlan& plan);

}  // namespace jounce::gear_detail
