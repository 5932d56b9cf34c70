// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce::pvt_detail {

/// The knots, and more where a table of them exceeds a limit that the curve satisfies (see
/// within_limits.cpp).
template <class Over>
std::vector<double> knots_within_limits(const Curve<Over>& f, Interpolation rule,
                                        const Limits& limits, const std::vector<double>& knots);

}  // namespace jounce::pvt_detail
