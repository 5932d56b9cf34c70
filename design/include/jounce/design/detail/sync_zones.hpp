// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/design/input.hpp"

namespace jounce {

/// Returns the intervals of the master in which the slave of a cam is in step. If a generator made
/// the cam, they are the generator's sync zones; for any other cam, they are its segments of
/// constant nonzero velocity, with their names. Empty for a motion over time.
std::vector<SyncZone> sync_zones(const Input& input);

}  // namespace jounce
