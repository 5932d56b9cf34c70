// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"

namespace jounce {

/// Returns the output of `jounce check` for one axis: the verdict, the exact extrema of each
/// segment, and the findings; for a cam also its rises with their characteristic values, the
/// fastest master, and the cam switches.
std::string check_text(const Report& report, const Input& input);

/// Returns the contents of check_text() as a JSON object; numbers have all their digits.
std::string check_json(const Report& report, const Input& input);

}  // namespace jounce
