#pragma once

#include "jounce/profiles/move.hpp"

namespace jounce::detail {

/// Appends the fastest change from a state inside the bounds to a velocity and acceleration, third
/// order; answers the state it ends in.
MotionState change_velocity(const MotionState& from, double velocity, double acceleration,
                            const Bounds& bounds, Profile& profile) noexcept;

}  // namespace jounce::detail
