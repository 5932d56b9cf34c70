// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "edit/src/editable.hpp"

namespace jounce::edit_detail {

/// Returns the times at which all axes pass the points in turn, at joints of their curves. A point
/// has a position for each axis. Ends at the first point that they do not pass.
std::vector<double> passing_times(const std::vector<const LazyCurve::Any*>& curves,
                                  const std::vector<std::vector<double>>& points);

/// Returns the position of an axis at this x.
double position_at(const LazyCurve::Any& curve, double x);

}  // namespace jounce::edit_detail
