// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/points.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

#include "io/src/points/header.hpp"
#include "io/src/points/sheet.hpp"

namespace jounce {

namespace {

using io_detail::trimmed;
using io_detail::unquoted;

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\r' || c == '\v' || c == '\f';
}

/// A number at the begin of [begin, end), and where its text ends; begin where it is none.
struct Number {
  double value = 0;
  const char* end = nullptr;
};

Number number_at(const char* begin, const char* end, char point) {
  if (end - begin > 1 && *begin == '+' && begin[1] != '-' && begin[1] != '+') {
    const Number rest = number_at(begin + 1, end, point);
    return rest.end == begin + 1 ? Number{0, begin} : rest;
  }
  double value = 0;
  if (point == '.') {
    const auto [to, error] = std::from_chars(begin, end, value);
    return {value, error == std::errc() ? to : begin};
  }
  std::array<char, 400> text;  // more than any double needs
  const auto length = std::min<std::ptrdiff_t>(end - begin, std::ssize(text));
  std::transform(begin, begin + length, text.begin(), [](char c) {
    return c == ',' ? '.' : c == '.' ? ',' : c;
  });
  const auto [to, error] = std::from_chars(text.data(), text.data() + length, value);
  return {value, error == std::errc() ? begin + (to - text.data()) : begin};
}

/// Signs that look like a minus sign, in UTF-8, with their names.
constexpr std::array<std::pair<std::string_view, const char*>, 3> minus_signs{
    {{"\xE2\x88\x92", "the typographic minus sign U+2212"},
     {"\xE2\x80\x93", "a dash (U+2013)"},
     {"\xEF\xBC\x8D", "the wide minus sign U+FF0D"}}};

class Reader {
 public:
  Reader(std::string_view text, Points& points)
      : at_(text.data()), end_(text.data() + text.size()), points_(points) {}

  /// The first line, where there is one.
  void read_names() {
    if (next_line() && (!read_separator() || next_line())) read_header();
  }

  void read() {
    read_names();
    if (!header_)
      fail("", "",
           "is empty: a header must name the columns, such as time [s],position [mm] or master "
           "[deg],slave [mm]");
    require_distinct_names();
    first_row_ = at_;
    reserve();
    if (next_line() && !read_units()) read_row();
    while (next_line()) read_row();
    if (points_.lines.empty()) fail("", "", "has a header but no points: add at least one row");
  }

 private:
  /// `cell`: the place in the line; null for the whole line.
  [[noreturn]] void fail(const std::string& key, std::string_view value, const std::string& rule,
                         const char* cell = nullptr) {
    throw InputError(key, printable(std::string(value)), rule)
        .at(points_.document, static_cast<int>(line_),
            cell == nullptr ? 0 : static_cast<int>(character(cell)));
  }

  /// The place of a cell in its line, from 1; 0 if it is too far.
  [[nodiscard]] std::uint16_t character(const char* cell) const {
    const auto at = static_cast<std::size_t>(cell - line_begin_) + 1;
    return at <= std::numeric_limits<std::uint16_t>::max() ? static_cast<std::uint16_t>(at) : 0;
  }

  /// The next line that is neither empty nor a comment.
  bool next_line() {
    while (at_ != end_) {
      begin_ = line_begin_ = at_;
      const auto* newline =
          static_cast<const char*>(std::memchr(at_, '\n', static_cast<std::size_t>(end_ - at_)));
      line_end_ = newline == nullptr ? end_ : newline;
      at_ = newline == nullptr ? end_ : newline + 1;
      ++line_;
      while (begin_ != line_end_ && is_blank(*begin_)) ++begin_;
      if (begin_ != line_end_ && *begin_ != '#' && !is_empty_row()) return true;
    }
    return false;
  }

  /// Separators alone, as spreadsheets write rows that were cleared.
  [[nodiscard]] bool is_empty_row() const {
    return header_ && *begin_ == separator_ && std::all_of(begin_, line_end_, [this](char c) {
             return c == separator_ || is_blank(c);
           });
  }

  /// True if the line is a spreadsheet's note of its separator: sep=;
  bool read_separator() {
    const auto note = unquoted(trimmed({begin_, static_cast<std::size_t>(line_end_ - begin_)}));
    if (note.size() != 5 || !note.starts_with("sep=")) return false;
    noted_ = note.back();
    return true;
  }

  void read_header() {
    const std::string_view line(begin_, static_cast<std::size_t>(line_end_ - begin_));
    if (const auto cr = line.find('\r'); cr != line.npos && cr + 1 < line.size())
      fail("header", line.substr(0, cr),
           "ends with a carriage return alone: save the file with line ends LF or CRLF");
    separator_ = noted_                         ? *noted_
                 : line.find(';') != line.npos  ? ';'
                 : line.find('\t') != line.npos ? '\t'
                                                : ',';
    std::vector<std::string_view> cells = cells_of(line);
    while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
    if (cells.size() == 1 && cells_of(line).size() > 1) {
      if (next_line()) read_header();  // the line was a title
      return;
    }
    for (const std::string_view cell : cells) add_column(cell);
    header_ = true;
    points_.header = line_;
  }

