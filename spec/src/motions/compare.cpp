// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

constexpr std::array compare_modes{CompareMode::equal,   CompareMode::less,
                                   CompareMode::greater, CompareMode::fifo_time,
                                   CompareMode::linear,  CompareMode::fifo_level};
const std::vector<std::string> mode_names{"equal",  "less",       "greater", "fifo_time",
                                          "linear", "fifo_level", "zone",    "zone_equal"};

const std::vector<std::string> compare_sources{"position", "actual"};

/// Reads the number of points on a line, 1 to 1e7.
std::int64_t count_of(TomlReader& compare) {
  const std::int64_t count = compare.whole("count");
  if (count < 1 || count > 10'000'000)
    compare.fail("count", std::to_string(count), "must be a whole number from 1 to 10000000");
  return count;
}

/// Reads position; or start, increment and count; or [[compare.point]].
std::vector<ComparePoint> read_points(TomlReader& compare, const Units& units, CompareMode mode) {
  if (mode == CompareMode::linear) {
    const double start = compare.number("start", units.position);
    const double increment = compare.number("increment", units.position);
    if (increment == 0) compare.fail("increment", "0", "must not be 0: all points would coincide");
    return evenly(start, increment, static_cast<std::size_t>(count_of(compare)));
  }
  if (mode != CompareMode::fifo_time && mode != CompareMode::fifo_level)
    return {{compare.number("position", units.position)}};
  std::vector<ComparePoint> points;
  for (TomlReader& point : compare.tables("point")) {
    points.push_back({point.number("position", units.position)});
    if (mode == CompareMode::fifo_level)
      points.back().level = point.optional_flag("level").value_or(true);
    point.finish();
  }
  if (points.empty())
    compare.fail("point", "", "is missing: add [[compare.point]] with a position for each point");
  return points;
}

/// Reads key = [x, y]: one number for each of two axes. Required.
std::vector<double> read_pair(TomlReader& reader, const char* key,
                              const std::vector<std::string>& units) {
  if (!reader.has(key)) reader.refuse_misspelt(key);
  if (!reader.has(key)) reader.fail(key, "", "is missing: a zone needs two numbers, [x, y]");
  return reader.numbers(key, units);
}

/// Reads the modes "zone" and "zone_equal" of two axes: axes, band, and [[compare.point]] with at
/// and output.
PlaneCompare read_zone(TomlReader& compare, const std::vector<AxisPart>& parts,
                       std::array<std::string, 2>& axes) {
  const std::vector<std::string> names = compare.texts("axes");
  std::vector<std::string> units;
  for (const std::string& name : names)
    for (const AxisPart& part : parts)
      if (part.name == name) units.push_back(part.units.position);
  if (names.size() != 2 || units.size() != 2 || names[0] == names[1])
    compare.fail("axes", "", "must name two different axes of the spec");
  std::copy_n(names.begin(), 2, axes.begin());
  PlaneCompare zone;
  const std::vector<double> band = read_pair(compare, "band", units);
  zone.x_band = band[0];
  zone.y_band = band[1];
  for (TomlReader& point : compare.tables("point")) {
    const std::vector<double> at = read_pair(point, "at", units);
    zone.points.push_back(
        {at[0], at[1], static_cast<int>(point.optional_whole("output").value_or(1))});
    point.finish();
  }
  if (zone.points.empty())
    compare.fail("point", "", "is missing: give each point as [[compare.point]] with at");
  if (!(zone.x_band > 0 && zone.y_band > 0))
    compare.fail("band", "", "must be greater than 0 for both axes");
  return zone;
}

double read_pulse(TomlReader& compare, const Spec& spec) {
  const double pulse = compare.number("pulse", spec.time_unit);
  if (!(pulse > 0)) compare.fail("pulse", number(pulse), "must be greater than 0");
  return pulse;
}

/// The unit of the compared position.
Units compared_units(TomlReader& compare, const Spec& spec, const std::string& axis) {
  for (const AxisPart& part : spec.parts())
    if (part.name == axis) return part.units;
  const bool path = std::holds_alternative<PathSpec>(spec.subject);
  if (path && axis == "path") return spec.units;
  std::string names;
  for (const AxisPart& part : spec.parts()) names += (names.empty() ? "" : ", ") + part.name;
  if (names.empty())
    compare.fail("axis", '"' + axis + '"', "this spec has a single axis: leave axis out");
  if (path) names += " or path";
  if (axis.empty()) compare.fail("axis", "", "is missing: add axis = \"NAME\", one of " + names);
  compare.fail("axis", '"' + axis + '"', "must be one of the axes of this spec: " + names);
  return spec.units;
}

}  // namespace

std::optional<CompareSpec> read_compare(TomlReader& top, const Spec& spec) {
  auto compare = top.optional_table("compare");
  if (!compare) return std::nullopt;
  CompareSpec read;
  const std::size_t mode = compare->choice("mode", mode_names);
  if (mode >= compare_modes.size()) {
    PlaneCompare& zone = read.plane.emplace(read_zone(*compare, spec.parts(), read.plane_axes));
    zone.equal = mode > compare_modes.size();
    zone.pulse = read_pulse(*compare, spec);
    compare->finish();
    return read;
  }
  read.axis = compare->optional_text("axis").value_or("");
  const Units units = compared_units(*compare, spec, read.axis);
  if (std::holds_alternative<AxisSpec>(spec.subject) &&
      compare->optional_choice("of", compare_sources).value_or(0) == 1)
    read.of = SwitchesOf::actual;
  PositionCompare& c = read.compare;
  c.mode = compare_modes[mode];
  c.points = read_points(*compare, units, c.mode);
  if (c.mode == CompareMode::fifo_time || c.mode == CompareMode::linear)
    c.pulse = read_pulse(*compare, spec);
  if (auto device = compare->optional_table("device")) {
    const std::string frequency = rate_unit("", spec.time_unit, 1);
    for (const auto& [key, unit, value] :
         {std::tuple{"sampling_frequency", frequency, &read.device.sampling_frequency},
          {"latency", spec.time_unit, &read.device.latency}}) {
      *value = device->optional_number(key, unit).value_or(0);
      if (!(*value >= 0)) device->fail(key, number(*value), "must not be negative");
    }
    device->finish();
  }
  compare->finish();
  return read;
}

}  // namespace jounce::spec_detail
