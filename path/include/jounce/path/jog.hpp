// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"

namespace jounce {

/// Plans a jog of a group along a line (SMC_GroupJog of the PMC600, JogGroup of HIMC). The motion
/// begins at rest at `from` and runs in `direction` at `velocity` (u/s, where u is the axes' unit).
/// The button is released after `duration` (s); then the motion comes to rest. All axes stay on the
/// line and within their limits. If the limits do not permit the velocity, it is lower. `direction`
/// may have any length. To jog in a frame, use the column of the axis in the frame's rotation: {
/// cos a, sin a } for x in a frame that is rotated by a.
///
///     const Plan jog = jogged({}, {1, 1}, 50, 0.8, limits);      // 45 degrees
///
/// Throws InputError "direction" for a direction of zero, "velocity" or "duration" for a value that
/// is not positive, and like plan().
Plan jogged(const Point& from, const Point& direction, double velocity, double duration,
            const GroupLimits& limits);

}  // namespace jounce
