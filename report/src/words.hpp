// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Returns "3.5 mm"; "3.5" without a unit.
std::string with_unit(double value, const std::string& unit);

}  // namespace jounce
