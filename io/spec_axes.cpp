#include <algorithm>
#include <set>
#include <vector>

#include "jounce/io/detail/spec_parts.hpp"

namespace jounce::detail {
namespace {

// In the order of Sync.
const std::vector<std::string> syncs{"none", "time", "phase", "time_if_moving", "phase_or_time"};
static_assert(static_cast<int>(Sync::phase) == 2 && static_cast<int>(Sync::phase_or_time) == 4);

/// A name becomes part of file names.
std::string read_name(TomlReader& axis, std::set<std::string>& taken) {
  std::string name = axis.text("name");
  const bool fits = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  if (!fits) axis.fail("name", '"' + name + '"', "must be of letters, digits, - and _");
  if (!taken.insert(name).second)
    axis.fail("name", '"' + name + '"', "is the name of another axis already");
  return name;
}

AxisPart read_part(TomlReader& axis, const Units& units, std::set<std::string>& taken) {
  AxisPart part;
  part.name = read_name(axis, taken);
  part.units = units;
  part.units.position = read_position_unit(axis, "unit", units.position.c_str());
  part.table = read_table_options(axis, part.units);
  part.limits = read_limits(axis, part.units);
  part.drive = read_drive(axis, part.units);
  return part;
}

AxisMove read_axis_move(MotionFields& f, bool through_points) {
  AxisMove move;
  if (!through_points) {
    move.from = f.state("from");
    move.to = f.state("to");
    if (!f.reader().has("to")) f.reader().fail("to", "", "is missing");
  }
  move.bounds = f.bounds();
  return move;
}

std::vector<std::vector<double>> read_points(TomlReader& top, const std::vector<AxisPart>& axes) {
  std::vector<std::string> units;
  for (const AxisPart& axis : axes) units.push_back(axis.units.position);
  std::vector<std::vector<double>> points;
  for (TomlReader& point : top.tables("point")) {
    if (!point.has("position")) point.fail("position", "", "is missing");
    points.push_back(point.numbers("position", units));
    point.finish();
  }
  return points;
}

}  // namespace

AxesSpec read_axes(TomlReader& top, Spec& spec) {
  AxesSpec axes;
  const bool through_points = top.has("point");
  if (through_points) axes.shortest_times = wants_shortest_times(top);
  if (!through_points) {
    if (const auto sync = top.optional_choice("sync", syncs)) axes.sync = static_cast<Sync>(*sync);
    axes.duration = top.optional_number("duration", spec.units.x).value_or(0);
    if (!(axes.duration >= 0)) top.fail("duration", number(axes.duration), "must not be negative");
  }
  std::set<std::string> taken;
  for (TomlReader& axis : top.tables("axis")) {
    spec.axes.push_back(read_part(axis, spec.units, taken));
    MotionFields fields(axis, spec.axes.back().units);
    axes.axes.push_back(read_axis_move(fields, through_points));
    axis.finish();
  }
  if (axes.axes.empty()) top.fail("axis", "", "is missing: give each axis as [[axis]]");
  axes.points = read_points(top, spec.axes);
  return axes;
}

}  // namespace jounce::detail
