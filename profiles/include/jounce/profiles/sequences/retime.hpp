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
/// least_stretch() returns the least k > 0 for which the motion keeps the limits of velocity,
/// acceleration and jerk, if its duration is multiplied by k: velocity is divided by k,
/// acceleration by k^2, jerk by k^3. The result is a closed form from the exact extrema, so no
/// faster motion has the same shape. It is below 1 if the motion has a margin to every limit. Steps
/// of the acceleration (infinite jerk) remain steps and do not count. Position limits are ignored,
/// because retiming does not change the positions.
///
/// Throws InputError for limits out of range, and if no limit determines k: none is given, or only
/// limits of derivatives that are zero everywhere.
double least_stretch(const Trajectory& motion, const Limits& limits);

/// Returns the least k for axes that move together: one k that is enough for all. Both spans have
/// the same size.
double least_stretch(std::span<const Trajectory> axes, std::span<const Limits> limits);

/// Returns the motion with its duration multiplied by least_stretch(); its start time stays.
Trajectory retimed(const Trajectory& motion, const Limits& limits);

}  // namespace jounce
