// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"

namespace jounce {

/// Jog of a group along a line (SMC_GroupJog of PMC600, JogGroup of HIMC): from rest at `from` towards `direction` at
/// `velocity` u/s, until the button is released after `duration` s; then to rest. All axes stay on the line and within
/// their limits; the velocity is lower if an axis permits no more. `direction` has any length: for a jog in a
/// frame it is the column of that axis in the frame's rotation, so { cos a, sin a } for x of a frame turned by a.
///
///     const Plan jog = jogged({}, {1, 1}, 50, 0.8, limits);      // 45 degrees
///
/// Throws InputError "direction" for zero, "velocity" and "duration" unless they are positive, and as plan() does.
Plan jogged(const Point& from, const Point& direction, double velocity, double duration,
            const GroupLimits& limits);

}  // namespace jounce
