// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "jounce/path/point.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Velocity mode of a point-to-point move (PMC600 manual 7.1, MC_MoveDirect).
enum class DirectMode : std::uint8_t {
  fast,  ///< each axis as fast as it can, and then at rest; the way between depends on the limits
  path_invariant,  ///< the axes stay on the straight line, under any limits and any override
};

/// Point-to-point move of a group, rest to rest: one Trajectory an axis, all of one duration, the shortest.
/// `limits` has one entry an axis. For VelFactor, AccFactor and JerkFactor of the manual see effective() in
/// group_limits.hpp.
///
/// Throws InputError "to" where no axis moves, "axes" for limits that do not fit the number of axes (at most
/// max_axes), and with the axis where synchronise() has no move.
std::vector<Trajectory> direct(const Point& from, const Point& to,
                               const std::vector<Limits>& limits,
                               DirectMode mode = DirectMode::fast);

}  // namespace jounce
