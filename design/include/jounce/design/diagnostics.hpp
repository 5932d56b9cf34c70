// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/diagnostic.hpp"

namespace jounce {

/// Returns the findings of an input with their places in its file. A finding of a segment is placed
/// at the TOML table of the segment, any other finding at the key of its limit or at the section of
/// its rule. A finding in a G-code program is placed at its line. If the input is a table, there
/// are no places. `file` is the name of the file.
std::vector<Diagnostic> diagnostics_of(const Report& report, const Input& input,
                                       const std::string& file);
/// Returns the diagnostics for a spec that does not describe a motion.
std::vector<Diagnostic> diagnostics_of(const Report& report, const Spec& spec,
                                       const std::string& file);

}  // namespace jounce
