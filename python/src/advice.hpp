// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce::python {

/// Returns a message with the arguments of Python in place of the options of the command line.
std::string with_arguments(std::string message);

}  // namespace jounce::python
