#pragma once

#include "jounce/profiles/move.hpp"

namespace jounce::detail {

/// Whether a state keeps the bounds, and can go on to, but for a share of the limits.
bool is_inside(const MotionState& s, const Bounds& bounds, double tolerance) noexcept;

/// The velocity at which the acceleration is back at zero if that begins at once.
double natural_velocity(const MotionState& s, const Bounds& bounds) noexcept;

/// How a velocity beyond its limit comes back to it: as fast as it can, which leaves an acceleration
/// that carries it on, or level, without acceleration.
enum class Return { fastest, level };

/// Brings a start outside the bounds inside: appends the phases to `profile` and answers the state
/// after them, from which every bound can be kept. Third order.
MotionState brought_inside(const MotionState& from, const Bounds& bounds, Return way,
                           Profile& profile) noexcept;

}  // namespace jounce::detail
