// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// Severity of a statement about a file.
enum class Level : std::uint8_t {
  good,     ///< a limit that holds
  note,     ///< a fact
  warning,  ///< allowed, but perhaps not intended
  broken,   ///< a limit is broken: exit status 1
  error,    ///< the file is wrong: exit status 2
};

/// "ok", "note", "warning", "error": for machines, a broken limit is an error as well.
const char* severity(Level level) noexcept;

/// A place in a file. Line and column count from 1, the column in characters; 0: unknown.
struct FilePlace {
  std::string file = {};
  int line = 0;
  int column = 0;
};

/// One statement about a file with its place, for CI systems and editors: a finding of a check, an error of the input,
/// or a difference from an accepted version.
struct Diagnostic {
  std::string rule;  ///< "limit/geo_velocity", "input/key": `jounce explain RULE` has its meaning
  Level level = Level::note;
  FilePlace place;
  FilePlace limit_place = {};  ///< key that sets the limit; no file: none
  std::string key = {};        ///< key at the place: "segment[2]", "limits.velocity"
  std::string axis = {};       ///< axis, or the part that was checked; may be empty
  std::string segment = {};    ///< "3 return"; may be empty
  std::string message = {};    ///< one sentence, without the place
  std::string advice = {};     ///< may be empty
  std::string quantity = {};
  std::string unit = {};  ///< unit of value and limit
  std::optional<double> value = {};
  std::optional<double> limit = {};
  std::optional<double> margin = {};  ///< share of the limit; below 0: broken
  std::optional<double> where = {};   ///< position on the axis of the curve
  std::string where_unit = {};
};

/// Result of one file: its statements, the worst first.
struct FileResult {
  std::string file;
  std::string kind = {};  ///< "cam", "table", "machine", ...; empty if the file could not be read
  std::vector<Diagnostic> diagnostics = {};

  [[nodiscard]] std::size_t count(Level level) const;
  /// Worst level; Level::good without statements.
  [[nodiscard]] Level worst() const;
};

/// Result of `jounce check` or `jounce validate` for many files.
struct RunResult {
  std::string verb;  ///< "check"
  std::vector<FileResult> files;

  [[nodiscard]] std::size_t count(Level level) const;
  /// Exit status: 2 if a file is wrong, 1 if a limit is broken, otherwise 0; `strict` counts a warning as a broken
  /// limit.
  [[nodiscard]] int status(bool strict = false) const;
};

/// All errors of a file, in the order of the document: rule "input/file" for the file as a whole, otherwise
/// "input/key". `file` is the name for an error without one.
std::vector<Diagnostic> diagnostics_of(const InputError& error, const std::string& file);

/// Puts the worst first; the order is otherwise kept.
void sort(std::vector<Diagnostic>& diagnostics);

}  // namespace jounce
