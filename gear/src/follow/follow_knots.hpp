// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/gear/follow_plan.hpp"

namespace jounce::gear_detail {

/// A place where the slave's position and ratio are known; `zone` leads to it in step.
struct FollowKnot {
  double master = 0;
  double slave = 0;
  std::optional<double> ratio = {};
  std::optional<std::size_t> zone = {};
};

/// The start, the points and zones of a plan in the master's order, ends included, every ratio filled
/// in. Throws InputError as follow_table() does.
std::vector<FollowKnot> follow_knots(const FollowPlan& plan);

}  // namespace jounce::gear_detail
