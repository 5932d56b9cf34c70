// SPDX-License-Identifier: Apache-2.0
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "jounce/path/rotary.hpp"

#include "spec/src/path/parts.hpp"

namespace jounce::spec_detail {
namespace {

const std::vector<std::string> corners{"stop"};
// In the order of the enum Junction.
const std::vector<std::string> junctions{"buffered",      "blending_low",  "blending_previous",
                                         "blending_next", "blending_high", "look_ahead"};
static_assert(static_cast<int>(Junction::look_ahead) == 5);

/// Reads an axis; returns true if it is a follower.
bool read_path_axis(TomlReader& axis, PathAxes& axes, Spec& spec, std::set<std::string>& taken) {
  const AxisPart& part = spec.axes.emplace_back(read_axis_part(axis, spec.units, taken));
  const bool follower = axis.optional_flag("follower").value_or(false);
  if (!follower && axes.path_axes < axes.size())
    axis.fail("follower", "",
              "is missing: an axis after a follower must be a follower too. Add follower = true, "
              "or move the axis up");
  if (!follower && part.units.position != spec.units.position)
    axis.fail(
        "unit", '"' + part.units.position + '"',
        "must be " + spec.units.position +
            ", the unit of the path's length; an axis with another unit needs follower = true");
  const auto modulo = axis.optional_positive("modulo", part.units.position);
  if (modulo && !follower)
    axis.fail("modulo", number(*modulo), "needs follower = true: a rotary axis has no length");
  axes.modulo.push_back(modulo.value_or(0));
  axes.names.push_back(part.name);
  axes.position_units.push_back(part.units.position);
  axis.finish();
  return follower;
}

PathAxes read_path_axes(TomlReader& top, Spec& spec, std::set<std::string>& taken) {
  PathAxes axes{.units = spec.units};
  top.for_each("axis", [&](TomlReader& axis) {
    if (!read_path_axis(axis, axes, spec, taken)) ++axes.path_axes;
  });
  top.refuse_misspelt("axis");  // if an axis is missing, all lists of positions are too long
  if (axes.size() == 0) top.fail("axis", "", "is missing: add [[axis]] for each axis");
  if (axes.size() > max_axes)
    top.fail("axis", std::to_string(axes.size()),
             "must be at most " + std::to_string(max_axes) + " axes");
  if (axes.path_axes == 0)
    top.fail("axis", "",
             "must have at least one that is not a follower: it measures the length of the path");
  return axes;
}

PathLimits read_path_limits(TomlReader limits, const PathAxes& axes) {
  PathLimits read;
  const auto rate = [&](const char* key, int order, double& value) {
    if (const auto given = limits.optional_positive(key, axes.unit(order))) value = *given;
  };
  rate("velocity", 1, read.velocity);
  rate("acceleration", 2, read.acceleration);
  read.deceleration = read.acceleration;
  rate("deceleration", 2, read.deceleration);
  rate("jerk", 3, read.jerk);
  rate("normal_acceleration", 2, read.normal_acceleration);
  rate("total_acceleration", 2, read.total_acceleration);
  limits.finish();
  return read;
}

/// Reads corner = "stop", or a table with the one key that limits the corner.
void read_corner(TomlReader& owner, const PathAxes& axes, PathSettings& settings) {
  if (owner.is_text("corner")) {
    if (const auto word = owner.optional_text("corner"); word != corners.front())
      owner.fail("corner", '"' + *word + '"',
                 "must be \"stop\", or a table such as { deviation = 0.05 }");
    (void)owner.choice("corner", corners);
    settings.corner = Corner::stop;
    settings.value = 0;
    return;
  }
  auto corner = owner.optional_table("corner");
  if (!corner) return;
  int given = 0;
  const auto take = [&](const std::optional<double>& value, Corner kind) {
    if (!value) return;
    settings.corner = kind;
    settings.value = *value;
    ++given;
  };
  take(corner->optional_positive("deviation", axes.unit(0)), Corner::deviation);
  take(corner->optional_positive("distance", axes.unit(0)), Corner::distance);
  take(corner->optional_positive("curvature", rate_unit("", axes.units.position, 1)),
       Corner::curvature);
  take(corner->optional_positive("velocity", axes.unit(1)), Corner::velocity);
  take(corner->optional_positive("average", axes.unit(0)), Corner::average);
  corner->finish();
  if (given != 1)
    owner.fail("corner", "",
               "must be \"stop\", or have exactly one of deviation, distance, curvature, velocity, "
               "average");
}

/// Reads overlap of [path], which replaces the corners.
std::optional<OverlapOptions> read_overlap(TomlReader& path, const PathAxes& axes) {
  auto overlap = path.optional_table("overlap");
  if (!overlap) return std::nullopt;
  if (path.has("corner"))
    path.fail(
        "corner", "",
        "cannot be combined with overlap, which rounds all corners: leave one of the two out");
  OverlapOptions read;
  if (const auto d = overlap->optional_positive("deviation", axes.unit(0))) read.deviation = *d;
  read.share = overlap->optional_number("share", "1").value_or(1);
  if (!(read.share >= 0 && read.share <= 1))
    overlap->fail("share", number(read.share), "must be 0 to 1");
  overlap->finish();
  return read;
}

/// Reads [[override]]; the ranges are those of played().
std::vector<FactorRequest> read_override(TomlReader& top, const PathAxes& axes) {
  std::vector<FactorRequest> steps;
  for (TomlReader& step : top.tables("override")) {
    steps.push_back({step.number("time", axes.units.x), step.number("factor", "1")});
    step.finish();
  }
  return steps;
}

}  // namespace

Point read_position(TomlReader& reader, const char* key, const PathAxes& axes, const Point& origin,
                    Followers followers) {
  if (!reader.has(key)) reader.refuse_misspelt(key);
  if (!reader.has(key))
    reader.fail(key, "",
                std::string("is missing: add ") + key + " = [NUMBER, ...], one for each axis");
  Point p = origin;
  const bool short_list = followers == Followers::optional && axes.path_axes < axes.size();
  const std::vector<double> given = reader.numbers(
      key, axes.position_units,
      short_list ? ", one for each axis; the followers may be left out" : ", one for each axis",
      short_list ? axes.path_axes : axes.size());
  for (std::size_t i = 0; i < given.size(); ++i) p[i] = origin[i] + given[i];
  return p;
}

Point read_end(TomlReader& reader, const PathAxes& axes, const Point& from, const Point* origin) {
  Point to = read_position(reader, "to", axes, origin != nullptr ? *origin : Point{});
  for (std::size_t i = 0; origin == nullptr && i < axes.size(); ++i)
    to[i] = shortest_way(from[i], to[i], axes.modulo[i]);
  return to;
}

void read_path_settings(TomlReader& owner, const PathAxes& axes, PathSettings& settings) {
  if (const auto v = owner.optional_positive("velocity", axes.unit(1))) settings.velocity = *v;
  read_corner(owner, axes, settings);
  if (const auto junction = owner.optional_choice("junction", junctions))
    settings.junction = static_cast<Junction>(*junction);
}

Frame read_frame(TomlReader frame, const PathAxes& axes) {
  Frame made;
  const Point offset = frame.has("offset") ? read_position(frame, "offset", axes, {}) : Point{};
  const auto rotation = frame.optional_number("rotation", "deg");
  if (frame.has("zyz")) {
    if (rotation) frame.fail("zyz", "", "cannot be combined with rotation: give one of the two");
    const std::vector<double> zyz = frame.number_list("zyz", "deg");
    if (zyz.size() != 3) frame.fail("zyz", std::to_string(zyz.size()), "must be three angles");
    if (axes.path_axes < 3) frame.fail("zyz", "", "needs three axes that are not followers");
    made = euler_frame(offset, {zyz[0], zyz[1], zyz[2]});
  } else {
    if (rotation && axes.path_axes < 2)
      frame.fail("rotation", number(*rotation), "needs two axes that are not followers");
    made = turned_frame(offset, rotation.value_or(0));
  }
  frame.finish();
  return made;
}

PathSpec read_path(TomlReader& top, Spec& spec) {
  std::set<std::string> taken;
  const PathAxes axes = read_path_axes(top, spec, taken);
  TomlReader table = top.table("path");
  PathSpec path;
  GcodeMachine& machine = path.machine;
  read_path_settings(table, axes, machine.settings);
  path.overlap = read_overlap(table, axes);
  if (auto limits = table.optional_table("limits"))
    path.limits.path = read_path_limits(std::move(*limits), axes);
  path.tolerance = table.optional_positive("tolerance", axes.unit(0));
  path.refine = table.optional_flag("refine").value_or(false);
  if (top.has("points") && table.has("start"))
    table.fail("start", "",
               "does not apply to a path of points, which starts at the first one: leave it out");
  if (table.has("start"))
    machine.start = read_position(table, "start", axes, {}, Followers::optional);
  for (const AxisPart& part : spec.axes) {
    path.limits.axes.push_back(part.limits);
    machine.axes.push_back({part.name, part.units.position, part.limits.position_min,
                            part.limits.position_max, axes.modulo[machine.axes.size()]});
  }
  path.joints = read_kinematics(top, axes, spec, taken);
  if (path.overlap && path.joints)
    top.fail("kinematics", "",
             "cannot be combined with overlap, which plans the axes without joints: leave one of "
             "the two out");
  machine.path_axes = axes.path_axes;
  machine.second = conversion("s", spec.time_unit);
  path.program = Program(axes.size(), machine.start, axes.path_axes);
  path.source = top.document().name;
  read_program(top, axes, machine.settings, path);
  path.override_steps = read_override(top, axes);
  if (path.overlap && !path.override_steps.empty())
    top.fail("override", "",
             "cannot be combined with overlap, because the path of overlapping lines depends on "
             "the time: leave one of the two out");
  if (path.refine && (path.overlap || !path.override_steps.empty()))
    table.fail("refine", "true",
               std::string("cannot be combined with ") +
                   (path.overlap ? "overlap, which has no timing law along a path"
                                 : "[[override]], which plans the timing law again") +
                   ": leave one of the two out");
  table.finish();
  return path;
}

}  // namespace jounce::spec_detail
