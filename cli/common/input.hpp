// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"

namespace jounce::cli {

/// Calls read_inputs(). Returns all axes, or only the axis of this name if `axis` is not empty. Throws InputError for
/// --axis.
std::vector<Input> load_axes(const std::string& path, const std::string& axis = "",
                             bool decimal_comma = false);

/// The same; with `machine`, the path is a G-code program for this path spec (gcode_inputs()).
std::vector<Input> load_program(const std::string& path, const std::string& machine,
                                const std::string& axis);

/// The same for verbs that take one axis. Throws InputError if there are several and none is
/// named.
Input load(const std::string& path, const std::string& axis = "", bool decimal_comma = false);
Input load_program_axis(const std::string& path, const std::string& machine,
                        const std::string& axis);

/// Calls over() of design/over_time.hpp for each input. Throws InputError for --over.
std::vector<Input> over(const std::string& what, std::vector<Input> all);

/// Returns the only one of the axes of a file. Throws InputError for --axis if there are several.
Input only_one(std::vector<Input> all, const std::string& path);

/// The only axis of the file, or the axis with the name of `input`.
Input load_beside(const std::string& path, const Input& input, const std::string& machine = "");

}  // namespace jounce::cli
