// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "jounce/path/overlap.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/spec/path_spec.hpp"

namespace jounce::design_detail {

/// A planned path as one motion an axis.
struct PathMotion {
  std::shared_ptr<const Plan> plan = {};
  std::shared_ptr<const Overlapped> overlap = {};  ///< instead of a plan: lines that overlap
  PlanAxes axes = {};
  std::vector<std::vector<std::string>> names =
      {};  ///< names of the segments of each axis: "line 12", "corner 12", "dwell"
};

/// Throws InputError with the source and the line of the command, or with a key of the document.
PathMotion motion_of(const PathSpec& path);

}  // namespace jounce::design_detail
