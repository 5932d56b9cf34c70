// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <vector>

#include "jounce/base/units.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

// In the order of the enum Sync.
const std::vector<std::string> syncs{"none", "time", "phase", "time_if_moving", "phase_or_time"};
static_assert(static_cast<int>(Sync::phase) == 2 && static_cast<int>(Sync::phase_or_time) == 4);

/// Checks the name of an axis, which becomes part of file names.
std::string read_name(TomlReader& axis, std::set<std::string>& taken) {
  std::string name = axis.text("name");
  if (!axis.is_text("name")) return name;  // a placeholder: the reader has reported the error
  const bool fits = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  if (!fits) axis.fail("name", '"' + name + '"', "must consist of letters, digits, - and _");
  if (!taken.insert(name).second)
    axis.fail("name", '"' + name + '"', "is the name of two axes: rename one");
  return name;
}

AxisMove read_axis_move(MotionFields& f, bool through_points) {
  AxisMove move;
  if (!through_points) {
    move.from = f.state("from");
    move.to = f.state("to");
    if (!f.reader().has("to"))
      f.reader().fail("to", "", "is missing: each axis needs its target position");
  }
  move.bounds = f.bounds();
  return move;
}

std::vector<std::string> rate_units(const std::vector<AxisPart>& axes, int order) {
  std::vector<std::string> units;
  for (const AxisPart& axis : axes)
    units.push_back(rate_unit(axis.units.position, axis.units.x, order));
  return units;
}

std::vector<double> optional_rates(TomlReader& table, const char* key,
                                   const std::vector<AxisPart>& axes, int order) {
  return table.has(key) ? table.numbers(key, rate_units(axes, order)) : std::vector<double>{};
}

/// Reads the bounds of the axes in a stretch; they replace those of the axes.
std::vector<Bounds> read_stretch(TomlReader limits, const std::vector<AxisPart>& parts,
                                 const std::vector<AxisMove>& axes) {
  const auto velocity = optional_rates(limits, "velocity", parts, 1);
  const auto acceleration = optional_rates(limits, "acceleration", parts, 2);
  const auto jerk = optional_rates(limits, "jerk", parts, 3);
  for (const auto& [key, values] :
       {std::pair{"velocity", &velocity}, {"acceleration", &acceleration}, {"jerk", &jerk}})
    for (const double value : *values)
      if (!(value > 0)) limits.fail(key, number(value), "must be greater than 0");
  std::vector<Bounds> all;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Bounds b = axes[i].bounds;
    if (!velocity.empty()) b.velocity_min = -(b.velocity_max = velocity[i]);
    if (!acceleration.empty()) b.acceleration_min = -(b.acceleration_max = acceleration[i]);
    if (!jerk.empty()) b.jerk_min = -(b.jerk_max = jerk[i]);
    all.push_back(b);
  }
  limits.finish();
  return all;
}

Limits read_norm(TomlReader& top, const std::vector<AxisPart>& parts) {
  Limits norm;
  auto table = top.optional_table("norm");
  if (!table) return norm;
  for (const AxisPart& part : parts)
    if (part.units.position != parts.front().units.position)
      top.fail("norm", "", "needs the same unit on all axes: leave it out, or change a unit");
  const std::vector<std::string> units{rate_units(parts, 1).front(), rate_units(parts, 2).front(),
                                       rate_units(parts, 3).front()};
  norm.velocity = table->optional_number("velocity", units[0]);
  norm.acceleration = table->optional_number("acceleration", units[1]);
  norm.jerk = table->optional_number("jerk", units[2]);
  table->finish();
  return norm;
}

/// Reads [[point]] of a spline whose times are computed: positions only.
std::vector<std::vector<double>> read_positions(TomlReader& top,
                                                const std::vector<AxisPart>& parts) {
  std::vector<std::vector<double>> points;
  for (TomlReader& point : top.tables("point")) {
    if (!point.has("position"))
      point.fail("position", "", "is missing: add position = [NUMBER, ...], one for each axis");
    points.push_back(point.numbers("position", rate_units(parts, 0), ", one for each axis"));
    point.finish();
  }
  return points;
}

