// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// Kind of goal of an axis. `to` is AxisMove::to.
enum class MoveGoal : std::uint8_t {
  state,     ///< the position, velocity and acceleration of `to`, all at the same instant
  velocity,  ///< the velocity and acceleration of `to`, at any position
  /// A moving target, which is at `to` when the motion begins and keeps the velocity of `to`.
  moving,
};

/// The part of one axis in a common motion. Units: u, u/s, u/s^2, u/s^3, where u is the axis' unit.
struct AxisMove {
  MotionState from = {}, to = {};   ///< start state and goal
  Bounds bounds = {};               ///< limits of this axis
  MoveGoal goal = MoveGoal::state;  ///< kind of the goal
  /// False: the axis takes no part. Its profile stays at `from` and has no duration.
  bool enabled = true;
  /// A motion from `from` to the goal that stays within the bounds, if one is available; otherwise
  /// null. The function uses this motion if it finds no faster one, or if the common duration
  /// equals the duration of this motion.
  const Profile* under_way = nullptr;
};

/// Synchronization of several axes.
enum class Sync : std::uint8_t {
  none,   ///< each axis takes its own shortest time
  time,   ///< all axes arrive together, as early as possible
  phase,  ///< all axes arrive together and stay on a straight line from start to goal
  /// Like time, except that an axis whose target is at rest takes its own shortest time and waits
  /// at the target.
  time_if_moving,
  phase_or_time,  ///< like phase; if the status of phase would be `not_straight`, like time
};

/// Result of synchronize().
struct [[nodiscard]] Synchronized {
  MoveStatus status = MoveStatus::ok;  ///< ok, or why there is no common motion
  std::size_t axis = 0;                ///< index of the axis that causes the status, if the status
                                       ///< is not ok
  /// s, the common duration: the longest duration of an axis, and at least `minimum_duration`; 0 if
  /// the status is not ok. With Sync::time_if_moving, if all targets are at rest, it is the longest
  /// duration of an axis.
  double duration = 0;
};

/// Plans one profile for each axis and writes them to `out`. If the spans differ in size, the
/// status is `wrong_size`, and `out` does not change. Every duration of an enabled axis is at least
/// `minimum_duration` (s); with Sync::time_if_moving, this does not apply to an axis whose target
/// is at rest. With `grid` > 0 (s), every duration is a multiple of `grid`. If the status is not
/// ok, the profiles in `out` are not a motion.
///
/// With Sync::phase, the status is `not_straight` (the path is never bent) in these cases:
/// - The states are not on the line from start to goal: velocities and accelerations must be
///   proportional to the distances. For velocity goals, the line lies in the space of velocities.
///   For moving targets, the line is measured relative to the targets.
/// - The axes have different kinds of goals.
/// - An axis inside its bounds cannot stay inside them on the line. On a line, the axis with the
///   least jerk in proportion to its distance limits how fast the accelerations of all axes fall.
///
/// If minimum_duration or grid is not finite, the status is `not_finite`. Without axes, the status
/// is ok and the duration 0. A start outside the bounds: see move_to(). Does not allocate or throw.
Synchronized synchronize(std::span<const AxisMove> axes, Sync sync, std::span<Profile> out,
                         double minimum_duration = 0, double grid = 0) noexcept;

}  // namespace jounce
