// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"

namespace jounce {

/// Returns the plan with a faster timing law, or the plan itself if no faster law is found. Path,
/// corners, rests and dwells stay the same.
///
///     const Plan motion = refined(plan(butterfly, limits));   // jounce optimize uses this
///
/// The laws of plan() are made of ramps with fixed shares of the limits. A refined law has phases
/// of constant jerk, a few for each piece of the path. It is the solution of a convex problem
/// (docs/path/README.md, "Refinement"), stretched over time until the exact extrema of all axes are
/// within their limits. So the guarantees of Plan hold. The velocity along a corner then varies.
///
/// Other functions treat a refined law like the law of a window: halted() follows it to its next
/// rest, and played() plans it again by stations. The longest runs are refined first, within a
/// budget for about 500 short or 13 very long runs. A run of more than about 1250 corners or
/// 120 000 pieces of an average keeps its law. CPU time: about 1 s for a run of 2000 pieces.
/// Deterministic.
Plan refined(const Plan& plan);

}  // namespace jounce
