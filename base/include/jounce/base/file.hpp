// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace jounce {

/// The whole file as bytes, without a byte order mark; "-" is standard input. Throws InputError with the
/// file's name as document for a file that cannot be read, for text in UTF-16 and for a compressed file.
std::string read_file(const std::string& path);

/// Remembers, while it lives, which files read_file() reads; write_files() then refuses to replace one of them: what is
/// made must not replace what it is made from. One at a time.
class KeptInputs {
 public:
  KeptInputs();
  ~KeptInputs();
  KeptInputs(const KeptInputs&) = delete;
  KeptInputs& operator=(const KeptInputs&) = delete;

 private:
  struct Files;
  std::unique_ptr<Files> files_;
  friend void require_not_read(const std::string& path, const std::string& option);
  friend std::string read_file(const std::string& path);
};

/// Throws InputError, of this option, for a file that KeptInputs remembers.
void require_not_read(const std::string& path, const std::string& option);

/// A file to be written.
struct Output {
  std::string path;  ///< "-" is standard output
  std::string bytes;
};

/// Writes whole files or nothing: all of them to temporary names in their folders, then renamed.
/// An existing file that is not regular (a device, a pipe) is written to directly. Throws
/// std::system_error where the machine refuses (no folder, no space), and what require_not_read() throws.
void write_files(const std::vector<Output>& files);
void write_file(const std::string& path, const std::string& bytes);

}  // namespace jounce
