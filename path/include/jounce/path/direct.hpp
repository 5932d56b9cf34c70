// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "jounce/path/plan.hpp"
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

/// Buffer mode Aborting (PLCopen; BM_ABORT of HIMC): the motion of a plan up to t, left from its moving state for
/// `to`. One Trajectory an axis over the whole motion; the axes come to rest at `to` together. Velocity and
/// acceleration are continuous, so the way from the path to `to` is curved and depends on the limits: those of the
/// plan's axes, which hold at every instant. Limits of the path do not apply behind t.
///
/// Throws InputError "t" outside [0, duration], "to" where the axes cannot get there, and "plan" for one with joints.
std::vector<Trajectory> aborted(const Plan& plan, double t, const Point& to);

}  // namespace jounce
