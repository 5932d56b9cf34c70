// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Uniform retiming: the same motion, slower or faster as a whole.
///
///     const Limits axis{.velocity = 2, .acceleration = 10, .jerk = 100};
///     const double k = least_stretch(motion, axis);   // 1.25: needs a quarter longer
///     const Trajectory fits = retimed(motion, axis);  // at some instant exactly at a limit
///
/// The least k > 0 such that the motion stretched to k times its duration keeps the rates: velocity
/// falls by k, acceleration by k^2, jerk by k^3. Closed form from the exact extrema, so that
/// nothing faster with the same shape exists; below 1 if the motion has a margin. Steps of the
/// acceleration (infinite jerk) stay steps and are not counted. Position limits do not enter:
/// stretching cannot change a path.
///
/// Throws InputError for limits out of range, or if no rate bounds the motion (none is given, or
/// those given are of derivatives that are zero all along).
double least_stretch(const Trajectory& motion, const Limits& limits);

/// The same for axes that go together: the least k for all. Spans of equal size.
double least_stretch(std::span<const Trajectory> axes, std::span<const Limits> limits);

/// The motion stretched by least_stretch about its start, which stays.
Trajectory retimed(const Trajectory& motion, const Limits& limits);

}  // namespace jounce
