// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce {

/// Adds the findings of a cam that do not depend on its limits: warnings, and the characteristic
/// values of its rises with their lower bounds (certificates()). If the spec has [limits.slave] and
/// [master], adds also the slave's findings over time, and the fastest master at which the slave
/// stays within these limits. Omits steps of derivatives up to the order `continuity`, because
/// check_all() reports them. Adds nothing for a motion over time.
void add_cam_findings(Report& report, const Input& input, int continuity);

/// Returns all findings of `jounce check`, sorted: those of check_all() and of add_cam_findings().
Report checked(const Input& input, int continuity = 1, const EngageState& at = {});

/// True for a cam whose rises are laws between given knots. False for a synchronous slave: its
/// generator determines the rises, so they are not compared with bounds.
bool has_designed_rises(const Input& input);

}  // namespace jounce
