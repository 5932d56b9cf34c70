// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/path/plan.hpp"

namespace jounce {

/// Returns the plan with a faster timing law, or the same plan if no faster law is found. The path,
/// its corners, rests and dwells stay the same.
///
///     const Plan motion = refined(plan(butterfly, limits));   // jounce optimize uses this
///
/// plan() makes timing laws of ramps that use fixed shares of the limits. A refined law has phases
/// of constant jerk, a few for each piece of the path. It is the solution of a convex problem
/// (docs/path/README.md, "Refinement"), stretched over time until the exact extrema of all axes are
/// within their limits. So the guarantees of Plan also hold for the result. In a refined law, the
/// velocity along a corner may vary.
///
/// Other functions treat a refined law like a window law: halted() (hold.hpp) follows it to its
/// next rest, and played() (override.hpp) replaces it by a station law. A *run* is a part of the
/// path from rest to rest. The longest runs are refined first. At most 500 short runs or 13 very
/// long runs are refined. A run of more than about 1250 corners or 120 000 pieces of an average
/// keeps its law. CPU time for a run of 2000 pieces: about 1 s. The result is deterministic.
Plan refined(const Plan& plan);

}  // namespace jounce
