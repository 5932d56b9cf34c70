// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// One column of points, with the name and the unit from the header.
struct PointColumn {
  std::string name = {};            ///< lower case: "time", "position", "geo_velocity", "type"
  std::string unit = {};            ///< "" if the header has no unit
  std::vector<double> values = {};  ///< numbers of the column
  /// Cells of a column of words, such as "type"; `values` is then empty.
  std::vector<std::string> words = {};
  /// For each point, the character of its line at which the cell begins, from 1; 0 beyond the
  /// character 65535. Empty for a workbook.
  std::vector<std::uint16_t> characters = {};
};

/// Points from a spreadsheet, a measuring device or another program: CSV, or a sheet of a workbook
/// (.xlsx), with a header that names the columns and their units.
///
///     time [ms]; position [mm]; type
///     0;         0;             normal
///     16;        0,25;          even
///
/// **Header**: a unit is in brackets or parentheses after the name, after " / ", after " in ", or
/// in a line of units under the names. Signs such as `µm`, `°/s` and `mm/s²` are accepted. A first
/// line with one text only is a title, and ignored.
///
/// **Separator**: the character in a first line such as `sep=;`; otherwise a semicolon if the
/// header contains one, then a tab, then a comma. **Decimals**: a point. A decimal comma is
/// accepted if no number of the file has a point, and if the separator is not a comma or the cell
/// is in quotes. **Ignored**: empty lines, lines of separators only, separators at the end of all
/// lines, lines that begin with `#`, spaces and quotes around cells, and the byte order mark of a
/// file.
///
/// **Workbooks** of the Office Open XML format: the first sheet that is not empty, or the sheet
/// `Cam` of the path `cams.xlsx#Cam`. The header is the first row with two texts or more. Columns
/// without a name are ignored. The line of a point is its row. An error names the sheet and the
/// cell.
///
/// The whole file is read, or InputError is thrown with file, line, character, key (the name of the
/// column), value and rule. Errors are: a missing header, a repeated name, an unknown unit, a row
/// of another length, an empty cell or text that is not a finite number (except in the column
/// `type`), decimal commas together with points, and a file without points; in a workbook also a
/// date, an error value, and a formula without a stored value.
struct Points {
  std::string document = {};              ///< name of the file
  std::vector<PointColumn> columns = {};  ///< the columns, in the order of the file
  std::uint32_t header = 1;               ///< line of the header in the file
  std::vector<std::uint32_t> lines = {};  ///< for each point, its line in the file

  /// Number of points.
  [[nodiscard]] std::size_t size() const { return lines.size(); }
  /// Returns the column of this name; null if the file has no such column.
  [[nodiscard]] const PointColumn* find(std::string_view name) const;
  /// Gives a column a wanted name if no other column has a known synonym of this name: the column
  /// "MasterPos" becomes "master", "Zeit" becomes "time". `wanted`: all columns that the caller
  /// reads.
  void name_columns(std::span<const std::string> wanted);
  /// Returns the values of a column in `unit`. If the header has no unit, the values are assumed to
  /// be in `unit`. Throws InputError with file and line if the file has no such column, or if its
  /// unit does not convert.
  [[nodiscard]] std::vector<double> in_unit(std::string_view name, const std::string& unit) const;
  /// Returns the error of a cell, with file, line and character. `point` counts from 0; `name` is
  /// the name of a column.
  [[nodiscard]] InputError error(std::size_t point, const std::string& name,
                                 const std::string& value, const std::string& rule) const;
  /// Like error() above, for a number in `unit` ("": no unit).
  [[nodiscard]] InputError error(std::size_t point, const std::string& name, double value,
                                 const std::string& unit, const std::string& rule) const;
};

/// Returns the bytes of a file of points, for parse_points(). The path may name a sheet.
std::string point_file_bytes(const std::string& path);
/// Read points from a file, and from the bytes of a file with the name `document`: CSV or a
/// workbook.
Points read_points(const std::string& path);
Points parse_points(std::string_view text, const std::string& document);

/// True if the text begins like points: two or more columns, whose names consist of letters, `_`
/// and spaces.
bool begins_as_points(std::string_view text);

}  // namespace jounce
