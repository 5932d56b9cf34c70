// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// The motion of a plan along its path against the limits of the path and of the commands:
///
///     const Report report = check_along(motion);          // "limit/normal_acceleration", at 1.2 s, 3 % below
///
/// velocity, acceleration, deceleration and jerk of the law, the normal and the total acceleration. For each limit of
/// the path one finding, at its worst place; a limit of a command only where it is broken (the finding names the line).
/// On lines, arcs and turns, the extrema are exact. On blends, the normal and the total acceleration are upper bounds
/// from the derivatives of the whole piece; on curves, so is the velocity. A limit is broken if it is exceeded by more
/// than 1e-12 of it. An override multiplies the feeds of the commands: give its greatest factor as `feed_factor`.
Report check_along(const Plan& plan, double feed_factor = 1);

}  // namespace jounce
