// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// Goal of an axis.
enum class MoveGoal : std::uint8_t {
  state,     ///< `to`: position, velocity and acceleration at one instant
  velocity,  ///< the velocity and acceleration of `to`, wherever that is
  moving,  ///< a target that is at `to` when the motion begins and continues at the velocity of `to`
};

/// One axis of a common motion.
struct AxisMove {
  MotionState from, to;
  Bounds bounds;
  MoveGoal goal = MoveGoal::state;
  /// An axis that is not enabled takes no part: its profile is `from`, of no duration.
  bool enabled = true;
  /// A motion from `from` to the goal that is known to keep the bounds, or null. It is used if no
  /// faster one is found, and if the common duration equals its own.
  const Profile* under_way = nullptr;
};

/// Synchronization of several axes.
enum class Sync : std::uint8_t {
  none,            ///< each as fast as it can
  time,            ///< all arrive at the same instant, the earliest at which every axis can
  phase,           ///< all on one straight line at every instant
  time_if_moving,  ///< like time, but an axis whose target rests goes as fast as it can and waits there
  phase_or_time,  ///< phase if the states lie on one line, otherwise time
};

struct Synchronised {
  MoveStatus status = MoveStatus::ok;
  std::size_t axis = 0;  ///< the axis that causes a status other than ok
  double duration = 0;   ///< duration of the longest axis
};

/// Solves all axes into `out` (one profile an axis; spans of equal size). `minimum_duration`
/// stretches the motion; with a `grid` > 0 every duration is a multiple of it (s).
///
/// Sync::phase needs states that lie on the line from start to target (velocities and accelerations
/// proportional to the distances) and one kind of goal: otherwise `not_straight`, never a bent path.
/// The line of velocity goals lies in the space of velocities, and that of moving targets is seen
/// from the targets. A line also needs jerk limits with which an axis inside its own bounds can
/// stay there (the axis with the least jerk for its share of the way decides how fast all
/// accelerations fall): otherwise `not_straight`. A start outside the bounds: see move_to(). Does not
/// allocate, does not throw.
Synchronised synchronise(std::span<const AxisMove> axes, Sync sync, std::span<Profile> out,
                         double minimum_duration = 0, double grid = 0) noexcept;

}  // namespace jounce
