// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jounce {

/// A file of lines to which each line is appended at once, with a checksum, so that an interrupted
/// run can continue.
///
///     Journal journal("results.csv.journal", identity);
///     for (const std::string& line : journal.lines()) ...      // of a run before, if any
///     journal.append("17 0 3.5");
///
/// The first line of the file is its heading. Each line is passed to the system as a whole, so a
/// process that is killed loses no line for which append() has returned; a power failure may lose
/// the last ones. Lines with a wrong checksum are skipped, and an incomplete last line is removed.
///
/// Throws InputError (with the file as document) for a file that is not a journal, for a journal
/// with another identity, and if another process has the file open. Throws std::system_error if the
/// system reports an error.
class Journal {
 public:
  /// Opens the file, or creates it. `identity`: one word; it must equal the identity of the
  /// journal.
  Journal(const std::string& path, const std::string& identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The lines that were in the file when it was opened.
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  void append(const std::string& line);  ///< appends a line; it must not contain a line break

 private:
  void read(const std::string& identity);

  std::string path_;
  int file_ = -1;
  std::vector<std::string> lines_;
};

}  // namespace jounce
