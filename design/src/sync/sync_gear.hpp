// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"
#include "jounce/spec/sync_spec.hpp"

namespace jounce::design_detail {

/// Findings that the cam alone does not show, in the units of the spec: "gear/ratio_step" for a
/// clutch without a distance at the start of the cam; "gear/reversal" for an engagement that must
/// reverse.
Report check_gear(const GearCourse& course, const Units& units);
Report check_gear(const GearInPosPart& part, const Units& units);

}  // namespace jounce::design_detail
