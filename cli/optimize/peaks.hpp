// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

#include <nlohmann/json.hpp>

#include "jounce/spec/spec.hpp"

namespace jounce::cli {

/// Cost of an optimum: the peak of each derivative of each axis, given and optimized, with its change
/// and its limit. Without it, a lower peak acceleration hides a jerk that nothing limits.
void print_peaks(std::FILE* out, const Spec& given, const Spec& optimized);

/// The same as a list; `given` is null where the given spec makes no curve, `limit` where there is none.
nlohmann::ordered_json peaks_json(const Spec& given, const Spec& optimized);

}  // namespace jounce::cli
