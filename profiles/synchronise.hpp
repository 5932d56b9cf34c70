#pragma once

#include <span>

#include "jounce/profiles/move.hpp"

namespace jounce {

/// One axis of a common motion.
struct AxisMove {
  MotionState from, to;
  Bounds bounds;
};

/// How several axes go together.
enum class Sync : std::uint8_t {
  none,   ///< each as fast as it can
  time,   ///< all arrive at the same instant, the earliest at which every axis can
  phase,  ///< all on one straight line at every instant
};

struct Synchronised {
  MoveStatus status = MoveStatus::ok;
  std::size_t axis = 0;  ///< which axis is the reason, where the status is not ok
  double duration = 0;   ///< of the longest axis
};

/// Solves all axes into `out` (one profile an axis; spans of equal size). `minimum_duration`
/// stretches the motion. Sync::phase needs states that lie on the line from start to target
/// (velocities and accelerations proportional to the distances): otherwise `not_straight`, never a
/// bent path. Does not allocate, does not throw.
Synchronised synchronise(std::span<const AxisMove> axes, Sync sync, std::span<Profile> out,
                         double minimum_duration = 0) noexcept;

}  // namespace jounce
