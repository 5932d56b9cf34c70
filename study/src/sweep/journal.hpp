// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jounce {

/// Lines of text that survive their writer: appended one by one, each with a checksum.
///
///     Journal journal("results.csv.journal", identity);
///     for (const std::string& line : journal.lines()) ...      // of a run before, if any
///     journal.append("17 0 3.5");
///
/// The first line of the file is its heading. Each line goes to the system in one piece, so a
/// killed process loses no line for which append() has returned; a power failure may lose the last
/// ones. Lines that do not match their checksum are skipped, an incomplete last line is removed.
///
/// Throws InputError (the file as document) for a file that is not a journal, or a journal with
/// another identity, and if another process has it open; std::system_error if the system reports an
/// error.
class Journal {
 public:
  /// Opens or creates the file. `identity`: one word; a journal with another one is refused.
  Journal(const std::string& path, const std::string& identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  void append(const std::string& line);  ///< without a line break in it

 private:
  void read(const std::string& identity);

  std::string path_;
  int file_ = -1;
  std::vector<std::string> lines_;
};

}  // namespace jounce
