// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// Severity of a diagnostic, in ascending order.
enum class Level : std::uint8_t {
  good,     ///< a satisfied limit
  note,     ///< a fact
  warning,  ///< permitted, but perhaps not intended
  broken,   ///< a limit is broken: exit status 1
  error,    ///< the file is invalid: exit status 2
};

/// Returns "ok", "note", "warning" or "error". A broken limit is an "error", too.
const char* severity(Level level) noexcept;

/// A place in a file.
struct FilePlace {
  std::string file = {};  ///< path of the file
  int line = 0;           ///< from 1; 0: unknown
  int column = 0;         ///< in characters, from 1; 0: unknown
};

/// One statement about a file, with its place, for CI systems and editors: a finding of a check, an
/// error in the input, or a difference from an accepted version.
struct Diagnostic {
  std::string rule = {};  ///< "limit/geo_velocity", "input/key"; `jounce explain RULE` prints its
                          ///< meaning
  Level level = Level::note;   ///< severity
  FilePlace place = {};        ///< the place to which the statement refers
  FilePlace limit_place = {};  ///< the key that sets the limit; an empty file: no such key
  std::string key = {};        ///< key at the place: "segment[2]", "limits.velocity"
  std::string axis = {};       ///< name of the axis, or of the part that was checked; may be empty
  std::string segment = {};    ///< number and name of the segment: "3 return"; may be empty
  std::string message = {};    ///< one sentence, without the place
  std::string advice = {};     ///< remedy; may be empty
  std::string quantity = {};   ///< the quantity: "geo_velocity"; may be empty
  std::string unit = {};       ///< unit of value and limit
  std::optional<double> value = {};   ///< the number that was found
  std::optional<double> limit = {};   ///< its limit
  std::optional<double> margin = {};  ///< margin as a share of the limit; below 0: broken
  std::optional<double> where = {};   ///< time or master position of the finding
  std::string where_unit = {};        ///< unit of `where`
};

/// The statements about one file, the worst first.
struct FileResult {
  std::string file = {};  ///< path of the file
  std::string kind = {};  ///< "cam", "table", "machine", ...; empty if the file could not be read
  std::vector<Diagnostic> diagnostics = {};  ///< the statements

  /// Returns the number of statements of this level.
  [[nodiscard]] std::size_t count(Level level) const;
  /// The worst level; Level::good if there are no statements.
  [[nodiscard]] Level worst() const;
};

/// The result of `jounce check` or `jounce validate` for many files.
struct RunResult {
  std::string verb = {};               ///< "check"
  std::vector<FileResult> files = {};  ///< result of each file
  /// Number of files for controllers in the given folders; these files are not examined.
  std::size_t skipped = 0;
  /// Number of G-code programs in the given folders; without a machine, they are not examined.
  std::size_t programs = 0;

  /// Returns the number of statements of this level, in all files.
  [[nodiscard]] std::size_t count(Level level) const;
  /// Returns the exit status: 2 if a file is invalid, 1 if a limit is broken, otherwise 0.
  /// `strict`: counts a warning as a broken limit.
  [[nodiscard]] int status(bool strict = false) const;
};

/// Returns all errors of a file, in the order of the document. The rule is "input/file" for an
/// error about the whole file, otherwise "input/key". `file` is the name of the file for errors
/// without a document.
std::vector<Diagnostic> diagnostics_of(const InputError& error, const std::string& file);

/// Sorts diagnostics: the worst level first; within a level, the order stays.
void sort(std::vector<Diagnostic>& diagnostics);

}  // namespace jounce
