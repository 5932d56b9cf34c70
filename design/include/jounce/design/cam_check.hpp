// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce {

/// Adds the findings of a cam besides its limits: warnings, certificates of its rises, and the fastest master that
/// keeps [limits.slave]. Steps up to the derivative `continuity` are left out: check_all() finds them. Adds nothing to
/// a motion over time.
void add_cam_findings(Report& report, const Input& input, int continuity);

/// All findings of `jounce check`: those of check_all() and of add_cam_findings(), sorted.
Report checked(const Input& input, int continuity = 1, const EngageState& at = {});

/// True for a cam whose rises are laws between chosen knots. The rises of a slave in step follow from its generator,
/// and are not compared with a bound.
bool has_designed_rises(const Input& input);

}  // namespace jounce
