#include <utility>

#include "jounce/io/detail/spec_parts.hpp"
#include "jounce/io/units.hpp"

namespace jounce::detail {
namespace {

std::optional<Bound> read_bound(TomlReader& free, const char* key, const std::string& unit) {
  const auto pair = free.optional_pair(key, unit);
  if (!pair) return std::nullopt;
  return Bound{pair->first, pair->second};
}

void read_free(TomlReader& owner, std::size_t knot, const Units& units, OptimizeSpec& optimize) {
  auto free = owner.optional_table("free");
  if (!free) return;
  FreeKnot f;
  f.knot = knot;
  f.master = read_bound(*free, "master", units.x);
  f.slave = read_bound(*free, "slave", units.position);
  f.geo_velocity = read_bound(*free, "geo_velocity", rate_unit(units.position, units.x, 1));
  f.geo_acceleration = read_bound(*free, "geo_acceleration", rate_unit(units.position, units.x, 2));
  free->finish();
  optimize.free.push_back(f);
}

CamKnot read_knot(TomlReader& knot, const Units& units) {
  CamKnot k;
  k.master = knot.number("master", units.x);
  k.slave = knot.number("slave", units.position);
  k.geo_velocity = knot.optional_number("geo_velocity", rate_unit(units.position, units.x, 1));
  k.geo_acceleration =
      knot.optional_number("geo_acceleration", rate_unit(units.position, units.x, 2));
  return k;
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const LawInfo& law : all_laws()) names.emplace_back(law.name);
  return names;
}

}  // namespace

CamSpec read_cam(TomlReader& top, const Units& units, OptimizeSpec& optimize) {
  CamSpec cam;
  cam.periodic = top.optional_flag("periodic").value_or(false);
  TomlReader start = top.table("start");
  cam.start = read_knot(start, units);
  read_free(start, 0, units, optimize);
  start.finish();
  for (TomlReader& segment : top.tables("segment")) {
    CamSegment s;
    s.name = segment.optional_text("name").value_or("");
    s.law = all_laws()[segment.choice("law", law_names())].law;
    TomlReader end = segment.table("end");
    s.end = read_knot(end, units);
    end.finish();
    cam.segments.push_back(std::move(s));
    read_free(segment, cam.segments.size(), units, optimize);
    segment.finish();
  }
  return cam;
}

void read_optimize(TomlReader& top, OptimizeSpec& optimize) {
  auto table = top.optional_table("optimize");
  if (!table) return;
  std::vector<Objective> minimize;
  for (const auto& text : table->texts("minimize")) {
    const auto objective = objective_named(text);
    if (!objective)
      table->fail(
          "minimize", '"' + text + '"',
          "must be among \"peak geo_acceleration\", \"peak geo_jerk\", \"rms geo_acceleration\"");
    minimize.push_back(*objective);
  }
  if (!minimize.empty()) optimize.minimize = std::move(minimize);
  optimize.seed = table->optional_count("seed");
  optimize.starts = table->optional_count("starts");
  if (optimize.starts.value_or(1) > 10'000)
    table->fail("starts", std::to_string(*optimize.starts), "must be at most 10000");
  optimize.tolerance = table->optional_number("tolerance", "1");
  table->finish();
}

}  // namespace jounce::detail
