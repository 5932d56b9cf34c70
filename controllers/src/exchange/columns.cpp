// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::controllers_detail {
namespace {

std::vector<std::string_view> split(std::string_view line, const char* separators, bool runs) {
  std::vector<std::string_view> all;
  while (true) {
    const auto end = line.find_first_of(separators);
    const std::string_view cell = trimmed(line.substr(0, end));
    if (!runs || !cell.empty()) all.push_back(cell);
    if (end == std::string_view::npos) return all;
    line.remove_prefix(end + 1);
  }
}

/// The cells without the empty cell after a separator at the end of the line.
std::vector<std::string_view> without_empty_end(std::vector<std::string_view> cells) {
  if (cells.size() > 1 && cells.back().empty()) cells.pop_back();
  return cells;
}

bool begins_with_number(std::string_view cell) {
  cell = cell.substr(0, cell.find(','));  // cuts a decimal comma
  return csv_number(cell).has_value();
}

std::string_view without_comment(std::string_view line) {
  return trimmed(line.substr(0, line.find("//")));
}

const std::vector<std::string> editor_columns{"x", "y", "v", "a", "j", "type"};

/// The columns that a header names; none where the line is no header. J follows from the others and
/// is skipped.
std::vector<std::string> header_of(const Line& line, const Place& place) {
  std::vector<std::string> names;
  for (const auto cell : column_cells(without_comment(line.text)))
    names.push_back(lower(cell.substr(0, cell.find(" ["))));
  if (names.front() != "x") return {};
  const std::size_t n = names.size();
  const bool known = n <= editor_columns.size() && n != 3 &&
                     std::equal(names.begin(), names.end(), editor_columns.begin());
  if (!known)
    place.fail(line.number, "columns", line.text,
               "must be X Y or X Y V A, optionally with J and Type");
  return names;
}

class Rows {
 public:
  Rows(std::size_t columns, const Place& place) : place_(place), columns_(columns) {
    read_.rule = columns == 2 ? Interpolation::linear : Interpolation::quintic_hermite;
  }

  void header(const std::vector<std::string>& names) {
    columns_ = names.size();
    headed_ = true;
  }

  void row(const Line& line) {
    auto cells = column_cells(without_comment(line.text));
    // A row's Type is that of the segment that ends there: the first may have none.
    if (has_type() && read_.lines.empty() && cells.size() == columns_ - 1) cells.emplace_back("-");
    if (cells.size() != columns_)
      place_.fail(line.number, "", "", wrong_length(line, cells.size()));
    const std::array<std::vector<double>*, 4> all{&read_.columns.x, &read_.columns.p,
                                                  &read_.columns.v, &read_.columns.a};
    for (std::size_t i = 0;
         i < std::min<std::size_t>(columns_, read_.rule == Interpolation::linear ? 2 : 4); ++i)
      all[i]->push_back(place_.number(line.number, std::string(1, "XYVA"[i]), cells[i]));
    if (has_type()) require_quintic(line, lower(cells.back()));
    read_.lines.push_back(line.number);
  }

  Exchanged finish() { return std::move(read_); }

 private:
  /// The error of a row with a wrong number of values.
  [[nodiscard]] std::string wrong_length(const Line& line, std::size_t given) const {
    const std::string has =
        "has " + std::to_string(given) + (given == 1 ? " value" : " values") + ", but ";
    if (!headed_ && read_.lines.empty()) return has + "a row has 4 (X Y V A) or 2 (X Y)";
    const std::string text = has + (headed_ ? "the header has " : "the rows before it have ") +
                             std::to_string(columns_) + (headed_ ? " columns" : "");
    const bool commas = line.text.find(',') != std::string_view::npos;
    return given == 2 * columns_ && commas
               ? text +
                     ": if these are decimal commas, convert the file with `jounce convert "
                     "--decimal-comma`"
               : text;
  }

  [[nodiscard]] bool has_type() const { return columns_ == editor_columns.size(); }

  void require_quintic(const Line& line, const std::string& type) {
    if (type != "poly5" && !(read_.lines.empty() && (type.empty() || type == "-")))
      place_.fail(line.number, "Type", type, "must be Poly5, the only supported segment type");
  }

  const Place& place_;
  std::size_t columns_;
  bool headed_ = false;
  Exchanged read_;
};

void append(std::string& text, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, end.ptr);
}

std::string row_text(const Columns& c, std::size_t knot, char separator, bool rates) {
  std::string text;
  append(text, c.x[knot]);
  for (const auto* column : {&c.p, &c.v, &c.a}) {
    if (column != &c.p && !rates) break;
    text += separator;
    append(text, (*column)[knot]);
  }
  return text;
}

}  // namespace

std::vector<std::string_view> column_cells(std::string_view line) {
  if (line.find(';') != line.npos) return without_empty_end(split(line, ";", false));
  if (line.find('\t') != line.npos) return split(line, "\t", true);
  const auto words = split(line, " ", true);
  const bool listed = std::all_of(words.begin(), words.end() - (words.empty() ? 0 : 1),
                                  [](std::string_view word) { return word.ends_with(','); });
  return listed && line.find(',') != line.npos ? without_empty_end(split(line, ",", false)) : words;
}

std::vector<std::string_view> first_cells(std::string_view text) {
  const auto lines = lines_of(text);
  const auto first = std::find_if(lines.begin(), lines.end(),
                                  [](const Line& line) { return !is_comment(line.text); });
  if (first == lines.end()) return {};
  auto cells = column_cells(without_comment(first->text));
  const bool header = cells.size() > 1 && (cells[0] == "X" || cells[0] == "x");
  const bool knot = begins_with_number(cells[0]) && first->text.find('=') == std::string::npos;
  if (!header && !knot) cells.clear();
  return cells;
}

std::vector<Exchanged> read_columns(const std::string& text, const Place& place,
                                    std::size_t columns, bool counted) {
  Rows rows(columns, place);
  std::optional<Note> count;
  std::size_t knots = 0;
  bool first = true;
  for (const Line& line : lines_of(text)) {
    if (is_comment(line.text)) continue;
    const bool was_first = std::exchange(first, false);
    if (was_first && counted) {
      count = {std::string(line.text), line.number};
      continue;
    }
    if (was_first)
      if (const auto names = header_of(line, place); !names.empty()) {
        rows.header(names);
        continue;
      }
    rows.row(line);
    ++knots;
  }
  if (count && count->value != std::to_string(knots))
    place.fail(
        count->line, "number of points", count->value,
        "the number of points in the file is " + std::to_string(knots) + ": is the file complete?");
  return {rows.finish()};
}

std::string rows_text(const TableFile& file, char separator, const std::string& end) {
  std::string text;
  const bool rates = file.table.rule() == Interpolation::quintic_hermite;
  for (std::size_t i = 0; i < file.table.size(); ++i)
    text += row_text(file.table.columns(), i, separator, rates) + end;
  return text;
}

}  // namespace jounce::controllers_detail
