// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/detail/listed.hpp"
#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/cells.hpp"
#include "controllers/src/exchange/formats.hpp"

// Tables in HMPL, the C-like language of HIWIN's HIMC: the three arrays of MovePVT (ms, mm or deg,
// mm/s or deg/s; at most 50 points), and a gear for a cam that is one straight line.
namespace jounce::controllers_detail {
namespace {

constexpr double ms_in_s = 1e3;

std::string array_text(const char* name, const std::vector<double>& values, double scale,
                       const std::string& unit) {
  std::string text = "double " + std::string(name) + "[" + std::to_string(values.size()) + "] = {";
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? "" : ", ") + number(values[i] * scale);
  return text + "};  // " + unit + "\n";
}

std::string hmpl_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  const std::string& unit = file.units.position;
  std::vector<double> time = c.x;
  for (double& x : time) x -= c.x.front();
  return "// a PVT motion for HIWIN HIMC, by " + made_by() +
         "\n// Pass the three arrays and their length to MovePVT (HMPL manual 5.2.8).\n" +
         array_text("pvt_time", time, 1, "ms") + array_text("pvt_position", c.p, 1, unit) +
         array_text("pvt_velocity", c.v, ms_in_s, unit + "/s");
}

/// The array for a word.
struct NumberArray {
  std::vector<double> values;
  int line = 0;
};

/// The name of the last array in a declaration, in lower case: "double t[5] =". "" if the text
/// declares no array.
std::string name_of_array(std::string_view declaration) {
  const auto bracket = declaration.rfind('[');
  if (bracket == declaration.npos || declaration.find(';') != declaration.npos) return "";
  const std::string before = lower(trimmed(declaration.substr(0, bracket)));
  return before.substr(before.find_last_of(" \t\r\n,") + 1);
}

/// The arguments of the first call of MovePVT, in lower case; empty if there is none.
std::vector<std::string> arguments_of_call(const std::string& text) {
  std::vector<std::string> names;
  const auto call = text.find("MovePVT(");
  const auto end = text.find(')', call);
  if (call == text.npos || end == text.npos) return names;
  const auto from = text.find('(', call) + 1;
  std::string list = text.substr(from, end - from);
  std::replace(list.begin(), list.end(), '\n', ' ');
  for (const std::string_view cell : csv_cells(list)) names.push_back(lower(trimmed(cell)));
  return names;
}

/// True if an array of this name has the numbers of a word: its name contains the word, or is its
/// first letter.
bool is_array_of(const std::string& name, std::string_view word) {
  return name.find(word) != name.npos || name == word.substr(0, 1);
}

/// An array of double with initial values.
struct Declared {
  std::string name;
  std::string list;  ///< its values; the array has no end where `closed` is false
  int line = 0;
  bool closed = true;
};

/// The arrays of the file; only those that MovePVT receives, if it receives one of them.
std::vector<Declared> declared_arrays(const std::string& text) {
  std::vector<Declared> all;
  for (std::size_t at = 0; (at = text.find('{', at)) != text.npos; ++at) {
    const auto begin = text.rfind("double", at), end = text.find('}', at);
    if (begin == text.npos) continue;
    const std::string name = name_of_array(std::string_view(text).substr(begin, at - begin));
    if (name.empty()) continue;
    const auto lines =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    all.push_back(
        {name, text.substr(at + 1, end - at - 1), 1 + static_cast<int>(lines), end != text.npos});
    std::replace(all.back().list.begin(), all.back().list.end(), '\n', ' ');
  }
  const std::vector<std::string> passed = arguments_of_call(text);
  const auto other = [&](const Declared& array) {
    return std::find(passed.begin(), passed.end(), array.name) == passed.end();
  };
  if (!std::all_of(all.begin(), all.end(), other)) std::erase_if(all, other);
  return all;
}

/// The rule for a word without an array. The order of the arguments of MovePVT is not known.
std::string missing_array(const std::string& word, const std::vector<Declared>& arrays) {
  if (arrays.empty()) return "is in no array of double: is the file complete?";
  std::string all;
  for (const Declared& array : arrays) all += (all.empty() ? "" : ", ") + array.name;
  return "is in no array: the arrays are named " + all + ". Rename the array of these numbers to " +
         word.substr(0, 1) + ", or to a name with " + word;
}

