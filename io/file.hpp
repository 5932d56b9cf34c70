#pragma once

#include <string>

namespace jounce {

/// The whole file as bytes; "-" is standard input. A file that cannot be read is an InputError with
/// its name as document.
std::string read_file(const std::string& path);

/// Writes the whole file or nothing: to a temporary name in the same folder, then renamed. "-" is
/// standard output. Throws std::system_error where the machine refuses (no folder, no space).
void write_file(const std::string& path, const std::string& bytes);

}  // namespace jounce
