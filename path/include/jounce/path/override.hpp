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
/// (overridden() in jounce/profiles/sequences/override.hpp can override any motion, by a clock. But
/// its ramps can use only the margin between the motion and the limits, and a plan that accelerates
/// at its limit has no margin.)
///
///     const FactorRequest steps[] = {{0.2, 1.5}, {0.6, 0}, {1.2, 1}};     // faster, hold, resume
///     const Plan motion = played(plan(program, limits), steps);
///
/// **Velocity.** A factor of up to 1 multiplies the full speed of each piece: the least of its
/// feed, the limit of the path, and the limits of its axes. A factor above 1 multiplies only the
/// feed, not the limits. A corner that the plan passes at a lower velocity keeps that velocity.
/// Factor 0 holds the motion on the path until a request for another factor; without such a
/// request, the motion ends at this rest. Dwells keep their durations.
///
/// **Limits.** The velocity does not step at a request; a ramp within the limits of acceleration
/// and jerk follows. For a request in a corner that is passed at constant velocity, the ramp begins
/// after the corner. If a new factor changes the target velocity of a ramp in progress, the ramp
/// either ends as planned or ends early with the greatest jerk, whichever is faster. Then the new
/// ramp begins. Before the first request with a factor other than 1, the motion follows the plan
/// unchanged.
///
/// Exception: if a request with a factor other than 1 falls within the duration of the plan, each
/// part from rest to rest that has a window law (docs/path/README.md) is planned again from its
/// start, with a station law.
///
/// In corners() of the result, the velocity is the velocity under the override; all other values
/// come from the plan. Throws InputError "override[k].time" if times are negative or do not ascend
/// (equal times are rejected), and "override[k].factor" for a factor outside 0 to 2.
Plan played(const Plan& plan, std::span<const FactorRequest> steps);

}  // namespace jounce
