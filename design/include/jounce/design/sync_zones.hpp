// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/design/input.hpp"

namespace jounce {

/// The zones of a cam, by master, in which its slave is in step: those of its generator; of any other cam the segments
/// of constant velocity, except 0, with the names of the segments. Empty for a motion over time.
std::vector<SyncZone> sync_zones(const Input& input);

}  // namespace jounce
