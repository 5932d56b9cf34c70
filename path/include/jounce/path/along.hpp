// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Checks the motion of a plan along its path against the limits of the path and of the commands.
///
///     const Report report = check_along(motion);          // "limit/normal_acceleration", at 1.2 s
///
/// The function checks velocity, acceleration, deceleration and jerk along the path, and the normal
/// and the total acceleration. Each limit of the path has one finding, at its worst place. A limit
/// of a command has a finding only if the plan breaks it; the finding then has the source line. A
/// limit is broken if the plan exceeds it by more than 1e-12 of the limit.
///
/// The extrema are exact on lines, arcs and turns. On blends and curves, the normal and the total
/// acceleration are upper bounds, computed from the derivatives of the whole piece; on curves, the
/// velocity is an upper bound as well.
///
/// A limit of an axis in a command (PathSettings::axes) has a finding, too, if the plan breaks it
/// by more than rounding. `axis` of this finding is the number of the axis, from 1: first the axes
/// of the program, then the joints.
///
/// `feed_factor`: the greatest factor of an override, which multiplies the feeds of the commands.
Report check_along(const Plan& plan, double feed_factor = 1);

}  // namespace jounce
