// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "jounce/design/input.hpp"

/// Functions that select axes of a file. `path` is the name of the file for messages; "-" is
/// standard input.

namespace jounce {

/// Returns the input of this axis, or all inputs if the name is empty. Throws InputError (key
/// "axis") if no axis or more than one has this name.
std::vector<Input> axes_named(std::vector<Input> all, const std::string& axis,
                              const std::string& path);

/// Returns the only input. Throws InputError (key "axis") if there are several.
Input only_axis(std::vector<Input> all, const std::string& path);

/// Returns the name of the file of one axis, if each axis of a spec has its own file: feeder-x.csv
/// for feeder.csv.
std::string file_of_axis(const std::string& path, const std::string& axis);

/// Like file_of_axis() above, for a spec with this number of axes. If the number is 1, returns
/// `path`. Throws InputError, with `option` as its key, for standard output, which cannot have
/// several files.
std::string file_of_axis(const std::string& option, const std::string& path,
                         const std::string& axis, std::size_t axes);

}  // namespace jounce
