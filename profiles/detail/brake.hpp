#pragma once

#include "jounce/profiles/move.hpp"

namespace jounce::detail {

/// Brings a start outside the bounds inside, as fast as they allow: appends the phases to `profile`
/// and answers the state after them, from which every bound can be kept. Third order.
MotionState brought_inside(const MotionState& from, const Bounds& bounds, Profile& profile) noexcept;

/// Whether a state keeps the bounds, and can go on to, but for a share of the limits.
bool is_inside(const MotionState& s, const Bounds& bounds, double tolerance) noexcept;

/// The velocity at which the acceleration is back at zero if that begins at once.
double natural_velocity(const MotionState& s, const Bounds& bounds) noexcept;

}  // namespace jounce::detail