  void add_column(std::string_view cell) {
    try {
      PointColumn column = io_detail::column_of(cell);
      is_words_.push_back(io_detail::has_words(column));
      points_.columns.push_back(std::move(column));
    } catch (const InputError& error) {
      fail(error.key(), error.value(), error.rule(), cell.data());
    }
  }

  /// The end of the cell that begins here: the separator, or the end of the line.
  const char* cell_end(const char* cell, const char* end) const {
    const char* from = cell;
    while (from != end && is_blank(*from)) ++from;
    if (from != end && *from == '"') {
      const char* const quote = std::find(from + 1, end, '"');
      if (quote != end) from = quote;
    }
    return std::find(from, end, separator_);
  }

  /// The cells of a line, without blanks and quotes.
  std::vector<std::string_view> cells_of(std::string_view line) const {
    std::vector<std::string_view> cells;
    const char* const end = line.data() + line.size();
    for (const char* cell = line.data();; ++cell) {
      const char* const to = cell_end(cell, end);
      cells.push_back(unquoted(trimmed({cell, static_cast<std::size_t>(to - cell)})));
      if (to == end) return cells;
      cell = to;
    }
  }

  /// Reads a line of units under the names. False if the line is a point.
  bool read_units() {
    std::vector<std::string_view> cells =
        cells_of({begin_, static_cast<std::size_t>(line_end_ - begin_)});
    const auto& columns = points_.columns;
    if (cells.size() < columns.size() || !io_detail::are_units(cells) ||
        std::any_of(columns.begin(), columns.end(),
                    [](const PointColumn& column) { return !column.unit.empty(); }))
      return false;
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (!cells[i].empty() && io_detail::unit_of(cells[i]).empty())
        fail(columns[i].name, cells[i], io_detail::unknown_unit, cells[i].data());
    for (std::size_t i = 0; i < columns.size(); ++i)
      points_.columns[i].unit = io_detail::unit_of(cells[i]);
    first_row_ = at_;
    return true;
  }

  void require_distinct_names() {
    for (const PointColumn& column : points_.columns)
      if (points_.find(column.name) != &column)
        fail(column.name, "", "is the name of two columns: remove one");
  }

  void reserve() {
    const auto left = static_cast<std::size_t>(end_ - at_);
    const std::size_t rows =
        std::min<std::size_t>(left / (2 * points_.columns.size()) + 1, 1U << 20U);
    points_.lines.reserve(rows);
    for (PointColumn& column : points_.columns) {
      column.values.reserve(rows);
      column.characters.reserve(rows);
    }
  }

  void read_row() {
    const char* cell = begin_;
    const std::size_t last = points_.columns.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      while (cell != line_end_ && is_blank(*cell)) ++cell;
      const Number number = number_at(cell, line_end_, point_);
      const char* after = number.end;
      while (after != line_end_ && is_blank(*after)) ++after;
      const bool ends = after == line_end_ ? i == last : *after == separator_ && i != last;
      PointColumn& column = points_.columns[i];
      column.characters.push_back(character(cell));
      if (number.end != cell && ends && std::isfinite(number.value) && !is_words_[i]) [[likely]] {
        column.values.push_back(number.value);
      } else {
        after = read_otherwise(cell, i);
      }
      cell = after == line_end_ ? after : after + 1;
    }
    points_.lines.push_back(line_);
  }

  /// Reads a cell that is not a plain number: words, a decimal comma, or a mistake.
  const char* read_otherwise(const char* cell, std::size_t i) {
    const char* to = cell_end(cell, line_end_);
    const std::string_view written = trimmed({cell, static_cast<std::size_t>(to - cell)});
    const std::string_view text = unquoted(written);
    PointColumn& column = points_.columns[i];
    if (require_length(); i + 1 == points_.columns.size()) to = line_end_;
    if (is_words_[i]) {
      column.words.emplace_back(text);
      return to;
    }
    if (text.empty()) fail(column.name, text, "is empty: every point needs a number", cell);
    column.values.push_back(with_comma(column.name, text, text.size() < written.size()));
    return to;
  }

  double with_comma(const std::string& key, std::string_view text, bool quoted) {
    const char other = point_ == '.' ? ',' : '.';
    const char* const to = text.data() + text.size();
    if (const Number plain = number_at(text.data(), to, point_);  // out of its quotes
        plain.end == to && !text.empty() && std::isfinite(plain.value))
      return plain.value;
    for (const auto& [sign, name] : minus_signs)
      if (text.starts_with(sign))
        fail(key, text,
             std::string("begins with ") + name + ": write the minus sign of the keyboard, -",
             text.data());
    if ((separator_ == ',' && !quoted) || text.find(other) == text.npos)
      fail(key, text, "must be a finite number", text.data());
    const char* const end = text.data() + text.size();
    const Number number = number_at(text.data(), end, other);
    if (number.end != end || !std::isfinite(number.value))
      fail(key, text, "must be a finite number with one decimal comma and no thousands separator",
           text.data());
    if (point_ == ',')
      fail(key, text, "has a decimal point where other numbers have a comma", text.data());
    if (has_points())
      fail(key, text, "has a decimal comma where other numbers have a point", text.data());
    point_ = ',';
    return number.value;
  }

