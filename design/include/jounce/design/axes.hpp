// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"

/// A choice among the axes of a file. `path` is its name; "-" is standard input.
namespace jounce {

/// The input of this axis, or all if the name is empty. Throws InputError (key "axis") if no axis,
/// or more than one, has the name.
std::vector<Input> axes_named(std::vector<Input> all, const std::string& axis,
                              const std::string& path);

/// The only input. Throws InputError (key "axis") if there are several.
Input only_axis(std::vector<Input> all, const std::string& path);

}  // namespace jounce
