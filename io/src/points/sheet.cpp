// SPDX-License-Identifier: Apache-2.0
#include "io/src/points/sheet.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/profiles/error.hpp"

#include "io/src/points/header.hpp"
#include "io/src/points/workbook.hpp"

namespace jounce::io_detail {
namespace {

constexpr std::string_view ending = ".xlsx";

using Row = std::map<std::uint32_t, SheetCell>;

/// The points of one sheet.
class SheetReader {
 public:
  SheetReader(const Sheet& sheet, Points& points) : sheet_(sheet), points_(points) {}

  void read() {
    auto row = sheet_.rows.begin();
    while (row != sheet_.rows.end() && !read_header(*row)) ++row;
    if (row == sheet_.rows.end())
      throw InputError(sheet_.name, "", "has no header: one row must name two columns or more")
          .at(points_.document);
    if (++row != sheet_.rows.end() && read_units(*row)) ++row;
    for (; row != sheet_.rows.end(); ++row) read_row(*row);
    if (points_.lines.empty())
      throw InputError(sheet_.name, "", "has a header but no points: add at least one row")
          .at(points_.document);
  }

 private:
  [[noreturn]] void fail(std::uint32_t row, std::uint32_t column, std::string_view value,
                         const std::string& rule) const {
    std::string key = sheet_.name + "!" + cell_name(row, column);
    const auto at = std::find(places_.begin(), places_.end(), column);
    if (at != places_.end())
      key += " (" + points_.columns[static_cast<std::size_t>(at - places_.begin())].name + ")";
    throw InputError(printable(key), printable(std::string(value)), rule)
        .at(points_.document, static_cast<int>(row));
  }

  /// The first row with two texts or more. Rows above it with one cell are titles.
  bool read_header(const std::pair<const std::uint32_t, Row>& row) {
    const auto is_text = [](const auto& cell) { return cell.second.type == CellType::text; };
    const Row& cells = row.second;
    if (std::count_if(cells.begin(), cells.end(), is_text) < 2) {
      if (cells.size() < 2) return false;
      const auto number = std::find_if_not(cells.begin(), cells.end(), is_text);
      fail(row.first, number->first, number->second.text,
           "is a value, but the sheet has no header above it: add a row above it that names the "
           "columns");
    }
    points_.header = row.first;
    for (const auto& [column, cell] : cells) {
      try {
        PointColumn named = column_of(trimmed(cell.text));
        if (points_.find(named.name) != nullptr)
          throw InputError("", named.name, "is the name of two columns: remove one");
        points_.columns.push_back(std::move(named));
      } catch (const InputError& error) {
        fail(row.first, column, error.value(), error.rule());
      }
      places_.push_back(column);
    }
    return true;
  }

  bool read_units(const std::pair<const std::uint32_t, Row>& numbered) {
    const Row& row = numbered.second;
    std::vector<std::string_view> cells;
    for (const std::uint32_t column : places_) {
      const auto cell = row.find(column);
      if (cell != row.end() && cell->second.type != CellType::text) return false;
      cells.push_back(cell == row.end() ? "" : trimmed(cell->second.text));
    }
    if (!are_units(cells) ||
        std::any_of(points_.columns.begin(), points_.columns.end(),
                    [](const PointColumn& column) { return !column.unit.empty(); }))
      return false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      PointColumn& column = points_.columns[i];
      column.unit = unit_of(cells[i]);
      if (!cells[i].empty() && column.unit.empty())
        fail(numbered.first, places_[i], cells[i], unknown_unit);
    }
    return true;
  }

  void read_row(const std::pair<const std::uint32_t, Row>& row) {
    const auto in_row = [&](std::uint32_t column) { return row.second.contains(column); };
    if (std::none_of(places_.begin(), places_.end(), in_row)) return;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto cell = row.second.find(places_[i]);
      PointColumn& column = points_.columns[i];
      if (has_words(column)) {
        column.words.push_back(cell == row.second.end() ? ""
                                                        : std::string(trimmed(cell->second.text)));
        continue;
      }
      if (cell == row.second.end())
        fail(row.first, places_[i], "", "is empty: every point needs a number");
      column.values.push_back(number(row.first, places_[i], cell->second));
    }
    points_.lines.push_back(row.first);
  }

  double number(std::uint32_t row, std::uint32_t column, const SheetCell& cell) {
    if (cell.type == CellType::date)
      fail(row, column, cell.text,
           "is a date or a time of day: give the column the format of a number");
    if (cell.type == CellType::error)
      fail(row, column, cell.text,
           "is an error of a formula: correct the formula, or clear the row");
    if (cell.type == CellType::formula)
      fail(row, column, "",
           "has a formula without a stored value: open the workbook in a spreadsheet program and "
           "save it");
    const std::string_view text = trimmed(cell.text);
    if (cell.type == CellType::number) {
      if (const auto value = csv_number(text)) return *value;
      fail(row, column, text, "must be a finite number");
    }
    return typed_number(row, column, text);
  }

  /// A number that was typed as text: with a point or a comma, but not both kinds in one sheet.
  double typed_number(std::uint32_t row, std::uint32_t column, std::string_view text) {
    std::string plain(text.substr(text.starts_with('+') ? 1 : 0));
    const char mark = plain.find(',') != plain.npos ? ',' : '.';
    const bool marked = plain.find(mark) != plain.npos;
    if (marked && mark_.value_or(mark) != mark)
      fail(row, column, text,
           "is text with a decimal " + std::string(mark == ',' ? "comma" : "point") +
               ", but other texts of the sheet have a decimal " +
               (mark == ',' ? "point" : "comma"));
    if (marked) mark_ = mark;
    const bool ambiguous = mark == ',' && plain.find('.') != plain.npos;
    std::replace(plain.begin(), plain.end(), ',', '.');
    const auto value = csv_number(plain);
    if (!value || ambiguous) fail(row, column, text, "is text: must be a finite number");
    return *value;
  }

  const Sheet& sheet_;
  Points& points_;
  std::vector<std::uint32_t> places_ = {};  ///< column in the sheet of each column of the points
  std::optional<char> mark_ = {};           ///< decimal mark of the numbers that are text
};

/// Offset of the "#" between the path of a workbook and the name of a sheet.
std::size_t mark_of_sheet(const std::string& path) {
  std::string lower(path);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto at = lower.rfind(std::string(ending) + "#");
  return at == lower.npos ? path.size() : at + ending.size();
}

}  // namespace

bool is_archive(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

std::string workbook_path(const std::string& path) {
  return path.substr(0, mark_of_sheet(path));
}

Points sheet_points(std::string_view bytes, const std::string& document) {
  Points points;
  points.document = workbook_path(document);
  const std::size_t mark = mark_of_sheet(document);
  const std::string name = mark < document.size() ? document.substr(mark + 1) : "";
  try {
    SheetReader(read_sheet(bytes, name), points).read();
  } catch (const InputError& error) {
    throw error.document().empty() ? error.at(points.document) : error;
  }
  return points;
}

}  // namespace jounce::io_detail
