// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce {

/// Adds the findings of a cam that check_all() does not report: warnings, and the characteristic
/// values of its rises with their lower bounds (certificates() in certificate.hpp). If the spec has
/// [limits.slave] and [master], also adds the findings on the slave's motion over time, and the
/// fastest master at which the slave stays within these limits. Omits steps of derivatives up to
/// the order `continuity`, because check_all() reports them. Adds nothing for a motion over time.
void add_cam_findings(Report& report, const Input& input, int continuity);

/// Returns all findings of `jounce check`, sorted: the findings of check_all() and of
/// add_cam_findings(). `at`: state in which a coupling engages.
Report checked(const Input& input, int continuity = 1, const EngageState& at = {});

/// True for a cam whose rises are laws between given knots. False for a synchronous slave: its
/// generator determines the rises, so they are not compared with bounds.
bool has_designed_rises(const Input& input);

}  // namespace jounce