  /// True if a number before this line was written with a decimal point.
  bool has_points() const {
    for (const char* line = first_row_; line < begin_;) {
      const char* to = std::find(line, begin_, '\n');
      if (*line != '#' && std::find(line, to, '.') != to) return true;
      line = to == begin_ ? to : to + 1;
    }
    return false;
  }

  /// Throws where the row is longer or shorter than the header.
  void require_length() {
    const std::size_t wanted = points_.columns.size();
    std::vector<std::string_view> all =
        cells_of({begin_, static_cast<std::size_t>(line_end_ - begin_)});
    while (all.size() > wanted && all.back().empty()) all.pop_back();
    const std::size_t cells = all.size();
    if (cells == wanted) return;
    const bool commas = separator_ == ',' && cells == 2 * wanted;
    fail("", "",
         "has " + std::to_string(cells) + (cells == 1 ? " value" : " values") +
             ", but the header has " + std::to_string(wanted) +
             (wanted == 1 ? " column" : " columns") +
             (wanted == 1 ? ": the first line must name the columns, such as master,slave"
              : commas    ? ": decimal commas need semicolons between columns"
              : separator_ == ',' && std::find(begin_, line_end_, '"') != line_end_
                  ? ": a comma separates columns, also between quotes"
              : separator_ == ',' && cells > wanted && cells < 2 * wanted
                  ? ": if a value has a decimal comma, separate the columns by semicolons"
                  : ""));
  }

  const char* at_;
  const char* end_;
  const char* line_begin_ = nullptr;
  const char* begin_ = nullptr;  // after the blanks
  const char* line_end_ = nullptr;
  const char* first_row_ = nullptr;
  Points& points_;
  std::vector<bool> is_words_;
  std::uint32_t line_ = 0;
  char separator_ = ',';
  char point_ = '.';
  std::optional<char> noted_ = {};  // by a line sep=;
  bool header_ = false;
};

}  // namespace

const PointColumn* Points::find(std::string_view name) const {
  const auto at = std::find_if(columns.begin(), columns.end(),
                               [&](const PointColumn& column) { return column.name == name; });
  return at == columns.end() ? nullptr : &*at;
}

std::vector<double> Points::in_unit(std::string_view name, const std::string& unit) const {
  const PointColumn* column = find(name);
  if (column == nullptr)
    throw InputError("column \"" + std::string(name) + '"', "",
                     "is missing: the columns of the file are " +
                         listed(columns, &PointColumn::name) + ". Rename one, or add the column")
        .at(document, static_cast<int>(header));
  std::vector<double> values = column->values;
  if (column->unit.empty() || column->unit == unit) return values;
  try {
    const double factor = conversion(column->unit, unit);
    for (double& value : values) value *= factor;
  } catch (const InputError& error) {
    throw InputError(column->name, column->unit, error.rule() + ": correct the unit in the header")
        .at(document, static_cast<int>(header));
  }
  return values;
}

InputError Points::error(std::size_t point, const std::string& name, const std::string& value,
                         const std::string& rule) const {
  const PointColumn* const column = find(name);
  const bool placed = column != nullptr && point < column->characters.size();
  return InputError(name, value, rule)
      .at(document, static_cast<int>(lines[point]),
          placed ? static_cast<int>(column->characters[point]) : 0);
}

InputError Points::error(std::size_t point, const std::string& name, double value,
                         const std::string& unit, const std::string& rule) const {
  const std::string text = InputError(name, value, rule).value();
  return error(point, name, text + (unit.empty() || unit == "1" ? "" : " " + unit), rule);
}

Points parse_points(std::string_view text, const std::string& document) {
  if (io_detail::is_archive(text)) return io_detail::sheet_points(text, document);
  if (const auto at = text.find('\0'); at != text.npos)
    throw InputError("", "", "is not a text file: it has a zero byte here")
        .at(document, 1 + static_cast<int>(std::count(text.begin(), text.begin() + at, '\n')));
  Points points;
  points.document = document;
  Reader(text, points).read();
  return points;
}

bool begins_as_points(std::string_view text) {
  Points points;
  try {
    Reader(text, points).read_names();
  } catch (const InputError&) {
    return false;
  }
  const auto is_name = [](const PointColumn& column) {
    return std::all_of(column.name.begin(), column.name.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 ||
             std::string_view("_ /^").find(static_cast<char>(c)) != std::string_view::npos;
    });
  };
  return points.columns.size() > 1 &&
         std::all_of(points.columns.begin(), points.columns.end(), is_name);
}

std::string point_file_bytes(const std::string& path) {
  return read_file(io_detail::workbook_path(path), Archive::returned);
}

Points read_points(const std::string& path) {
  return parse_points(point_file_bytes(path), path);
}

}  // namespace jounce
