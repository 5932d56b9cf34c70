// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/edit.hpp"

#include <cassert>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "jounce/profiles/error.hpp"

#include "spec/src/toml/toml_editor.hpp"

namespace jounce {
namespace {

using spec_detail::TomlEditor;

/// Sets a number of a knot. A missing key is added below the master, if that is permitted.
void set(TomlEditor& editor, const toml::table& table, const char* key, double before, double after,
         bool may_add) {
  if (before == after) return;
  if (table.get(key) != nullptr)
    editor.replace(table, key, number(after));
  else if (may_add)
    editor.add(table, "master", key, number(after));
}

/// A derivative of a knot, under the key that its table has: by the master, or over time at the speed of the master.
void set_rate(TomlEditor& editor, const Spec& spec, const toml::table& table, std::size_t order,
              double before, double after, bool may_add) {
  const char* const timed = OverTime::names[order];
  if (table.get(timed) == nullptr)
    return set(editor, table, OverMaster::names[order], before, after, may_add);
  const double rate = std::pow(spec.master->velocity, order);
  set(editor, table, timed, before * rate, after * rate, false);
}

void set(TomlEditor& editor, const Spec& spec, const toml::table& table, const CamKnot& before,
         const CamKnot& after) {
  set(editor, table, "master", before.master, after.master, false);
  set(editor, table, "slave", before.slave, after.slave, false);
  set_rate(editor, spec, table, 1, *before.geo_velocity, *after.geo_velocity, true);
  set_rate(editor, spec, table, 2, *before.geo_acceleration, *after.geo_acceleration, true);
}

std::string line_of(const CamPoint& point) {
  std::string line = "  { master = " + number(point.master);
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) line += std::string(", ") + key + " = " + number(*value);
  };
  add("slave", point.slave);
  add("geo_velocity", point.geo_velocity);
  add("geo_acceleration", point.geo_acceleration);
  add("geo_jerk", point.geo_jerk);
  return line + " },\n";
}

std::string list_of(const std::vector<CamPoint>& points) {
  std::string list = fmt::format("[  # {} points, by `jounce optimize`\n", points.size());
  for (const CamPoint& point : points) list += line_of(point);
  return list + "]";
}

void set_law(TomlEditor& editor, const toml::table& segment, const CamSegment& after) {
  editor.replace(segment, "law", std::string("\"") + name(after.law) + "\"");
  for (const char* key : {"inflection", "straight", "shares"}) editor.erase(segment, key);
  const toml::node* points = segment.get("points");
  const bool tables = points != nullptr && points->is_array_of_tables() &&
                      !points->as_array()->front().as_table()->is_inline();
  if (points != nullptr && !tables) {
    editor.replace(segment, "points", list_of(after.points));
    return;
  }
  if (tables) editor.erase(segment, "points");
  editor.add(segment, "law", "points", list_of(after.points));
}

/// Changes values that are in the text; adds nothing.
void set_given(TomlEditor& editor, const Spec& spec, const toml::table& table,
               const CamKnot& before, const CamKnot& after) {
  set(editor, table, "slave", before.slave, after.slave, false);
  if (after.geo_velocity)
    set_rate(editor, spec, table, 1, before.geo_velocity.value_or(0), *after.geo_velocity, false);
  if (after.geo_acceleration)
    set_rate(editor, spec, table, 2, before.geo_acceleration.value_or(0), *after.geo_acceleration,
             false);
}

toml::table parsed(const Spec& spec) {
  return toml::parse(std::string_view(spec.document.text), std::string_view(spec.document.name));
}

}  // namespace

std::string with_knots(const Spec& spec, const CamSpec& cam) {
  const toml::table root = parsed(spec);
  const auto before = resolved_knots(std::get<CamSpec>(spec.subject));
  const auto after = resolved_knots(cam);
  assert(before.size() == after.size());
  TomlEditor editor(spec.document.text);
  set(editor, spec, *root.get("start")->as_table(), before[0], after[0]);
  for (std::size_t i = 1; i < after.size(); ++i)
    set(editor, spec, *root["segment"][i - 1]["end"].as_table(), before[i], after[i]);
  return editor.result();
}

std::string with_shapes(const Spec& spec, const CamSpec& cam) {
  const toml::table root = parsed(spec);
  const auto& before = std::get<CamSpec>(spec.subject);
  TomlEditor editor(spec.document.text);
  set_given(editor, spec, *root.get("start")->as_table(), before.start, cam.start);
  for (const FreeShape& shape : spec.optimize.shape.shapes)
    set_law(editor, *root["segment"][shape.segment].as_table(), cam.segments[shape.segment]);
  for (std::size_t i = 0; i < cam.segments.size(); ++i)
    set_given(editor, spec, *root["segment"][i]["end"].as_table(), before.segments[i].end,
              cam.segments[i].end);
  return editor.result();
}

}  // namespace jounce
