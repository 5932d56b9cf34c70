// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "spec/src/toml/parts.hpp"
#include "spec/src/toml/point_file.hpp"

namespace jounce::spec_detail {
namespace {

using profiles_detail::rounded_input;

const std::vector<std::string> pt_controllers{"googol", "pmc600"};
const std::vector<std::string> point_types{"normal", "even", "stop", "continue"};
const std::vector<std::string> quantities{"position", "velocity", "acceleration"};
const std::vector<std::string> position_rules{"cubic", "linear"};

/// Reads points, which count from the origin of the table, or increments, which count from the
/// previous point.
std::vector<PtPoint> read_points(TomlReader& top, const Units& units, bool increments,
                                 std::span<const std::string> permitted) {
  std::vector<PtPoint> points;
  PtPoint before;
  for (TomlReader& reader : top.tables("point")) {
    PtPoint point;
    point.x = reader.number("time", units.x);
    point.position = reader.number("position", units.position);
    if (increments && !(point.x > 0))
      reader.fail(
          "time", number(point.x),
          "must be greater than 0: with increments = true it counts from the previous point");
    if (const auto type = reader.optional_choice("type", permitted))
      point.type = static_cast<PtType>(*type);
    reader.finish();
    if (increments) point = {before.x + point.x, before.position + point.position, point.type};
    points.push_back(point);
    before = point;
  }
  return points;
}

/// Checks the points of a file here, so that an error names the line of the file.
PtSpec with_points(PtSpec spec, const Points& file, const Units& units, bool increments,
                   std::span<const std::string> permitted) {
  spec.points =
      pt_points(file, {"time", units.x}, {"position", units.position}, increments, permitted);
  placed_in(file, {{"time", units.x}, {"position", units.position}},
            [&] { return motion_of(spec); });
  return spec;
}

PtSpec read_pt_table(TomlReader& top, TomlReader& pt, const Units& units, bool googol) {
  PtSpec spec;
  spec.googol = googol;
  const bool increments = pt.optional_flag("increments").value_or(false);
  const std::int64_t loops = pt.optional_whole("loops").value_or(1);
  if (loops < 0)
    pt.fail("loops", std::to_string(loops), "must be at least 1, or 0 for an endless table");
  spec.loops = static_cast<std::size_t>(loops);
  std::span<const std::string> permitted = point_types;
  if (googol) {
    permitted = permitted.first(3);
  } else {
    spec.start_velocity =
        pt.optional_number("start_velocity", rate_unit(units.position, units.x, 1)).value_or(0);
  }
  if (spec.loops == 0 && pt.has("outside"))
    pt.fail(
        "outside", "",
        "does not apply to loops = 0, because such a table has no end: leave one of the two out");
  spec.outside = read_outside(pt, false);
  if (const auto file = read_point_file(top, "point", {"time", "position", "type"}))
    return with_points(std::move(spec), *file, units, increments, permitted);
  spec.points = read_points(top, units, increments, permitted);
  return spec;
}

std::optional<int> capped_count(TomlReader& reader, const char* key) {
  const auto value = reader.optional_count(key);
  if (!value) return std::nullopt;
  return static_cast<int>(std::min<std::size_t>(*value, 1'000'000));
}

/// TIME counts ms; 1e-12 s is not 0 ms.
bool is_whole_ms(double t) {
  const double ms = 1000 * t;
  const bool vanishes = t != 0 && std::round(ms) == 0;
  return !vanishes && std::abs(ms - std::round(ms)) <= rounded_input * std::max(1.0, std::abs(ms));
}
constexpr const char* whole_ms_rule =
    "must be a whole number of ms, the resolution of the data type TIME";

/// Reads a point; its value has the name of the quantity as its key.
pmc600::ProfilePoint read_profile_point(TomlReader& point, const char* quantity,
                                        const std::string& unit) {
  const double t = point.number("delta_time", "s");
  if (!is_whole_ms(t)) point.fail("delta_time", number(t), whole_ms_rule);
  const double value = point.number(quantity, unit);
  point.finish();
  return {t, value};
}

std::vector<pmc600::ProfilePoint> profile_points(const Points& file, const char* quantity,
                                                 const std::string& unit) {
  const std::vector<double> times = file.in_unit("delta_time", "s");
  const std::vector<double> values = file.in_unit(quantity, unit);
  std::vector<pmc600::ProfilePoint> points;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!is_whole_ms(times[i])) throw file.error(i, "delta_time", times[i], "s", whole_ms_rule);
    points.push_back({times[i], values[i]});
  }
  return points;
}

ProfileTableSpec read_profile_table(TomlReader& top, TomlReader& pt, const Units& units) {
  ProfileTableSpec spec;
  const std::size_t order = pt.choice("quantity", quantities);
  spec.quantity = static_cast<ProfileTableSpec::Quantity>(order);
  const auto rate = [&](std::size_t k) {
    return rate_unit(units.position, units.x, static_cast<int>(k));
  };
  pmc600::ProfileTable& table = spec.table;
  table.is_absolute = pt.optional_flag("is_absolute").value_or(table.is_absolute);
  table.scale = pt.optional_number("scale", "1").value_or(table.scale);
  table.offset = pt.optional_number("offset", rate(order)).value_or(table.offset);
  table.number_of_pairs = capped_count(pt, "number_of_pairs");
  table.array_size = capped_count(pt, "array_size");
  table.from = pt.optional_number("from", rate(0)).value_or(table.from);
  table.from_velocity = pt.optional_number("from_velocity", rate(1)).value_or(table.from_velocity);
  if (order == 2)
    table.from_acceleration =
        pt.optional_number("from_acceleration", rate(2)).value_or(table.from_acceleration);
  if (order == 0)
    if (const auto rule = pt.optional_choice("rule", position_rules))
      spec.rule = static_cast<pmc600::PositionRule>(*rule);
  spec.outside = read_outside(pt, false);
  const char* const quantity = quantities[order].c_str();
  if (const auto file = read_point_file(top, "point", {"delta_time", quantity})) {
    table.points = profile_points(*file, quantity, rate(order));
    placed_in(*file, {{"delta_time", "s"}, {quantity, rate(order)}},
              [&] { return motion_of(spec); });
    return spec;
  }
  for (TomlReader& point : top.tables("point"))
    table.points.push_back(read_profile_point(point, quantity, rate(order)));
  return spec;
}

}  // namespace

Extrapolation read_outside(TomlReader& reader, bool may_repeat) {
  static const std::vector<std::string> names{"refuse", "hold", "wrap", "advance"};
  const auto permitted = std::span(names).first(may_repeat ? 4 : 2);
  const auto chosen = reader.optional_choice("outside", permitted);
  return chosen ? static_cast<Extrapolation>(*chosen) : Extrapolation::hold;
}

TimeTableSpec read_time_table(TomlReader& top, const Units& units) {
  TomlReader pt = top.table("pt");
  const auto controller = pt.optional_choice("controller", pt_controllers);
  TimeTableSpec spec;
  if (controller == 1U) {
    require_unit("time", units.x, "s", "PMC600");
    spec = read_profile_table(top, pt, units);
  } else {
    if (controller) {
      require_unit("position", units.position, "pulse", "Googol");
      require_unit("time", units.x, "ms", "Googol");
    }
    spec = read_pt_table(top, pt, units, controller.has_value());
  }
  pt.finish();
  return spec;
}

}  // namespace jounce::spec_detail
