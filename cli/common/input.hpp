// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"

namespace jounce::cli {

/// read_inputs(); only the input of the axis that `axis` names, if it is not empty. Throws InputError for --axis.
std::vector<Input> load_axes(const std::string& path, const std::string& axis = "",
                             bool decimal_comma = false);

/// The same for verbs that take one axis. Throws InputError where there are several and none is
/// named.
Input load(const std::string& path, const std::string& axis = "", bool decimal_comma = false);

/// The counterpart of an input: the only axis of the file, or that of the same name.
Input load_beside(const std::string& path, const Input& input);

}  // namespace jounce::cli
