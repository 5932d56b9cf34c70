// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/gear/sync_cam.hpp"
#include "jounce/spec/sync_spec.hpp"

namespace jounce {

/// The cam of such a spec. Throws InputError with the document's keys.
SyncCam sync_cam_of(const SyncSpec& spec);

}  // namespace jounce
