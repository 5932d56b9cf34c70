// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"

namespace jounce {

/// Returns the output of `jounce design` for one axis: number of knots, error of the table against
/// the exact curve, residual vibration, the worst finding of `report`, and the hash of the table.
/// Requires a report of check_all() and add_not_limited(). If the report is not ok, the text states that the table is
/// nevertheless in `file`.
std::string design_text(const Input& input, const Report& report, const std::string& file = "-");

/// Returns the contents of design_text() as a JSON object; numbers have all their digits. `file` is
/// the name of the table.
std::string design_json(const Input& input, const Report& report, const std::string& file);

}  // namespace jounce
