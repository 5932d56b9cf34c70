// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/detail/diagnostic.hpp"

namespace jounce {

/// Returns the findings of an input with their places in the file `file`. The place of a finding on
/// a segment is the TOML table of the segment. The place of any other finding is the key of its
/// limit or the section of its rule. In a G-code program, the place is the line. If the input is a
/// table, the findings have no places.
std::vector<Diagnostic> diagnostics_of(const Report& report, const Input& input,
                                       const std::string& file);
/// Returns the diagnostics for a spec that does not describe a motion.
std::vector<Diagnostic> diagnostics_of(const Report& report, const Spec& spec,
                                       const std::string& file);

}  // namespace jounce
