// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// The standard streams of a program.
namespace jounce {

/// Opens /dev/null for each standard stream that the caller has closed: a file that is opened later
/// must not get its number.
void open_standard_streams();

/// Writes the rest of standard output. Returns the error of the system, such as that of a full
/// disk, or "". A reader that has closed its pipe is no error.
std::string flush_standard_output();

}  // namespace jounce
