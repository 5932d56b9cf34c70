// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/basic_lines.hpp"
#include "controllers/src/exchange/cells.hpp"
#include "controllers/src/exchange/formats.hpp"

// An electronic cam of a Galil controller in DMC. EM gives the master's period and the slave's
// advance in a period, EP the interval of the master, ET[k] the slave at k intervals. All numbers
// are whole counts. The slave moves on straight lines between the entries.
namespace jounce::controllers_detail {
namespace {

constexpr double most_interval = 32767;  ///< counts
constexpr std::size_t most_entries = 257;

std::string galil_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  if (c.x.front() != 0)
    throw InputError("master", c.x.front(),
                     "must begin at 0: Galil's table begins at the master position 0");
  const double period = c.x.back();
  std::string text = "REM a cam for Galil ECAM, by " + made_by() +
                     "\nREM master: axis A; slave: axis B; all numbers are counts\nEAA\nEM " +
                     whole_number(period) + "," + whole_number(c.p.back() - c.p.front()) + "\nEP " +
                     whole_number(period / static_cast<double>(c.x.size() - 1)) + ",0\n";
  for (std::size_t i = 0; i < c.p.size(); ++i)
    text += "ET[" + std::to_string(i) + "]=," + whole_number(c.p[i]) + "\n";
  return text +
         "EB 1\nREM engage the slave with EG where it is at its table position, stop with EQ;\n"
         "REM compare the operands of EG with your manual: EG ,0\n";
}

/// The value of the slave, axis B, in `,40` or `0,40`.
double of_slave(const std::vector<double>& values, const Line& line, const char* key,
                const Place& place) {
  if (values.size() != 2)
    place.fail(line.number, key, line.text, "must have two values, of axis A and of axis B");
  return values[1];
}

/// `ET[12]=,4141`: the number of the entry and its value.
std::optional<std::pair<std::size_t, double>> entry_of(const Line& line, const Place& place) {
  const auto close = line.text.find(']'), equals = line.text.find('=');
  if (!has_command(std::string(line.text), "ET[")) return std::nullopt;
  if (close == line.text.npos || equals == line.text.npos || equals < close)
    place.fail(line.number, "ET", line.text,
               "must have the form ET[k]=,value: is the file complete?");
  const double k = place.number(line.number, "ET", line.text.substr(3, close - 3));
  if (!(k >= 0 && k < most_entries && k == std::floor(k)))
    place.fail(line.number, "ET", number(k), "must be a whole number from 0 to 256");
  const auto values = arguments_of({line.number, line.text.substr(equals)}, "=", place);
  return std::pair{static_cast<std::size_t>(k), of_slave(*values, line, "ET", place)};
}

std::vector<Exchanged> read_galil(const std::string& text, const Place& place) {
  std::map<std::size_t, std::pair<double, int>> entries;
  double period = 0, interval = 0;
  int line_of_interval = 1;
  for (const Line& line : basic_lines(text)) {
    if (const auto entry = entry_of(line, place))
      entries[entry->first] = {entry->second, line.number};
    if (const auto em = arguments_of(line, "EM", place)) period = em->front();
    if (const auto ep = arguments_of(line, "EP", place))
      interval = ep->front(), line_of_interval = line.number;
  }
  if (!(interval >= 1 && interval <= most_interval))
    place.fail(line_of_interval, "EP", number(interval),
               "must be from 1 to 32767 counts: is the file complete?");
  const double n = period / interval;
  if (!(n >= 1 && n < most_entries && n == std::floor(n)))
    place.fail(line_of_interval, "EM", number(period),
               "must be 1 to 256 intervals of " + number(interval) + " counts (EP)");
  Exchanged cam{
      .name = "B", .rule = Interpolation::linear, .units = {"count", "count"}, .repeats = true};
  for (std::size_t k = 0; k <= static_cast<std::size_t>(n); ++k) {
    const auto entry = entries.find(k);
    if (entry == entries.end())
      place.fail(line_of_interval, "ET[" + std::to_string(k) + "]", "",
                 "is missing: is the file complete?");
    cam.columns.x.push_back(interval * static_cast<double>(k));
    cam.columns.p.push_back(entry->second.first);
    cam.lines.push_back(entry->second.second);
  }
  return {std::move(cam)};
}

}  // namespace

constinit const FormatRow galil_format{
    .format = {.name = "galil",
               .maker = "Galil, electronic cam in DMC",
               .knot = "an entry `ET[k]=,p`: the slave in counts, at equal master distances",
               .source = "Galil Optima command reference, EA, EM, EP, ET, EB",
               .extension = ".dmc",
               .join = KnotJoin::lines,
               .x = Numbers::whole,
               .p = Numbers::whole,
               .equal_steps = true,
               .keeps_units = true,
               .states_period = true,
               .most = most_entries,
               .most_step = most_interval,
               .limits_from = "Galil's ECAM has 257 entries",
               .not_kept = "Galil's cam always repeats; stop it with EQ"},
    .detects = [](const std::string& text) { return has_command(text, "ET["); },
    .read = read_galil,
    .write = galil_text};

}  // namespace jounce::controllers_detail
