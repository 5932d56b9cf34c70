// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"

namespace jounce {

/// Hold and resume as functions of a plan (MC_GroupHalt, MC_GroupInterrupt and MC_GroupContinue of PMC600;
/// HaltGroup and ResumeGroup of HIMC).
///
///     const Plan held = halted(motion, 1.2);        // as motion up to 1.2 s, then to rest on the path
///     const Plan rest = resumed(motion, held);      // from there at rest to the end
///
/// The same plan up to `t`, then the earliest rest on the path within the limits, by the law of stations: a corner
/// is passed at constant velocity, since it has no share of the limits left for a deceleration; every other piece
/// is used to slow down. Where the plan itself rests before that, it is kept. No station behind `t` is passed
/// faster than in the plan. On averages and splines that run by the law of a window the plan goes on to its next
/// rest. Throws InputError "t" outside [0, duration].
Plan halted(const Plan& plan, double t);

/// Continues from the rest at the end of `held`, which `halted` made of `plan`, to the end of the
/// plan, with the remaining dwells. No station is passed faster than in the plan. Throws InputError
/// "held" if `held` already ends at the end of the plan.
Plan resumed(const Plan& plan, const Plan& held);

/// The same from rest at q = `from`, for example behind a retreat. Throws InputError "from" outside [0, length),
/// and in a corner.
Plan resumed(const Plan& plan, double from);

/// A retreat: moves from the rest at the end of `held` back along the path to q = `to`. The result has the same path in
/// the other direction: its q counts from the end. Acceleration and deceleration are both the lower of the two of the
/// plan. It rests where the plan rests. Throws InputError "to" outside [0, the held place), and in a corner: it is
/// passed at constant velocity.
Plan retreated(const Plan& plan, const Plan& held, double to);

}  // namespace jounce
