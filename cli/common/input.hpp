// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"

namespace jounce::cli {

/// Reads a spec, a table file or another maker's (see exchange.hpp), recognized by the content; "-"
/// is standard input. One input for each axis; only the one named if `axis` is not empty.
std::vector<Input> load_axes(const std::string& path, const std::string& axis = "",
                             bool decimal_comma = false);

/// The same; with `machine`, the path is a G-code program for this path spec (gcode_inputs()).
std::vector<Input> load_program(const std::string& path, const std::string& machine,
                                const std::string& axis);

/// The same for verbs that take one axis. Throws InputError where there are several and none is
/// named.
Input load(const std::string& path, const std::string& axis = "", bool decimal_comma = false);
Input load_program_axis(const std::string& path, const std::string& machine,
                        const std::string& axis);

/// The counterpart of an input: the only axis of the file, or that of the same name.
Input load_beside(const std::string& path, const Input& input);

}  // namespace jounce::cli
