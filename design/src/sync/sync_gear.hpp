// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"
#include "jounce/spec/sync_spec.hpp"

namespace jounce::detail {

/// The cam of a gear that is engaged. Throws InputError with the document's keys, and where
/// GearInPos cannot be had, which the spec asks for.
SyncCam made_gear(const GearCourse& spec);
SyncCam made_gear(const GearInPosPart& spec);

/// What the cam alone does not tell, in the spec's units: "gear/ratio_step", a clutch of no distance
/// where the cam begins; "gear/reversal", an engagement that must turn back.
Report check_gear(const GearCourse& course, const Units& units);
Report check_gear(const GearInPosPart& part, const Units& units);

}  // namespace jounce::detail
