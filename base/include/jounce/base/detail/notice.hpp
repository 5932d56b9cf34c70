// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Prints a line to standard error. If the terminal accepts no text, or is closed, the line is
/// dropped; the function neither waits nor ends the program.
void print_notice(const std::string& notice);

}  // namespace jounce
