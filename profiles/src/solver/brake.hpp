// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/move.hpp"

// Starts outside the bounds, third order. docs/generators/move.md derives the rule, equations (7) to
// (10).

namespace jounce::profiles_detail {

/// True if a state keeps the bounds now and can keep them from there on, but for a share of the limits.
bool is_inside(const MotionState& s, const Bounds& bounds, double tolerance) noexcept;

/// The velocity at which the acceleration is back at zero if it returns at once.
double natural_velocity(const MotionState& s, const Bounds& bounds) noexcept;

/// Brings the acceleration inside its limits at full jerk: appends that phase, returns the state
/// after it.
MotionState acceleration_inside(const MotionState& from, const Bounds& bounds,
                                Profile& profile) noexcept;

/// The velocity limit that every motion from a state passes: 1 the upper, -1 the lower, 0 none.
int runs_out(const MotionState& s, const Bounds& bounds) noexcept;

/// Appends the beginning that all motions from a start outside the bounds share, and returns the
/// state after it. From there the bounds hold for all motions whose peak velocity lies inside.
MotionState begin_inside(const MotionState& from, const Bounds& bounds, Profile& profile) noexcept;

/// Braking under way that is harder than the limit, towards a target that the axis would otherwise
/// pass.
struct Braking {
  double limit =
      0;            ///< u/s^2, signed: the limit that stops the axis in time; 0: the given one does
  double hold = 0;  ///< s: for how long the start's acceleration is held, where none stops in time
};
Braking braking_under_way(const MotionState& from, const MotionState& to,
                          const Bounds& bounds) noexcept;

/// Bounds with another limit of acceleration on the side of `acceleration`.
Bounds extended(Bounds bounds, double acceleration) noexcept;

}  // namespace jounce::profiles_detail
