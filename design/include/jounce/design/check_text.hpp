// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"

namespace jounce {

/// The answer of `jounce check` for one axis: the verdict, the exact extrema of each segment, the findings, the rises
/// of a cam with their characteristic values, the fastest master, the cam switches.
std::string check_text(const Report& report, const Input& input);

/// The same as a JSON object, every number in full.
std::string check_json(const Report& report, const Input& input);

}  // namespace jounce
