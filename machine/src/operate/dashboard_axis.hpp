// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/machine/detail/dashboard.hpp"

namespace jounce::machine_detail {

/// Returns the row of an axis in the list of all axes.
dashboard::Row listed(const dashboard::Watched& axis, const dashboard::View& view, bool chosen);

/// Returns all rows of one axis.
std::vector<dashboard::Row> details(const dashboard::Watched& axis, const dashboard::View& view);

}  // namespace jounce::machine_detail
