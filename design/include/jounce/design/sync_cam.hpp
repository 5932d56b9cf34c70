// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/gear/sync_cam.hpp"
#include "jounce/spec/sync_spec.hpp"

namespace jounce {

/// Makes the cam of a synchronous slave. Throws InputError with the keys of the document.
SyncCam sync_cam_of(const SyncSpec& spec);

}  // namespace jounce
