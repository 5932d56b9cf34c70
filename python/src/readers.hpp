// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "python/src/moves.hpp"

namespace jounce::python {

/// The arguments of many moves, in one shape.
struct MoveReaders {
  Reader position, velocity, acceleration;           ///< start
  Reader to_position, to_velocity, to_acceleration;  ///< target
  Reader velocity_min, velocity_max, acceleration_min, acceleration_max, jerk_min, jerk_max,
      position_min, position_max;

  MoveReaders(Broadcast& all, const StateColumns& start, const StateColumns& target,
              const BoundsColumns& b)
      : position(all.read(start.position)),
        velocity(all.read(start.velocity)),
        acceleration(all.read(start.acceleration)),
        to_position(all.read(target.position)),
        to_velocity(all.read(target.velocity)),
        to_acceleration(all.read(target.acceleration)),
        velocity_min(all.read(b.velocity_min)),
        velocity_max(all.read(b.velocity_max)),
        acceleration_min(all.read(b.acceleration_min)),
        acceleration_max(all.read(b.acceleration_max)),
        jerk_min(all.read(b.jerk_min)),
        jerk_max(all.read(b.jerk_max)),
        position_min(all.read(b.position_min)),
        position_max(all.read(b.position_max)) {}

  [[nodiscard]] std::array<Reader*, 14> all() {
    return {&position,        &velocity,     &acceleration, &to_position,      &to_velocity,
            &to_acceleration, &velocity_min, &velocity_max, &acceleration_min, &acceleration_max,
            &jerk_min,        &jerk_max,     &position_min, &position_max};
  }
  [[nodiscard]] MotionState from(std::size_t i) const {
    return {position[i], velocity[i], acceleration[i]};
  }
  [[nodiscard]] MotionState to(std::size_t i) const {
    return {to_position[i], to_velocity[i], to_acceleration[i]};
  }
  [[nodiscard]] Bounds bounds(std::size_t i) const {
    return {velocity_min[i], velocity_max[i], acceleration_min[i], acceleration_max[i],
            jerk_min[i],     jerk_max[i],     position_min[i],     position_max[i]};
  }
};

/// The common shape of these arguments and of one more column.
inline Broadcast broadcast_moves(const StateColumns& start, const StateColumns& target,
                                 const BoundsColumns& b, const Column& more = {}) {
  return Broadcast({&start.position, &start.velocity, &start.acceleration, &target.position,
                    &target.velocity, &target.acceleration, &b.velocity_min, &b.velocity_max,
                    &b.acceleration_min, &b.acceleration_max, &b.jerk_min, &b.jerk_max,
                    &b.position_min, &b.position_max, &more});
}

}  // namespace jounce::python
