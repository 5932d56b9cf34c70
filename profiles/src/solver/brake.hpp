// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/move.hpp"

// Starts outside the bounds, third order. The rule is derived in docs/generators/move.md, equations
// (7) to (10).

namespace jounce::profiles_detail {

/// True if a state is within the bounds, and can stay within them from then on, with a tolerance
/// that is a share of the limits.
bool is_inside(const MotionState& s, const Bounds& bounds, double tolerance) noexcept;

/// The velocity at which the acceleration reaches zero, if it returns to zero at once.
double natural_velocity(const MotionState& s, const Bounds& bounds) noexcept;

/// Appends the phase that brings the acceleration to its limit with the greatest jerk; returns the
/// state after it.
MotionState acceleration_inside(const MotionState& from, const Bounds& bounds,
                                Profile& profile) noexcept;

/// The velocity limit that every motion from this state exceeds: 1 the upper, -1 the lower, 0 none.
int runs_out(const MotionState& s, const Bounds& bounds) noexcept;

/// Appends the beginning that is common to all motions from a start outside the bounds; returns the
/// state after it. From there on, the bounds hold for all motions whose peak velocity is within its
/// limits.
MotionState begin_inside(const MotionState& from, const Bounds& bounds, Profile& profile) noexcept;

/// A start that already brakes harder than the limit, towards a target that the axis would pass if
/// it braked less.
struct Braking {
  /// u/s^2, signed: the limit with which the axis stops in time; 0: the given limit is sufficient.
  double limit = 0;
  /// s: duration for which the initial acceleration is held, if no limit is sufficient.
  double hold = 0;
};
Braking braking_under_way(const MotionState& from, const MotionState& to,
                          const Bounds& bounds) noexcept;

/// The bounds with a different acceleration limit in the direction of `acceleration`.
Bounds extended(Bounds bounds, double acceleration) noexcept;

}  // namespace jounce::profiles_detail
