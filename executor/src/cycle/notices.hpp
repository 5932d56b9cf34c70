// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/axis/axis.hpp"

namespace jounce {

/// Returns the changes of an axis between two of its ticks as sentences: "started at tick 1600".
/// `unit`: unit of its positions.
std::vector<std::string> notices_of(const Tick& before, const Tick& now, const std::string& unit);

}  // namespace jounce
