// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/report/comparison.hpp"

namespace jounce::cli {

constexpr const char* tolerance_help =
    "Tolerance for equal values: a share of each range (1e-6), or KEY=VALUE for a "
    "quantity (position=0.01), repeatable; default: rounding only";

/// The tolerance that the values of --tolerance give: `1e-6`, a share of every range; `position=0.01`;
/// `position="10 um"`. Throws InputError.
Tolerance tolerance_of(const std::vector<std::string>& texts, const Labels& labels);

}  // namespace jounce::cli
