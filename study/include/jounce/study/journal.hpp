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
/// The first line of the file is its heading. Each line goes to the system in one piece, so
/// that a killed process loses none that append() returned from; a machine without power may lose the
/// last ones. Lines that do not match their checksum are left out, a torn last one is cut off.
///
/// Throws InputError (the file as document) for a file that is no journal or one of something else,
/// and where another process has it open; std::system_error where the machine refuses.
class Journal {
 public:
  /// Opens or makes the file. `identity`: one word; a journal of another is refused.
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
