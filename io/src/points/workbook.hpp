// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Workbooks of the format Office Open XML (ECMA-376 part 1, 18: SpreadsheetML): zip archives of XML
/// parts.
namespace jounce::io_detail {

/// Type of a cell's value.
enum class CellType {
  number,   ///< number, as the file writes it
  text,     ///< text
  date,     ///< number in a format of dates or times
  error,    ///< error value, such as #DIV/0!
  formula,  ///< formula whose result the file does not contain
};

/// A cell that is not empty.
struct SheetCell {
  CellType type = CellType::number;
  std::string text = {};
};

/// A sheet. Rows count from 1, columns from 0.
struct Sheet {
  std::string name;
  std::map<std::uint32_t, std::map<std::uint32_t, SheetCell>> rows;
};

/// Returns the sheet with this name; if the name is empty, the first sheet that has cells. Throws
/// InputError without a place for a file that is not such a workbook, for an encrypted or damaged
/// one, for a part of more than 256 MiB, and for a sheet that does not exist.
Sheet read_sheet(std::string_view bytes, const std::string& name);

/// Returns the reference of a cell as spreadsheets write it: "B7".
std::string cell_name(std::uint32_t row, std::uint32_t column);

}  // namespace jounce::io_detail
