// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "jounce/path/overlap.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/spec/path_spec.hpp"

namespace jounce::design_detail {

/// A planned path as one motion for each axis.
struct PathMotion {
  std::shared_ptr<const Plan> plan = {};
  std::shared_ptr<const Overlapped> overlap = {};  ///< overlapping lines, instead of a plan
  PlanAxes axes = {};
  /// Names of the segments of each axis: "line 12", "corner 12", "dwell".
  std::vector<std::vector<std::string>> names = {};
};

/// Makes the motion. Throws InputError with the source and the line of the command, or with a key
/// of the document.
PathMotion motion_of(const PathSpec& path);

}  // namespace jounce::design_detail
