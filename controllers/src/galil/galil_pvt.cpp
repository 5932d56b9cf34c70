// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/basic_lines.hpp"
#include "controllers/src/exchange/cells.hpp"
#include "controllers/src/exchange/formats.hpp"

// A PVT motion of a Galil controller in DMC: PVA=p,v,t with the displacement in counts, the velocity
// at its end in counts/s, and the duration in samples, an even number. `PVA=0,0,0` ends the motion,
// BT begins it. With TM 1000, a sample is 1/1024 s.
namespace jounce::controllers_detail {
namespace {

constexpr double galil_sample = 1.0 / 1024;  ///< s, with TM 1000

std::string galil_pvt_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  std::string text =
      "REM a PVT motion for Galil, axis A, by " + made_by() +
      "\nREM counts, counts/s, samples; from the position at BT\nTM 1000\nPVA=0,0,-1\n";
  for (std::size_t i = 1; i < c.x.size(); ++i) {
    text += "PVA=" + whole_number(c.p[i] - c.p[i - 1]) + "," +
            whole_number(i + 1 < c.x.size() ? c.v[i] : 0) + "," +
            whole_number((c.x[i] - c.x[i - 1]) / galil_sample) + "\n";
  }
  return text + "PVA=0,0,0\nBTA\n";
}

std::vector<Exchanged> read_galil_pvt(const std::string& text, const Place& place) {
  Exchanged axis{.name = "A", .rule = Interpolation::cubic_hermite, .units = {"s", "count"}};
  Increments at;
  bool ended = false;
  for (const Line& line : basic_lines(text)) {
    if (const auto tm = arguments_of(line, "TM", place); tm && tm->front() != 1000)
      place.fail(line.number, "TM", number(tm->front()),
                 "must be 1000: Jounce reads samples of 1/1024 s");
    const auto pv = arguments_of(line, "PVA=", place);
    if (!pv) continue;
    if (pv->size() != 3)
      place.fail(line.number, "PVA", line.text.substr(line.text.find('=') + 1),
                 "must have three values: displacement, velocity, samples");
    const auto [p, v, t] = std::tuple((*pv)[0], (*pv)[1], (*pv)[2]);
    if (t == -1 && axis.lines.empty()) continue;
    if (ended)
      place.fail(line.number, "PVA", line.text.substr(line.text.find('=') + 1),
                 "follows the end of the motion: remove it");
    if (t == 0 && p == 0 && v == 0) {
      ended = true;
      continue;
    }
    if (!(t >= 2 && std::fmod(t, 2) == 0))
      place.fail(line.number, "PVA", number(t), "must be an even number of samples above 0");
    if (axis.lines.empty()) {
      axis.columns = {{0}, {0}, {0}, {}};
      axis.lines = {line.number};
    }
    at.add(place, line.number, t * galil_sample, p, v, axis);
  }
  if (!ended) place.fail(1, "PVA", "", "does not end with PVA=0,0,0: is the file complete?");
  if (axis.columns.v.empty() || axis.columns.v.back() != 0)
    place.fail(1, "PVA", "", "must have segments, and end at the velocity 0");
  return {std::move(axis)};
}

}  // namespace

constinit const FormatRow galil_pvt_format{
    .format = {.name = "galil-pvt",
               .maker = "Galil, PVT motion in DMC",
               .knot = "a command `PVA=p,v,t`: counts, counts/s, samples",
               .source = "Galil DMC-40x0 manual, PV and BT",
               .extension = "",
               .join = KnotJoin::cubic,
               .axis = Domain::time,
               .x_unit = "s",
               .p = Numbers::whole,
               .x_step = 2 * galil_sample,
               .keeps_units = true,
               .rests = true,
               .most = 256,
               .limits_from = "Galil's buffer holds 255 segments",
               .not_kept = "the motion counts from the position at its start"},
    .detects = [](const std::string& text) { return has_command(text, "PVA="); },
    .read = read_galil_pvt,
    .write = galil_pvt_text};

}  // namespace jounce::controllers_detail
