// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <charconv>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/detail/table_parts.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using io_detail::TableParts;

constexpr std::string_view first_line = "# jounce table ";
constexpr std::array header_keys{"axis",   "rule", "outside",     "knots",
                                 "sha256", "spec", "spec sha256", "made by"};

void append(std::string& text, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, end.ptr);
}

/// Reads a text line by line and counts the lines.
class Lines {
 public:
  Lines(const std::string& text, std::string name) : rest_(text), name_(std::move(name)) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] bool only_blank() const {
    return rest_.find_first_not_of(" \t\r\n") == std::string_view::npos;
  }
  [[nodiscard]] bool next_is_head() const { return rest_.starts_with('#'); }

  std::string_view next() {
    ++line_;
    const auto end = rest_.find('\n');
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }

  [[nodiscard]] int line() const { return line_; }

  [[noreturn]] void fail(const std::string& key, const std::string& value, const std::string& rule,
                         int line = 0) const {
    throw InputError(key, value, rule).at(name_, line == 0 ? line_ : line);
  }

  /// Throws InputError for a head that ends without this key.
  [[noreturn]] void fail_in_head(const std::string& key) const {
    if (only_blank())
      fail("", "", "the file ends within its head, before " + key + ": export it again");
    if (rest_.find("\n# " + key + ": ") != std::string_view::npos)
      fail("", "",
           "the head of the table continues below this row: remove the row, or export the file "
           "again",
           line_ + 1);
    fail(key, "", "is missing from the head of the table: export the file again");
  }

 private:
  std::string_view rest_;
  std::string name_;
  int line_ = 0;
};

void read_version(Lines& lines) {
  const std::string_view line = lines.next();
  if (!line.starts_with(first_line))
    lines.fail("", "",
               "must begin with the line `# jounce table 1`: make the table of a spec with "
               "`jounce design`");
  io_detail::require_version(
      std::string(line.substr(first_line.size())),
      [&](const auto& value, const auto& rule) { lines.fail("jounce table", value, rule); });
}

struct HeadEntry {
  std::string text;
  int line = 0;
};
using Head = std::map<std::string, HeadEntry>;

Head read_head(Lines& lines) {
  Head head;
  while (lines.next_is_head()) {
    const std::string_view line = lines.next();
    const auto colon = line.find(": ");
    if (colon == std::string_view::npos || !line.starts_with("# "))
      lines.fail("", std::string(line), "must be `# key: value`");
    const std::string key(line.substr(2, colon - 2));
    const std::string text(line.substr(colon + 2));
    if (std::find(header_keys.begin(), header_keys.end(), key) == header_keys.end())
      lines.fail(key, text, "is not a key of the head of a table: remove it");
    if (!head.emplace(key, HeadEntry{text, lines.line()}).second)
      lines.fail(key, text, "is given twice: remove one");
  }
  for (const char* key : {"axis", "rule", "outside", "knots", "sha256"})
    if (!head.contains(key)) lines.fail_in_head(key);
  return head;
}

/// "master [deg]" -> unit "deg", checked against the expected name.
std::string column_unit(Lines& lines, std::string_view cell, const std::string& expected) {
  const auto open = cell.find(" [");
  if (open == std::string_view::npos || !cell.ends_with(']') || cell.substr(0, open) != expected)
    lines.fail("column", std::string(cell), "must be `" + expected + " [unit]`");
  return std::string(cell.substr(open + 2, cell.size() - open - 3));
}

void read_columns_line(Lines& lines, TableParts& parts) {
  const std::string_view line = lines.at_end() ? std::string_view() : lines.next();
  const auto names = csv_cells(line);
  const auto expected = io_detail::column_names(parts.axis, parts.rule);
  if (names.size() != expected.size())
    lines.fail("columns", std::to_string(names.size()),
               "a " + std::string(name(parts.rule)) + " table has exactly " +
                   std::to_string(expected.size()) + ", separated by commas" +
                   (line.find(';') == std::string_view::npos ? "" : ": this line has semicolons"));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string unit = column_unit(lines, names[i], expected[i]);
    const std::string rule = io_detail::take_unit(parts, i, unit);
    if (!rule.empty()) lines.fail(expected[i], "[" + unit + "]", rule);
  }
}

void read_row(Lines& lines, std::span<std::vector<double>* const> columns) {
  const auto row = csv_cells(lines.next());
  if (row.size() != columns.size())
    lines.fail("row", std::to_string(row.size()) + " values",
               "must have " + std::to_string(columns.size()));
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto value = csv_number(row[i]);
    if (!value)
      lines.fail("column " + std::to_string(i + 1), '"' + std::string(row[i]) + '"',
                 "must be a finite number");
    columns[i]->push_back(*value);
  }
}

}  // namespace

std::string to_csv(const TableFile& file) {
  const Table& table = file.table;
  std::string text = std::string(first_line) + std::to_string(io_detail::schema_version) + "\n";
  const auto line = [&](const char* key, const std::string& value) {
    if (!value.empty()) text += std::string("# ") + key + ": " + value + "\n";
  };
  line("axis", name(table.axis()));
  line("rule", name(table.rule()));
  line("outside", name(table.outside()));
  line("knots", std::to_string(table.size()));
  line("sha256", hex(content_hash(table, file.units)));
  line("spec", file.provenance.spec);
  line("spec sha256", file.provenance.spec_sha256);
  line("made by", file.provenance.made_by);
  const auto names = io_detail::column_names(table.axis(), table.rule());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto unit = i == 0
                          ? file.units.x
                          : rate_unit(file.units.position, file.units.x, static_cast<int>(i) - 1);
    text += (i == 0 ? "" : ",") + names[i] + " [" + unit + "]";
  }
  const auto& [x, p, v, a] = table.columns();
  const std::array columns{&x, &p, &v, &a};
  for (std::size_t knot = 0; knot < table.size(); ++knot)
    for (std::size_t i = 0; i < names.size(); ++i) {
      text += i == 0 ? '\n' : ',';
      append(text, (*columns[i])[knot]);
    }
  return text + "\n";
}

namespace io_detail {

TableParts parse_csv(const std::string& text, const std::string& name) {
  Lines lines(text, name);
  read_version(lines);
  const Head head = read_head(lines);
  TableParts parts;
  const auto pick = [&](const char* key, const auto& all) {
    const auto& [given, line] = head.at(key);
    return choice(given, std::span(all),
                  [&, at = line](const std::string& value, const std::string& rule) {
                    lines.fail(key, value, rule, at);
                  });
  };
  parts.axis = pick("axis", axes);
  parts.rule = pick("rule", rules);
  parts.outside = pick("outside", policies);
  parts.sha256 = head.at("sha256").text;
  for (const auto& [key, target] : {std::pair{"spec", &parts.provenance.spec},
                                    {"spec sha256", &parts.provenance.spec_sha256},
                                    {"made by", &parts.provenance.made_by}})
    if (const auto it = head.find(key); it != head.end()) *target = it->second.text;
  read_columns_line(lines, parts);
  parts.line_before_knots = lines.line();
  const std::array all{&parts.columns.x, &parts.columns.p, &parts.columns.v, &parts.columns.a};
  const auto used = column_names(parts.axis, parts.rule).size();
  while (!lines.only_blank()) read_row(lines, std::span(all).first(used));
  const auto& [knots, line] = head.at("knots");
  if (std::to_string(parts.columns.x.size()) != knots)
    lines.fail("knots", knots,
               "the number of rows in the file is " + std::to_string(parts.columns.x.size()) +
                   ": is the file complete?",
               line);
  return parts;
}

}  // namespace io_detail
}  // namespace jounce
