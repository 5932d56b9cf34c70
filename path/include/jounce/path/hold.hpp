// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"

namespace jounce {

/// Holds and resumes a plan (MC_GroupHalt, MC_GroupInterrupt and MC_GroupContinue of the PMC600;
/// HaltGroup and ResumeGroup of HIMC).
///
///     const Plan held = halted(motion, 1.2);        // follows motion until 1.2 s, then rests
///     const Plan rest = resumed(motion, held);      // from this rest to the end of the path
///
/// halted() returns the plan until time t (s), followed by the earliest rest on the path within the
/// limits. The result has a station law (docs/path/README.md). Stations are rests, corners, and
/// changes of the limits along the path. The axes slow down on all pieces except corners. They pass
/// a corner at constant velocity, because the limits permit no deceleration there. Exception: they
/// also slow down within chains of turns. If the plan itself rests earlier, the result rests where
/// the plan rests. After t, no station is passed faster than in the plan. On averages and splines
/// with a window law, the plan continues to its next rest. Throws InputError "t" outside [0,
/// duration].
Plan halted(const Plan& plan, double t);

/// Returns the motion from the rest at the end of `held` to the end of `plan`, with the remaining
/// dwells. Requires that `held` is a result of halted(plan, ...). No station is passed faster than
/// in the plan. Throws InputError "held" if `held` ends at the end of the plan.
Plan resumed(const Plan& plan, const Plan& held);

/// Plans the rest of a path from rest at the path position q = `from`, for example after a retreat.
/// Within a corner, the law begins slowly, within the limits. A window law is replaced by a station
/// law. Throws InputError "from" outside [0, length).
Plan resumed(const Plan& plan, double from);

/// Plans a retreat: a motion from the rest at the end of `held` back along the path to the path
/// position q = `to`. The result has the same path in the opposite direction; its q counts from the
/// end. Acceleration and deceleration have the same limit: the lower of the plan's two limits. The
/// retreat rests at every place where the plan rests; it may end within a corner. Throws InputError
/// "to" outside [0, q at the end of `held`).
Plan retreated(const Plan& plan, const Plan& held, double to);

}  // namespace jounce
