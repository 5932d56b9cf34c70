// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Prints a line to standard error. If the terminal takes no text, or is closed, the line is
/// dropped; the program neither waits nor ends.
void print_notice(const std::string& notice);

}  // namespace jounce
