#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/io/detail/point_file.hpp"
#include "jounce/io/detail/spec_parts.hpp"
#include "jounce/io/units.hpp"

namespace jounce::detail {
namespace {

const std::vector<std::string> controllers{"googol", "pmc600"};
const std::vector<std::string> types{"normal", "even", "stop", "continue"};
const std::vector<std::string> quantities{"position", "velocity", "acceleration"};
const std::vector<std::string> position_rules{"cubic", "linear"};

/// A point counts from the table's origin, or (increments) from the point before.
std::vector<PtPoint> read_points(TomlReader& top, const Units& units, bool increments,
                                 std::span<const std::string> permitted) {
  if (const auto file = read_point_file(top, "point", {"time", "position", "type"}))
    return pt_points(*file, {"time", units.x}, {"position", units.position}, increments, permitted);
  std::vector<PtPoint> points;
  PtPoint before;
  for (TomlReader& reader : top.tables("point")) {
    PtPoint point;
    point.x = reader.number("time", units.x);
    point.position = reader.number("position", units.position);
    if (increments && !(point.x > 0))
      reader.fail("time", number(point.x), "an increment must be greater than 0");
    if (const auto type = reader.optional_choice("type", permitted))
      point.type = static_cast<PtType>(*type);
    reader.finish();
    if (increments) point = {before.x + point.x, before.position + point.position, point.type};
    points.push_back(point);
    before = point;
  }
  return points;
}

PtSpec read_pt_table(TomlReader& top, TomlReader& pt, const Units& units, bool googol) {
  PtSpec spec;
  spec.googol = googol;
  const bool increments = pt.optional_flag("increments").value_or(false);
  const std::int64_t loops = pt.optional_whole("loops").value_or(1);
  if (loops < 0) pt.fail("loops", std::to_string(loops), "must be at least 1, or 0: without end");
  spec.loops = static_cast<std::size_t>(loops);
  std::span<const std::string> permitted = types;
  if (googol) {
    permitted = permitted.first(3);
  } else {
    spec.start_velocity =
        pt.optional_number("start_velocity", rate_unit(units.position, units.x, 1)).value_or(0);
  }
  if (spec.loops == 0 && pt.has("outside"))
    pt.fail("outside", "", "goes with an end: loops = 0 has none");
  spec.outside = read_outside(pt, false);
  spec.points = read_points(top, units, increments, permitted);
  return spec;
}

std::optional<int> optional_int(TomlReader& reader, const char* key) {
  const auto value = reader.optional_count(key);
  if (!value) return std::nullopt;
  return static_cast<int>(std::min<std::size_t>(*value, 1'000'000));
}

/// TIME counts whole ms.
double read_delta_time(TomlReader& point) {
  const double t = point.number("delta_time", "s");
  const double ms = 1000 * t;
  const bool vanishes = t != 0 && std::round(ms) == 0;  // 1e-12 s is not 0 ms
  if (vanishes || std::abs(ms - std::round(ms)) > 1e-9 * std::max(1.0, std::abs(ms)))
    point.fail("delta_time", number(t), "must be a whole number of ms, as TIME is");
  return t;
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
  table.number_of_pairs = optional_int(pt, "number_of_pairs");
  table.array_size = optional_int(pt, "array_size");
  table.from = pt.optional_number("from", rate(0)).value_or(table.from);
  table.from_velocity = pt.optional_number("from_velocity", rate(1)).value_or(table.from_velocity);
  if (order == 2)
    table.from_acceleration =
        pt.optional_number("from_acceleration", rate(2)).value_or(table.from_acceleration);
  if (order == 0)
    if (const auto rule = pt.optional_choice("rule", position_rules))
      spec.rule = static_cast<pmc600::PositionRule>(*rule);
  spec.outside = read_outside(pt, false);
  for (TomlReader& point : top.tables("point")) {
    const double delta_time = read_delta_time(point);
    table.points.push_back({delta_time, point.number(quantities[order].c_str(), rate(order))});
    point.finish();
  }
  return spec;
}

}  // namespace

Outside read_outside(TomlReader& reader, bool may_repeat) {
  static const std::vector<std::string> names{"refuse", "hold", "wrap", "advance"};
  const auto permitted = std::span(names).first(may_repeat ? 4 : 2);
  const auto chosen = reader.optional_choice("outside", permitted);
  return chosen ? static_cast<Outside>(*chosen) : Outside::hold;
}

TimeTableSpec read_time_table(TomlReader& top, const Units& units) {
  TomlReader pt = top.table("pt");
  const auto controller = pt.optional_choice("controller", controllers);
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

}  // namespace jounce::detail
