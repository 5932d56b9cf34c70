// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/path/plan.hpp"
#include "jounce/profiles/sequences/override.hpp"

namespace jounce {

/// Returns the motion of a plan under an override, on the same path (MC_GroupSetOverride and
/// VelRatio of the PMC600, SetGrpVelScale of HIMC). Factors are 0 to 2. Before the first request
/// the factor is 1.
///
/// overridden() in jounce/profiles/sequences/override.hpp plays any motion by a clock instead. Its
/// ramps can use only the margin between the motion and the limits, and a plan that accelerates at
/// full rate has no margin.
///
///     const FactorRequest steps[] = {{0.2, 1.5}, {0.6, 0}, {1.2, 1}};     // faster, hold, resume
///     const Plan motion = played(plan(program, limits), steps);
///
/// **Velocity.** A factor of up to 1 multiplies the full speed of each piece: the least of its
/// feed, the limit of the path, and the limits of its axes. A factor above 1 multiplies the feed;
/// the limits stay. A corner that the plan passes at a lower velocity keeps that velocity. Factor 0
/// holds the motion on the path until a request for another factor; if there is none, the motion
/// ends there. Dwells keep their durations.
///
/// **Limits.** The velocity does not step at a request: a ramp within the limits of acceleration
/// and jerk follows, in a corner after its end, because a corner is passed at constant velocity. A
/// ramp in progress whose target velocity no longer agrees with the new factor ends first, or ends
/// early with the greatest jerk, whichever is faster. Before the first request with a factor other
/// than 1, the motion is that of the plan.
///
/// Runs with the law of a window (docs/path/README.md) are planned again by the law of stations,
/// from their start, if a request falls within the duration of the plan.
///
/// Throws InputError "override[k].time" if times do not ascend or are negative, and
/// "override[k].factor" for a factor outside 0 to 2. In corners() of the result, the velocity is
/// the one that is played; all other values are those of the plan.
Plan played(const Plan& plan, std::span<const FactorRequest> steps);

}  // namespace jounce
