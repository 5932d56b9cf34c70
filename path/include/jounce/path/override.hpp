// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/path/plan.hpp"
#include "jounce/profiles/sequences/override.hpp"

namespace jounce {

/// The motion of a plan under an override, on the same path (MC_GroupSetOverride and VelRatio of PMC600,
/// SetGrpVelScale of HIMC). Factors are 0 to 2, and 1 before the first request. overridden() plays any motion by a
/// clock instead; its ramps use only what the motion leaves of the limits, and a plan at full speed leaves nothing
/// while it accelerates.
///
///     const FactorRequest steps[] = {{0.2, 1.5}, {0.6, 0}, {1.2, 1}};     // faster, hold, resume
///     const Plan motion = played(plan(program, limits), steps);
///
/// **Velocity.** Up to 1 a factor multiplies the full speed of each piece: the least of its feed, the limit of the
/// path, and the limits of its axes. Above 1 it multiplies the feed; the limits stay. A corner keeps its own velocity
/// where that is lower. Factor 0 holds: rest on the path until a step to another factor; without one the motion ends
/// there. Dwells keep their durations.
///
/// **Limits.** A step is no step of the velocity: the law changes over by a ramp within the limits of acceleration
/// and jerk, in corners behind their end, because a corner is passed at constant velocity. A ramp towards a velocity
/// that the new factor exceeds or falls below ends first, or is left with the greatest jerk, whichever follows the
/// factor sooner. Before the first step with another factor than 1 the motion is that of the plan.
///
/// Runs by the law of a window (Plan) are planned again by the law of stations, from their start, if a step
/// falls within the duration of the plan.
///
/// Throws InputError "override[k].time" for times that do not ascend or are negative, "override[k].factor" for one
/// outside 0 to 2. The corners() of the result are those of the plan; velocity as it is played.
Plan played(const Plan& plan, std::span<const FactorRequest> steps);

}  // namespace jounce
