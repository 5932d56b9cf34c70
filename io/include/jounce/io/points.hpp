// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jounce {

/// One column of points: its name and unit from the header.
struct PointColumn {
  std::string name;  ///< lower case: "time", "position", "geo_velocity", "type"
  std::string unit;  ///< "" if the header has none
  std::vector<double> values = {};
  std::vector<std::string> words =
      {};  ///< cells of a column of words, such as "type"; `values` is then empty
};

/// Points as a spreadsheet, a measuring device or another program writes them: CSV with a header that
/// names columns and units.
///
///     time [ms]; position [mm]; type
///     0;         0;             normal
///     16;        0,25;          even
///
/// **Separators**: comma, semicolon or tab, whichever the header has. **Decimals**: a point; or a
/// comma, if it cannot be a separator (semicolons, tabs) and no number of the file has a point.
/// **Ignored**: empty lines, lines that begin with `#`, spaces around cells, a byte order mark.
///
/// Reads all or nothing: throws InputError with file, line, key (the column's name), value and rule
/// for a missing header, a name twice, an unknown unit, a row of another length, an empty cell,
/// text that is not a finite number, decimal commas together with points, and a file without
/// points.
struct Points {
  std::string document;
  std::vector<PointColumn> columns;
  std::vector<std::uint32_t> lines;  ///< lines of the document, for each point

  [[nodiscard]] std::size_t size() const { return lines.size(); }
  /// The column of that name, or nullptr.
  [[nodiscard]] const PointColumn* find(std::string_view name) const;
  /// Its values in `unit` (a header without a unit is assumed to use it). Throws InputError,
  /// placed, if there is no such column or its unit does not convert.
  [[nodiscard]] std::vector<double> in_unit(std::string_view name, const std::string& unit) const;
};

Points read_points(const std::string& path);
Points parse_points(std::string_view text, const std::string& document);

/// True if the text begins like points: two or more columns, each named by letters.
bool begins_as_points(std::string_view text);

}  // namespace jounce
