// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// "3.5 mm", or "3.5" without a unit.
std::string with_unit(double value, const std::string& unit);

}  // namespace jounce
