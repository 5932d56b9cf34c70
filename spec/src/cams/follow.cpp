// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/controllers/detail/time_table_limits.hpp"

#include "spec/src/toml/parts.hpp"
#include "spec/src/toml/point_file.hpp"

namespace jounce::spec_detail {
namespace {

const std::array<std::string, 4> types{"normal", "even", "stop", "continue"};
const std::array<std::string, 2> forms{"smooth", "table"};

/// The segments of a file, counted from the origin of the table.
std::vector<PtPoint> segments_of(const Points& file, const Units& units, bool increments,
                                 bool googol) {
  std::vector<PtPoint> points =
      pt_points(file, {"master", units.x}, {"slave", units.position}, increments, types);
  try {
    (void)pt_rates<OverMaster>(points);
  } catch (const InputError& error) {
    std::string key = error.key();
    if (key.ends_with(".position")) key.replace(key.size() - 8, 8, "slave");
    throw placed(InputError(key, error.value(), error.rule()), file,
                 {{"master", units.x}, {"slave", units.position}});
  }
  for (std::size_t i = 0; googol && i < points.size(); ++i)
    if (const std::string rule = googol::broken_follow_rule(points[i].x); !rule.empty())
      throw file.error(i, "master", points[i].x, units.x, rule);
  return points;
}

/// Reads [[segment]] with `repeat`. Positions are cumulative, or increments (`increments`), which
/// are added up.
void read_segments(TomlReader& owner, const Units& units, bool increments, bool googol,
                   std::vector<PtPoint>& points) {
  constexpr std::size_t most = 1'000'000;
  if (const auto file = read_point_file(owner, "segment", {"master", "slave", "type"})) {
    points = segments_of(*file, units, increments, googol);
    return;
  }
  PtPoint at;
  for (TomlReader& segment : owner.tables("segment")) {
    const double master = segment.number("master", units.x);
    const double slave = segment.number("slave", units.position);
    at.type = static_cast<PtType>(segment.optional_choice("type", types).value_or(0));
    const std::size_t repeat = segment.optional_count("repeat").value_or(1);
    if (segment.has("repeat") && !increments)
      segment.fail("repeat", std::to_string(repeat),
                   "needs increments = true: add it, or leave repeat out");
    if (increments && !(master > 0))
      segment.fail(
          "master", number(master),
          "must be greater than 0: with increments = true it counts from the previous segment");
    if (repeat < 1 || repeat > most - points.size())
      segment.fail("repeat", std::to_string(repeat),
                   "must be at least 1, and make at most 1e6 segments");
    for (std::size_t i = 0; i < repeat; ++i) {
      at.x = increments ? at.x + master : master;
      at.position = increments ? at.position + slave : slave;
      points.push_back(at);
      const std::string rule = googol ? googol::broken_follow_rule(at.x) : "";
      if (!rule.empty()) segment.fail("master", number(at.x), rule);
    }
    segment.finish();
  }
}

/// Reads loops, end, increments, and the segments.
FollowTable read_table(TomlReader& keys, TomlReader& segments, const Units& units, bool googol) {
  FollowTable table;
  table.loops = keys.optional_whole("loops").value_or(1);
  const bool increments = keys.optional_flag("increments").value_or(false);
  if (auto end = keys.optional_table("end")) {
    table.end = {end->number("master", units.x), end->number("slave", units.position)};
    end->finish();
  }
  read_segments(segments, units, increments, googol, table.segments);
  if (const std::size_t n = table.segments.size(); googol && n > googol::follow_fifo)
    segments.fail(
        segments.has("points") ? "points" : "segment", std::to_string(n) + " segments",
        "must be at most 512 in a table: the FIFO of the controller holds no more (memory 1)");
  return table;
}

FollowSpec read_tables(TomlReader& top, TomlReader& follow, const Units& units,
                       const std::string& ratio) {
  FollowSpec spec;
  spec.start_ratio = follow.optional_number("start_ratio", ratio).value_or(0);
  static const std::array<std::string, 1> controllers{"googol"};
  const bool googol = follow.optional_choice("controller", controllers).has_value();
  if (googol) {
    require_unit("master", units.x, "pulse", "Googol");
    require_unit("position", units.position, "pulse", "Googol");
  }
  const bool one = top.has("segment") || top.has("points");
  if (one) spec.tables.push_back(read_table(follow, top, units, googol));
  if (one && follow.has("table"))
    top.fail(top.has("segment") ? "segment" : "points", "",
             "applies to a single table: with [[follow.table]], put the segments into each table");
  for (TomlReader& table : follow.tables("table")) {
    spec.tables.push_back(read_table(table, table, units, googol));
    table.finish();
  }
  return spec;
}

void read_points(TomlReader& top, const Units& units, const std::string& ratio, FollowPlan& plan) {
  for (TomlReader& point : top.tables("point")) {
    plan.points.push_back({point.number("master", units.x), point.number("slave", units.position),
                           point.optional_number("ratio", ratio)});
    point.finish();
  }
  for (TomlReader& zone : top.tables("zone")) {
    plan.zones.push_back(
        {zone.number("from", units.x), zone.number("to", units.x), zone.number("ratio", ratio),
         zone.optional_number("slave", units.position), zone.optional_text("name").value_or("")});
    zone.finish();
  }
}

Law read_follow_law(TomlReader& follow) {
  const auto law = read_law(follow, "law");
  if (!law) return Law::quintic;
  const Ends ends = info(*law).ends;
  if (ends != Ends::given && ends != Ends::moving)
    follow.fail("law", std::string("\"") + name(*law) + '"',
                "must be a law that begins and ends at a velocity without acceleration, such as "
                "quintic or modified_sine");
  return *law;
}

FollowPlan read_plan(TomlReader& top, TomlReader& follow, const Units& units,
                     const std::string& ratio) {
  FollowPlan plan;
  plan.start_ratio = follow.optional_number("start_ratio", ratio);
  plan.periodic = follow.optional_flag("periodic").value_or(false);
  plan.form = static_cast<FollowForm>(follow.optional_choice("form", forms).value_or(0));
  if (plan.form == FollowForm::table)
    follow.refuse_here("law", "does not apply to form = \"table\": leave one of the two out");
  else
    plan.law = read_follow_law(follow);
  plan.whole_master = follow.optional_flag("whole_master").value_or(false);
  read_points(top, units, ratio, plan);
  return plan;
}

FollowStart read_start(TomlReader& follow, const Units& units) {
  auto pass = follow.optional_table("pass");
  if (!pass) return {};
  FollowStart start{FollowEvent::pass, pass->number("position", units.x)};
  start.direction = static_cast<int>(pass->optional_whole("direction").value_or(1));
  if (start.direction != 1 && start.direction != -1)
    pass->fail("direction", std::to_string(start.direction), "must be 1 or -1");
  pass->finish();
  return start;
}

int read_direction(const TomlReader& top, TomlReader& follow) {
  const std::int64_t direction = follow.optional_whole("direction").value_or(0);
  if (direction < -1 || direction > 1)
    follow.fail("direction", std::to_string(direction), "must be 1, -1 or 0 (both directions)");
  if (direction < 0 && top.has("master"))
    follow.fail("direction", std::to_string(direction),
                "lets the slave stand still, because the position of [master] rises: leave out "
                "[master], or give direction = 1");
  return static_cast<int>(direction);
}

}  // namespace

FollowPart read_follow(TomlReader& top, const Units& units) {
  const std::string ratio = rate_unit(units.position, units.x, 1);
  auto given = top.optional_table("follow");
  static const toml::table nothing;
  Document unused;
  TomlReader follow = given ? std::move(*given) : TomlReader(nothing, "follow", unused);
  FollowPart part;
  part.start = read_start(follow, units);
  part.direction = read_direction(top, follow);
  const bool plan = top.has("point") || top.has("zone");
  if (plan) {
    const std::string rule =
        "cannot be combined with [[point]] and [[zone]]: leave it out, or remove these sections";
    for (const char* key : {"segment", "points"}) top.refuse_here(key, rule);
    for (const char* key : {"table", "controller", "end", "increments", "loops"})
      follow.refuse_here(key, rule);
  } else {
    for (const char* key : {"periodic", "form", "law", "whole_master"})
      follow.refuse_here(key, "applies only to [[point]] and [[zone]]: leave it out");
  }
  if (plan)
    part.slave = read_plan(top, follow, units, ratio);
  else
    part.slave = read_tables(top, follow, units, ratio);
  if (!plan && std::get<FollowSpec>(part.slave).tables.empty())
    top.fail("segment", "",
             "is missing: give [[segment]], [[follow.table]], or [[point]] and [[zone]]");
  follow.finish();
  return part;
}

}  // namespace jounce::spec_detail
