// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce {

/// Adds the findings of a cam that do not depend on its limits: warnings, the characteristic values
/// of its rises with their lower bounds (certificates()), and the fastest master that keeps
/// [limits.slave]. Steps of derivatives up to the order `continuity` are omitted, because
/// check_all() finds them. Adds nothing for a motion over time.
void add_cam_findings(Report& report, const Input& input, int continuity);

/// Returns all findings of `jounce check`, sorted: those of check_all() and of add_cam_findings().
Report checked(const Input& input, int continuity = 1, const EngageState& at = {});

/// True for a cam whose rises are laws between given knots. False for a synchronous slave: its
/// rises follow from its generator, so they are not compared with bounds.
bool has_designed_rises(const Input& input);

}  // namespace jounce