/// Reads [[point]]: a position for each axis. The first and the last point may have rates. From the
/// second on, a point may have limits for the stretch before it.
void read_points(TomlReader& top, const std::vector<AxisPart>& parts, AxesSpec& axes) {
  std::vector<TomlReader> points = top.tables("point");
  std::vector<Bounds> own;
  for (const AxisMove& axis : axes.axes) own.push_back(axis.bounds);
  bool limited = false;
  for (std::size_t k = 0; k < points.size(); ++k) {
    TomlReader& point = points[k];
    if (!point.has("position"))
      point.fail("position", "", "is missing: add position = [NUMBER, ...], one for each axis");
    axes.points.push_back(point.numbers("position", rate_units(parts, 0), ", one for each axis"));
    const bool end = k == 0 || k + 1 == points.size();
    for (const char* key : {"velocity", "acceleration"})
      if (!end && point.has(key))
        point.fail(key, "", "applies only to the first and the last point: leave it out here");
    const ViaRates rates{optional_rates(point, "velocity", parts, 1),
                         optional_rates(point, "acceleration", parts, 2)};
    if (end) (k == 0 ? axes.via.start : axes.via.end) = rates;
    if (k == 0 && point.has("limits"))
      point.fail("limits", "",
                 "apply to the travel from the previous point, so the first point has none: leave "
                 "them out");
    limited = limited || point.has("limits");
    if (k > 0)
      axes.via.stretches.push_back(
          point.has("limits") ? read_stretch(point.table("limits"), parts, axes.axes) : own);
    point.finish();
  }
  if (!limited) axes.via.stretches.clear();
}

}  // namespace

AxisPart read_axis_part(TomlReader& axis, const Units& units, std::set<std::string>& taken) {
  AxisPart part;
  part.name = read_name(axis, taken);
  part.units = units;
  part.units.position = read_position_unit(axis, "unit", units.position.c_str());
  part.table = read_table_options(axis, part.units);
  part.limits = read_limits(axis, part.units);
  part.drive = read_drive(axis, part.units);
  return part;
}

AxesSpec read_axes(TomlReader& top, Spec& spec) {
  AxesSpec axes;
  const bool through_points = top.has("point");
  top.refuse_here("points", "does not apply to kind = \"axes\": give the points as [[point]]");
  if (through_points) {
    axes.shortest_times = wants_shortest_times(top);
    for (const char* key : {"sync", "duration"})
      top.refuse_here(key, "does not apply to a motion through [[point]]: leave it out");
  }
  if (!through_points) {
    for (const char* key : {"times", "norm"})
      top.refuse_here(key, "applies only to a motion through [[point]]: leave out " +
                               std::string(key) + ", or add [[point]]");
    if (const auto sync = top.optional_choice("sync", syncs)) axes.sync = static_cast<Sync>(*sync);
    axes.duration = top.optional_number("duration", spec.units.x).value_or(0);
    if (!(axes.duration >= 0)) top.fail("duration", number(axes.duration), "must not be negative");
  }
  std::set<std::string> taken;
  top.for_each("axis", [&](TomlReader& axis) {
    spec.axes.push_back(read_axis_part(axis, spec.units, taken));
    MotionFields fields(axis, spec.axes.back().units);
    axes.axes.push_back(read_axis_move(fields, through_points));
    if (through_points)
      for (const char* key :
           {"from", "to", "from_velocity", "from_acceleration", "to_velocity", "to_acceleration"})
        axis.refuse_here(key, "does not apply to a motion through [[point]]: leave it out");
    axis.finish();
  });
  top.refuse_misspelt("axis");  // if an axis is missing, all lists of positions are too long
  if (axes.axes.empty()) top.fail("axis", "", "is missing: add [[axis]] for each axis");
  if (axes.shortest_times) {
    axes.points = read_positions(top, spec.axes);
    top.refuse_here("norm", "cannot be combined with times = \"shortest\": leave it out");
  } else {
    read_points(top, spec.axes, axes);
    axes.via.norm = through_points ? read_norm(top, spec.axes) : Limits{};
  }
  return axes;
}

}  // namespace jounce::spec_detail
