// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/report/report_text.hpp"

namespace jounce::lint_detail {

/// Returns "3.5 mm"; "3.5" without a unit.
inline std::string with_unit(double value, const std::string& unit) {
  return rounded(value) + (unit.empty() ? "" : " " + unit);
}

}  // namespace jounce::lint_detail
