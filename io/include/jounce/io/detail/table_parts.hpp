// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "jounce/base/detail/listed.hpp"
#include "jounce/io/table_file.hpp"

/// Parts that the formats of a table share.
namespace jounce::io_detail {

inline constexpr int schema_version = 1;  ///< version of the table format
/// The values of Domain that a file can contain.
inline constexpr std::array axes{Domain::time, Domain::master};
/// The interpolation rules that a file can contain.
inline constexpr std::array rules{Interpolation::linear, Interpolation::cubic_hermite,
                                  Interpolation::quintic_hermite};
/// The policies outside that a file can contain.
inline constexpr std::array policies{Extrapolation::refuse, Extrapolation::hold,
                                     Extrapolation::wrap, Extrapolation::advance};

/// The parts of a table file, before they are combined and the hash is compared.
struct TableParts {
  Domain axis = Domain::time;
  Interpolation rule = Interpolation::linear;
  Extrapolation outside = Extrapolation::hold;
  Units units;
  Columns columns;
  std::string sha256;
  Provenance provenance;
  int line_before_knots = 0;  ///< number of the line before the knots; 0 in JSON
};

/// Returns the names of the columns of a rule: "time", "position", "velocity", ...
std::vector<std::string> column_names(Domain axis, Interpolation rule);

/// Copies the unit of a column into the parts. Returns the rule that the unit breaks, or "".
std::string take_unit(TableParts& parts, std::size_t column, const std::string& unit);

/// Returns the value of `all` that has this name. If there is none, calls fail(value, rule), which
/// must throw.
template <class T, std::size_t n, class Fail>
T choice(const std::string& text, std::span<const T, n> all, Fail fail) {
  const auto it =
      std::find_if(all.begin(), all.end(), [&](T value) { return text == name(value); });
  if (it != all.end()) return *it;
  fail('"' + text + '"', "must be one of " + listed(all, [](T value) { return name(value); }));
  return all.front();
}

/// Calls fail(value, rule) if the file has another version of the format.
template <class Fail>
void require_version(const std::string& version, Fail fail) {
  if (version != std::to_string(schema_version))
    fail(version, "must be " + std::to_string(schema_version) +
                      ", the format version that this program reads");
}

/// The properties of a table as texts: axis, rule, outside, x_unit, position_unit, sha256, spec,
/// spec_sha256, made_by.
using TableHead = std::map<std::string, std::string>;
/// Returns the properties of a table.
TableHead head_of(const TableFile& file);
/// Reads the properties; the result has no columns. `name`: name of the file for errors. Throws
/// InputError.
TableParts parts_of(const TableHead& head, const std::string& name);

/// Reads the parts from CSV, JSON, an LCM log or MCAP. `name`: name of the file for errors. Throws
/// InputError.
TableParts parse_csv(const std::string& text, const std::string& name);
TableParts parse_json(const std::string& text, const std::string& name);
TableParts parse_lcm_log(const std::string& text, const std::string& name);
TableParts parse_mcap(const std::string& text, const std::string& name);

/// True if the file is a table as an LCM log, or as MCAP.
bool is_lcm_log(const std::string& text);
bool is_mcap(const std::string& text);

}  // namespace jounce::io_detail
