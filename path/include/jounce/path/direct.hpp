// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "jounce/path/plan.hpp"
#include "jounce/path/point.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Kind of a point-to-point move of a group (PMC600 manual 7.1, MC_MoveDirect).
enum class DirectMode : std::uint8_t {
  fast,  ///< each axis takes its own shortest time, then rests; the path depends on the limits
  path_invariant,  ///< the axes stay on the straight line, for any limits and any override
};

/// Plans a point-to-point move of a group from rest to rest. Returns one trajectory for each axis.
/// All trajectories have the duration of the slowest axis. `limits` has one entry for each axis.
/// For VelFactor, AccFactor and JerkFactor of the manual, see effective() in group_limits.hpp.
///
/// Throws InputError "to" if no axis moves, "axes" if there are no limits or more than max_axes,
/// and with the name of the axis if synchronize() finds no move.
std::vector<Trajectory> direct(const Point& from, const Point& to,
                               const std::vector<Limits>& limits,
                               DirectMode mode = DirectMode::fast);

/// Plans a point-to-point move in which each axis takes its own shortest time (DirectMode::fast),
/// as a Plan. The path parameter grows evenly with time, from 0 to the distance that the first
/// `path_axes` axes cover together (0: all axes). If these axes do not move, it grows to the
/// distance of all axes. The source line is 1. Throws InputError like direct(), and "to" if no axis
/// moves.
Plan direct_plan(const Point& from, const Point& to, const std::vector<Limits>& limits,
                 std::size_t path_axes = 0);

/// Follows a plan until time t (s), then leaves the plan in motion and moves to `to`. This is the
/// buffer mode Aborting (PLCopen; BM_ABORT of HIMC). Returns one trajectory for each axis over the
/// whole motion; all axes come to rest at `to` together. Velocity and acceleration are continuous,
/// so the motion from the path to `to` is curved. The limits of the plan's axes determine its shape
/// and apply at every instant. Limits of the path do not apply after t.
///
/// Throws InputError "t" outside [0, duration], "to" if the axes cannot reach it, and "plan" if the
/// plan has joints.
std::vector<Trajectory> aborted(const Plan& plan, double t, const Point& to);

}  // namespace jounce
