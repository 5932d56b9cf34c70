// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimize/src/knots/stage.hpp"

namespace jounce::optimizer {

/// What no choice of the free quantities within the ceilings of a stage has less of, where the stage is
/// convex; close if z is the best choice. By weak duality over tangents at z: samples of derivatives are
/// linear in the free quantities, the rms is above its tangent.
double convex_bound(const Stage& stage, const Point& z);

}  // namespace jounce::optimizer
