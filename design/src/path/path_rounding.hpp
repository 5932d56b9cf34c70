// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce::design_detail {

/// Marks broken findings of check() and check_continuity() as kept if rounding of the curve's
/// coefficients explains them. The axes of a path have very short segments at large coordinates: an
/// error of eps |f| in a coefficient is an error of eps |f| d^k / L^k in the k-th derivative of a
/// segment of length L and degree d.
void discount_rounding(const Trajectory& curve, Report& report);

}  // namespace jounce::design_detail
