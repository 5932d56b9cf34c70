// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <utility>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
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
  if (knot > 0) read_free_shape(*free, knot - 1, optimize.shape);
  free->finish();
  const bool nothing = !f.master && !f.slave && !f.geo_velocity && !f.geo_acceleration;
  const bool shape =
      !optimize.shape.shapes.empty() && optimize.shape.shapes.back().segment + 1 == knot;
  if (!(nothing && shape)) optimize.free.push_back(f);
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

CamPoint read_point(TomlReader& point, const Units& units) {
  CamPoint p;
  p.master = point.number("master", units.x);
  p.slave = point.optional_number("slave", units.position);
  p.geo_velocity = point.optional_number("geo_velocity", rate_unit(units.position, units.x, 1));
  p.geo_acceleration =
      point.optional_number("geo_acceleration", rate_unit(units.position, units.x, 2));
  p.geo_jerk = point.optional_number("geo_jerk", rate_unit(units.position, units.x, 3));
  p.tolerance = point.optional_number("tolerance", units.position).value_or(0);
  point.finish();
  return p;
}

const std::array<std::string, 3> boundaries{"rest", "minimum_jerk", "minimum_peak_acceleration"};

}  // namespace

std::optional<Law> read_law(TomlReader& owner, const char* key) {
  const auto chosen = owner.optional_choice(key, law_names());
  if (!chosen) return std::nullopt;
  return all_laws()[*chosen].law;
}

LawForm read_form(TomlReader& segment) {
  LawForm form;
  form.inflection = segment.optional_number("inflection", "1");
  form.straight = segment.optional_number("straight", "1");
  const std::array<std::string, 3> shares{"1", "1", "1"};
  if (const auto given = segment.numbers("shares", shares); !given.empty())
    form.shares = {given[0], given[1], given[2]};
  return form;
}

CamSpec read_cam(TomlReader& top, const Units& units, Spec& spec) {
  OptimizeSpec& optimize = spec.optimize;
  CamSpec cam;
  cam.periodic = top.optional_flag("periodic").value_or(false);
  cam.slave_period = top.optional_number("slave_period", units.position);
  if (const auto chosen = top.optional_choice("boundaries", boundaries))
    spec.boundaries = static_cast<Boundaries>(*chosen);
  TomlReader start = top.table("start", "start = { master = 0, slave = 0 }");
  cam.start = read_knot(start, units);
  read_free(start, 0, units, optimize);
  start.finish();
  top.for_each("segment", [&](TomlReader& segment) {
    CamSegment s;
    s.name = segment.optional_text("name").value_or("");
    s.form = read_form(segment);
    for (TomlReader& point : segment.tables("points")) s.points.push_back(read_point(point, units));
    s.law = all_laws()[segment.choice("law", law_names())].law;
    TomlReader end = segment.table("end", "end = { master = NUMBER, slave = NUMBER }");
    s.end = read_knot(end, units);
    end.finish();
    cam.segments.push_back(std::move(s));
    read_free(segment, cam.segments.size(), units, optimize);
    segment.finish();
  });
  return cam;
}

namespace {

void read_knot_optimize(TomlReader& table, OptimizeSpec& optimize) {
  std::vector<Objective> minimize;
  for (const auto& text : table.texts("minimize")) {
    const auto objective = objective_named(text);
    if (!objective)
      table.fail("minimize", '"' + text + '"',
                 "must be one or more of \"peak geo_acceleration\", \"peak geo_jerk\", \"rms "
                 "geo_acceleration\"; for any other figure, give a segment a free shape: free = { "
                 "shape = 100 }");
    minimize.push_back(*objective);
  }
  if (!minimize.empty()) optimize.minimize = std::move(minimize);
  optimize.seed = table.optional_count("seed");
  optimize.starts = table.optional_count("starts");
  if (optimize.starts.value_or(1) > 10'000)
    table.fail("starts", std::to_string(*optimize.starts), "must be at most 10000");
  optimize.tolerance = table.optional_number("tolerance", "1");
  optimize.seconds = read_budget(table);
}

}  // namespace

std::optional<double> read_budget(TomlReader& table) {
  const auto seconds = table.optional_number("budget", "s");
  if (seconds && !(*seconds > 0)) table.fail("budget", number(*seconds), "must be greater than 0");
  return seconds;
}

void read_optimize(TomlReader& top, Spec& spec) {
  const auto& load = spec.optimize.shape.load = read_load(top, spec.units);
  if (load && (load->limits.torque || load->limits.rms_torque) && !spec.master)
    top.fail("load", "", "limits a torque, which depends on the speed: add [master]");
  auto table = top.optional_table("optimize");
  const bool shapes = !spec.optimize.shape.shapes.empty();
  if (shapes && !table)
    top.fail("optimize", "",
             "is missing: a free shape needs an objective. Add [optimize] with minimize = "
             "[\"peak geo_jerk\"]");
  if (!table || table->has("parameter")) return;  // read_parameters() reads [[optimize.parameter]]
  if (shapes)
    read_shape_optimize(*table, spec);
  else
    read_knot_optimize(*table, spec.optimize);
  table->finish();
}

}  // namespace jounce::spec_detail
