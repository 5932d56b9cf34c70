// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "jounce/base/detail/csv.hpp"
#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/cells.hpp"
#include "controllers/src/exchange/formats.hpp"

// A PVT trajectory of the Newport XPS: a line for each element, with its duration, and for each
// positioner of the group its displacement and its velocity at the end of the element. The
// trajectory begins and ends at rest.
namespace jounce::controllers_detail {
namespace {

std::vector<Exchanged> read_xps(const std::string& text, const Place& place) {
  std::vector<Exchanged> positioners;
  std::vector<Increments> at;
  for (const Line& line : lines_of(text)) {
    const auto cells = csv_cells(line.text);
    if (at.empty() && cells.size() >= 3 && cells.size() % 2 == 1) {
      at.resize(cells.size() / 2);
      positioners.resize(at.size());
    }
    if (at.empty() || cells.size() != 1 + 2 * at.size())
      place.fail(line.number, "row", std::to_string(cells.size()) + " values",
                 at.empty()
                     ? "must have a duration, and a displacement and a velocity for each "
                       "positioner"
                     : "must have " + std::to_string(1 + 2 * at.size()) + ", as the first row");
    const double dx = place.number(line.number, "time", trimmed(cells[0]));
    for (std::size_t i = 0; i < at.size(); ++i) {
      Exchanged& to = positioners[i];
      if (to.lines.empty())
        to = {.name = std::to_string(i + 1),
              .rule = Interpolation::cubic_hermite,
              .units = {"s", ""},
              .columns = {{0}, {0}, {0}, {}},
              .lines = {line.number}};
      at[i].add(place, line.number, dx,
                place.number(line.number, "displacement", trimmed(cells[1 + 2 * i])),
                place.number(line.number, "velocity", trimmed(cells[2 + 2 * i])), to);
    }
  }
  if (positioners.empty()) place.fail(1, "", "", "has no elements: is the file complete?");
  for (const Exchanged& each : positioners)
    if (each.columns.v.back() != 0)
      place.fail(each.lines.back(), "velocity", number(each.columns.v.back()),
                 "must be 0 in the last element: is the file complete?");
  return positioners;
}

/// The increments count from the sum of those before, so that rounding does not add up.
std::string xps_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  double x = 0, p = 0;
  std::string text;
  for (std::size_t i = 1; i < c.x.size(); ++i) {
    const double dx = increment(x, c.x[i] - c.x[0]), dp = increment(p, c.p[i] - c.p[0]);
    text += number(dx) + ", " + number(dp) + ", " + number(i + 1 < c.x.size() ? c.v[i] : 0) + "\n";
    x += dx;
    p += dp;
  }
  return text;
}

}  // namespace

constinit const FormatRow xps_format{
    .format = {.name = "xps",
               .maker = "Newport XPS, PVT trajectory",
               .knot = "a line `duration, displacement, velocity`",
               .source = "Newport XPS-Q8 manual 8.3.6",
               .extension = ".trj",
               .join = KnotJoin::cubic,
               .axis = Domain::time,
               .x_unit = "s",
               .keeps_units = true,
               .rests = true,
               .not_kept =
                   "the trajectory counts from the position at its start; its start is the time 0"},
    .detects =
        [](const std::string& text) {
          const auto lines = lines_of(text);
          if (lines.empty()) return false;
          const auto cells = csv_cells(lines.front().text);
          return cells.size() >= 3 && cells.size() % 2 == 1 && csv_number(trimmed(cells[0]));
        },
    .read = read_xps,
    .write = xps_text,
    .by_ending_only = true};

}  // namespace jounce::controllers_detail
