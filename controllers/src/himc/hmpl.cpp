// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "jounce/base/csv.hpp"
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

/// The array whose name contains a word.
struct NumberArray {
  std::vector<double> values;
  int line = 0;
};

std::vector<Exchanged> read_hmpl(const std::string& text, const Place& place) {
  std::map<std::string, NumberArray> arrays;
  int line = 1;
  for (std::size_t at = 0; (at = text.find('{', at)) != text.npos; ++at) {
    const auto declared = text.rfind("double", at), end = text.find('}', at);
    if (declared == text.npos) continue;
    const std::string head = lower(std::string_view(text).substr(declared, at - declared));
    line = 1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    for (const char* word : {"time", "pos", "vel"}) {
      if (head.find(word) == head.npos || head.find(';') != head.npos) continue;
      if (end == text.npos)
        place.fail(line, word, "", "has no closing brace: is the file complete?");
      NumberArray& array = arrays[word];
      if (array.line != 0) place.fail(line, word, "", "is given by two arrays: remove one");
      array.line = line;
      std::string list = text.substr(at + 1, end - at - 1);
      std::replace(list.begin(), list.end(), '\n', ' ');
      for (const std::string_view cell : csv_cells(list))
        array.values.push_back(place.number(line, word, trimmed(cell)));
    }
  }
  Exchanged table{.name = "", .rule = Interpolation::cubic_hermite, .units = {"ms", ""}};
  for (const auto& [word, column, scale] : {std::tuple{"time", &table.columns.x, 1.0},
                                            {"pos", &table.columns.p, 1.0},
                                            {"vel", &table.columns.v, 1 / ms_in_s}}) {
    const auto array = arrays.find(word);
    if (array == arrays.end())
      place.fail(line, word, "", "is in no array of double: is the file complete?");
    if (array->second.values.size() != arrays["time"].values.size())
      place.fail(array->second.line, word, std::to_string(array->second.values.size()) + " values",
                 "must be as many as times: " + std::to_string(arrays["time"].values.size()));
    for (const double value : array->second.values) column->push_back(value * scale);
  }
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
