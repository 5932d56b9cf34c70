// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/report/comparison.hpp"

namespace jounce::cli {

constexpr const char* tolerance_help =
    "Differences up to this tolerance count as equal: a share of the range of each quantity "
    "(1e-6), or KEY=VALUE for one quantity (position=0.01); repeatable; default: rounding errors "
    "only";

/// The tolerance that the values of --tolerance give: `1e-6`, a share of every range; `position=0.01`;
/// `position="10 um"`. Throws InputError.
Tolerance tolerance_of(const std::vector<std::string>& texts, const Labels& labels);

}  // namespace jounce::cli
