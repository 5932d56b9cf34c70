// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Margin of each segment of a curve to one bound: check() gives the least margin of a limit,
/// these are all of them. A limit of a rate has two bounds, and so two of these with the same rule.
struct LimitMargin {
  std::string rule;              ///< the text of the rule of a Finding
  std::vector<double> segments;  ///< margin of each segment, as in Finding
};

/// Margins of a curve under its limits, in the order of the limits. Exact, like check(). Throws
/// InputError like require_valid(Limits).
template <class Over>
std::vector<LimitMargin> limit_margins(const Curve<Over>& f, const Limits& limits);

}  // namespace jounce
