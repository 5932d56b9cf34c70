#pragma once

#include <string>
#include <vector>

namespace jounce {

/// The whole file as bytes, without a byte order mark; "-" is standard input. A file that cannot be read is an InputError with
/// its name as document.
std::string read_file(const std::string& path);

/// A file to be written.
struct Output {
  std::string path;  ///< "-" is standard output
  std::string bytes;
};

/// Writes whole files or nothing: all of them to temporary names in their folders, then renamed.
/// What exists and is no regular file (a device, a pipe) is written to directly. Throws
/// std::system_error where the machine refuses (no folder, no space).
void write_files(const std::vector<Output>& files);
void write_file(const std::string& path, const std::string& bytes);

}  // namespace jounce
