// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Margins of all segments of a curve to one limit. (check() returns only the least margin of a
/// limit that is satisfied.) A limit of velocity, acceleration or jerk gives two objects with the
/// same rule: one for the positive and one for the negative direction.
struct LimitMargin {
  std::string rule = {};              ///< text of the rule, as in a Finding: "limit/velocity"
  std::vector<double> segments = {};  ///< margin of each segment; defined in Finding::margin
};

/// Returns the margins of a curve to its limits, in the order of the members of Limits. Exact, like
/// check(). Throws InputError like require_valid().
template <class Over>
std::vector<LimitMargin> limit_margins(const Curve<Over>& f, const Limits& limits);

}  // namespace jounce
