// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/path/path.hpp"

#include "path/src/timing/stations.hpp"

namespace jounce {

/// A turn alone is passed at constant velocity. Turns that share the lines between them leave no distance on which the
/// velocity could change, so all of them would have the velocity of the slowest. Replaces the boxes of such turns by
/// boxes in which the law may change its velocity. Which turns this concerns depends on the three turns before and the
/// three behind each at most. `units`: all units of a path, or those between two rests.
void open_chains(std::span<Unit> units, const Path& path, const Rates& rates,
                 std::span<const PathSettings> settings);

}  // namespace jounce
