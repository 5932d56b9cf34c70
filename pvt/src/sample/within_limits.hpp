// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/limits/ramped_limits.hpp"
#include "jounce/pvt/table.hpp"

#include "pvt/src/sample/interval.hpp"

namespace jounce::pvt_detail {

/// The knots, and more where a table of them exceeds a limit that the curve satisfies (see
/// within_limits.cpp). No interval becomes shorter than `spacing`.
template <class Over>
std::vector<Knot> knots_within_limits(const Curve<Over>& f, Interpolation rule,
                                      const Limits& limits, const RampedLimits& ramped,
                                      const std::vector<Knot>& knots, double spacing = 0);

}  // namespace jounce::pvt_detail
