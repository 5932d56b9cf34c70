// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

constexpr std::array modes{CompareMode::equal,     CompareMode::less,   CompareMode::greater,
                           CompareMode::fifo_time, CompareMode::linear, CompareMode::fifo_level};
const std::vector<std::string> mode_names{"equal",     "less",   "greater",
                                          "fifo_time", "linear", "fifo_level"};

const std::vector<std::string> sources{"position", "actual"};

/// The number of points on a line, 1 to 1e7.
std::int64_t count_of(TomlReader& compare) {
  const std::int64_t count = compare.whole("count");
  if (count < 1 || count > 10'000'000)
    compare.fail("count", std::to_string(count), "must be 1 to 1e7");
  return count;
}

/// position; or start, increment and count; or [[compare.point]].
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

}  // namespace

std::optional<CompareSpec> read_compare(TomlReader& top, const Spec& spec) {
  auto compare = top.optional_table("compare");
  if (!compare) return std::nullopt;
  CompareSpec read;
  read.axis = compare->optional_text("axis").value_or("");
  const std::vector<AxisPart> parts = spec.parts();
  const auto part = std::find_if(parts.begin(), parts.end(),
                                 [&](const AxisPart& each) { return each.name == read.axis; });
  if (part == parts.end())
    compare->fail("axis", '"' + read.axis + '"', "must be the name of an axis of this spec");
  if (std::holds_alternative<AxisSpec>(spec.subject) &&
      compare->optional_choice("of", sources).value_or(0) == 1)
    read.of = SwitchesOf::actual;
  PositionCompare& c = read.compare;
  c.mode = modes[compare->choice("mode", mode_names)];
  c.points = read_points(*compare, part->units, c.mode);
  if (c.mode == CompareMode::fifo_time || c.mode == CompareMode::linear) {
    c.pulse = compare->number("pulse", spec.time_unit);
    if (!(c.pulse > 0)) compare->fail("pulse", number(c.pulse), "must be greater than 0");
  }
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
