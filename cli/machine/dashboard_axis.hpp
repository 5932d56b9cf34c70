// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cli/machine/dashboard.hpp"

namespace jounce::cli {

/// The line of an axis in the list of all.
Row listed(const Watched& axis, const View& view, bool chosen);

/// All rows of one axis.
std::vector<Row> details(const Watched& axis, const View& view);

}  // namespace jounce::cli
