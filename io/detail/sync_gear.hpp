#pragma once

#include "jounce/io/sync_spec.hpp"

namespace jounce::detail {

/// The cam of a gear that is engaged. Throws InputError with the document's keys, and where
/// GearInPos cannot be had, which the spec asks for.
SyncCam made_gear(const GearCourse& spec);
SyncCam made_gear(const GearInPosPart& spec);

}  // namespace jounce::detail
