// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Uniform retiming: makes a whole motion slower or faster by one factor.
///
///     const Limits axis{.velocity = 2, .acceleration = 10, .jerk = 100};
///     const double k = least_stretch(motion, axis);   // 1.25: must take 25 % longer
///     const Trajectory fits = retimed(motion, axis);  // reaches a limit at some instant
///
/// least_stretch() returns the factor k for the duration: the least k > 0 with which the motion
/// stays within the limits of velocity, acceleration and jerk. Retiming divides the velocity by k,
/// the acceleration by k^2 and the jerk by k^3. The factor is below 1 if the motion has a margin to
/// every limit. The factor has a closed form in the exact extrema of the derivatives, so no faster
/// motion of the same shape exists. Steps of the acceleration (infinite jerk) remain steps and do
/// not count. Position limits are ignored, because retiming does not change the positions.
///
/// Throws InputError for limits out of range, and if no limit determines k: no limit is given, or
/// the limited derivatives are zero everywhere.
double least_stretch(const Trajectory& motion, const Limits& limits);

/// Returns the least k with which every axis stays within its limits, for axes that move together.
/// Throws InputError also if the two spans have different sizes.
double least_stretch(std::span<const Trajectory> axes, std::span<const Limits> limits);

/// Returns the motion with its duration multiplied by least_stretch(), from the same start time.
Trajectory retimed(const Trajectory& motion, const Limits& limits);

}  // namespace jounce
