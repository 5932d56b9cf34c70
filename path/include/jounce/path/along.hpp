// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Checks the motion of a plan along its path against the limits of the path and of the commands.
///
///     const Report report = check_along(motion);          // "limit/normal_acceleration", at 1.2 s
///
/// It checks velocity, acceleration, deceleration and jerk along the path, and the normal and the
/// total acceleration. For each limit of the path there is one finding, at its worst place. A limit
/// of a command gives a finding only if it is broken; the finding names the source line. A limit is
/// broken if it is exceeded by more than 1e-12 of it.
///
/// The extrema are exact on lines, arcs and turns. On blends, the normal and the total acceleration
/// are upper bounds from the derivatives of the whole piece; on curves, the velocity as well.
///
/// `feed_factor`: the greatest factor of an override, which multiplies the feeds of the commands.
Report check_along(const Plan& plan, double feed_factor = 1);

}  // namespace jounce