/// MovePVT also receives the number of points. Its place in the call is not known, so one of the
/// numbers of the call must be the number of points. A call with a single number, or with names for
/// numbers, is not compared.
void require_all_points(const std::string& text, std::size_t points, const Place& place) {
  std::vector<std::string> numbers;
  std::size_t names = 0;
  for (const std::string& argument : arguments_of_call(text)) {
    const bool digits = argument.find_first_not_of("0123456789") == argument.npos;
    if (digits && !argument.empty())
      numbers.push_back(argument);
    else
      ++names;
  }
  if (names > 3 || numbers.size() < 2) return;
  const std::string wanted = std::to_string(points);
  if (std::find(numbers.begin(), numbers.end(), wanted) != numbers.end()) return;
  place.fail(line_at(text, static_cast<std::ptrdiff_t>(text.find("MovePVT("))), "MovePVT",
             listed(numbers),
             "does not contain " + wanted +
                 ", the number of values in each array: make the call and the arrays agree");
}

std::vector<Exchanged> read_hmpl(const std::string& text, const Place& place) {
  std::map<std::string, NumberArray> arrays;
  const std::vector<Declared> all = declared_arrays(text);
  for (const Declared& declared : all)
    for (const char* word : {"time", "pos", "vel"}) {
      if (!is_array_of(declared.name, word)) continue;
      if (!declared.closed)
        place.fail(declared.line, word, "", "has no closing brace: is the file complete?");
      NumberArray& array = arrays[word];
      if (array.line != 0)
        place.fail(declared.line, word, "", "is given by two arrays: remove one");
      array.line = declared.line;
      auto cells = csv_cells(declared.list);
      if (cells.size() > 1 && trimmed(cells.back()).empty()) cells.pop_back();  // {0, 1,} in C
      for (const std::string_view cell : cells)
        array.values.push_back(place.number(declared.line, word, trimmed(cell)));
    }
  const int line = all.empty() ? 1 : all.back().line;
  Exchanged table{.name = "", .rule = Interpolation::cubic_hermite, .units = {"ms", ""}};
  for (const auto& [word, column, scale] : {std::tuple{"time", &table.columns.x, 1.0},
                                            {"pos", &table.columns.p, 1.0},
                                            {"vel", &table.columns.v, 1 / ms_in_s}}) {
    const auto array = arrays.find(word);
    if (array == arrays.end()) place.fail(line, word, "", missing_array(word, all));
    if (array->second.values.size() != arrays["time"].values.size())
      place.fail(array->second.line, word, std::to_string(array->second.values.size()) + " values",
                 "must be as many as times: " + std::to_string(arrays["time"].values.size()));
    for (const double value : array->second.values) column->push_back(value * scale);
  }
  require_all_points(text, table.columns.x.size(), place);
  table.lines.assign(table.columns.x.size(), arrays["time"].line);
  return {std::move(table)};
}

std::string gear_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  const double ratio = (c.p.back() - c.p.front()) / (c.x.back() - c.x.front());
  return "// a gear for HIWIN HIMC, by " + made_by() +
         "\n// Enable both axes before. The slave begins at its present position, at once.\n"
         "int master = 0;\nint slave = 1;\nEnableGear(master, slave);\nGearIn(master, slave, " +
         number(ratio) + ");\n";
}

}  // namespace

constinit const FormatRow hmpl_format{
    .format = {.name = "hmpl",
               .maker = "HIWIN HIMC, arrays of MovePVT in HMPL",
               .knot = "an element of the arrays of time, position and velocity",
               .source = "HMPL manual 5.2.8",
               .extension = "",
               .join = KnotJoin::cubic,
               .axis = Domain::time,
               .x_unit = "ms",
               .position_units = "mm deg",
               .keeps_units = true,
               .most = 50,
               .limits_from = "MovePVT takes at most 50 points",
               .not_kept = "the times count from the start of the table"},
    .detects =
        [](const std::string& text) {
          const std::string code = lower(text);
          return code.find("double ") != code.npos && code.find("pvt") != code.npos &&
                 code.find('{') != code.npos;
        },
    .read = read_hmpl,
    .write = hmpl_text};

constinit const FormatRow hmpl_gear_format{
    .format = {.name = "hmpl-gear",
               .maker = "HIWIN HIMC, gear in HMPL, for a cam that is one straight line",
               .knot = "the ratio of `GearIn(master, slave, ratio)`",
               .source = "HMPL manual 6.2 to 6.5",
               .extension = "",
               .join = KnotJoin::lines,
               .readable = false,
               .most = 2,
               .limits_from = "a gear is one straight line",
               .not_kept = "the gear has no end, and counts from the positions at GearIn"},
    .detects =
        [](const std::string& text) {
          const auto lines = lines_of(text);
          return std::any_of(lines.begin(), lines.end(),
                             [](const Line& line) { return line.text.starts_with("GearIn("); });
        },
    .read = nullptr,
    .write = gear_text,
    .unreadable = "is a gear, which is not a table: write a spec of kind \"gear\""};

}  // namespace jounce::controllers_detail
