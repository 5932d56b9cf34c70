// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/basic_lines.hpp"
#include "controllers/src/exchange/cells.hpp"
#include "controllers/src/exchange/formats.hpp"

// A cam of a Trio Motion Coordinator: CAMBOX(start, end, multiplier, link distance, link axis,
// options) over the slave positions in TABLE. The positions are in encoder edges, relative to that
// at the start, at equal distances of the master, and joined by straight lines.
namespace jounce::controllers_detail {
namespace {

constexpr std::size_t first_place = 1000;  ///< in TABLE
constexpr std::size_t in_a_line = 8;       ///< values of one TABLE command
constexpr double most_places = 512000;     ///< size of TABLE in the largest controller

std::string trio_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  const bool cyclic = repeats(file.table.outside());
  std::string text = "' a cam for a Trio Motion Coordinator, by " + made_by() +
                     "\n' UNITS of the slave: 1 edge. The master moves in its user units" +
                     (file.units.x.empty() ? "" : ", " + file.units.x) +
                     ".\n' The slave begins at its present position; backwards, the cam runs "
                     "backwards.\n";
  for (std::size_t i = 0; i < c.x.size(); i += in_a_line) {
    text += "TABLE(" + std::to_string(first_place + i);
    for (std::size_t k = i; k < std::min(i + in_a_line, c.x.size()); ++k)
      text += "," + whole_number(c.p[k] - c.p[0]);
    text += ")\n";
  }
  return text + "BASE(1)\nCAMBOX(" + std::to_string(first_place) + "," +
         std::to_string(first_place + c.x.size() - 1) + ",1," + number(c.x.back() - c.x.front()) +
         ",0," + (cyclic ? "4" : "0") + ")\n";
}

/// A place in TABLE.
long place_in_table(double value, const Line& line, const Place& place) {
  if (!(value >= 0 && value < most_places && value == std::floor(value)))
    place.fail(line.number, "TABLE", number(value),
               "must be a whole number from 0 to " + number(most_places - 1));
  return static_cast<long>(value);
}

/// The values of TABLE commands by their places, and the last CAMBOX.
std::vector<Exchanged> read_trio(const std::string& text, const Place& place) {
  std::map<long, std::pair<double, int>> table;
  std::vector<Exchanged> cams;
  for (const Line& line : basic_lines(text)) {
    if (const auto values = arguments_of(line, "TABLE", place)) {
      const long first = place_in_table(values->front(), line, place);
      for (std::size_t i = 1; i < values->size(); ++i)
        table[first + static_cast<long>(i) - 1] = {(*values)[i], line.number};
    }
    const auto box = arguments_of(line, "CAMBOX", place);
    if (!box) continue;
    if (box->size() < 5)
      place.fail(line.number, "CAMBOX", std::to_string(box->size()) + " values",
                 "must have at least 5: start, end, multiplier, link distance, link axis");
    const long first = place_in_table((*box)[0], line, place);
    const long last = place_in_table((*box)[1], line, place);
    if (box->size() > 5) (void)place_in_table((*box)[5], line, place);
    if (last <= first || !((*box)[3] > 0))
      place.fail(line.number, "CAMBOX", std::string(line.text),
                 "must have an end above its start, and a link distance above 0");
    Exchanged cam{.name = "cam" + std::to_string(cams.size() + 1),
                  .rule = Interpolation::linear,
                  .units = {"", "count"},
                  .repeats = box->size() > 5 && (static_cast<long>((*box)[5]) & 4) != 0};
    for (long at = first; at <= last; ++at) {
      const auto value = table.find(at);
      if (value == table.end())
        place.fail(line.number, "CAMBOX", std::string(line.text),
                   "needs the value TABLE(" + std::to_string(at) + "), which is not in the file");
      cam.columns.x.push_back((*box)[3] * static_cast<double>(at - first) /
                              static_cast<double>(last - first));
      cam.columns.p.push_back((*box)[2] * (value->second.first - table[first].first));
      cam.lines.push_back(value->second.second);
    }
    cams.push_back(std::move(cam));
  }
  if (cams.empty()) place.fail(1, "", "", "contains no CAMBOX with a TABLE: is the file complete?");
  return cams;
}

}  // namespace

constinit const FormatRow trio_format{
    .format = {.name = "trio",
               .maker = "Trio Motion Coordinator, TABLE and CAMBOX in BASIC",
               .knot = "a value of `TABLE`: the slave in encoder edges, at equal master distances",
               .source = "Trio MC206 manual, CAMBOX; TJ2-MC64 programming manual",
               .extension = ".bas",
               .join = KnotJoin::lines,
               .p = Numbers::whole,
               .equal_steps = true,
               .states_period = true,
               .most = 16000,
               .limits_from = "an MC206 holds no more in TABLE",
               .not_kept = "the cam counts from the positions of master and slave at its start"},
    .detects =
        [](const std::string& text) {
          return has_command(text, "CAMBOX(") && has_command(text, "TABLE(");
        },
    .read = read_trio,
    .write = trio_text};

}  // namespace jounce::controllers_detail
