// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimize/src/knots/subproblem.hpp"

namespace jounce::optimize_detail {

/// Returns a lower bound of the objective for all values of the free quantities within the ceilings
/// of a subproblem, which must be convex. The bound is close if z is the best point. It follows by
/// weak duality from the tangents at z: samples of derivatives are linear in the free quantities,
/// and the rms is above its tangent.
double convex_bound(const Subproblem& subproblem, const Point& z);

}  // namespace jounce::optimize_detail
