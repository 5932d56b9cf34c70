// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Prints a line to standard error. A terminal that takes no text, and one that is closed, do not hold up the
/// program or end it: then the line is dropped.
void print_notice(const std::string& notice);

}  // namespace jounce
