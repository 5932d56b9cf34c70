// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "jounce/path/axis_map.hpp"

#include "spec/src/path/parts.hpp"

namespace jounce::spec_detail {
namespace {

const std::vector<std::string> map_types{"gantry", "corexy", "scara", "linear_delta"};
const std::vector<std::string> elbows{"right", "left"};

/// A map, and the unit of each of its joints.
struct Kinematics {
  std::shared_ptr<const AxisMap> map;
  std::vector<std::string> units;
};

/// Requires that the first axes of the path, which the map uses, have these units. An empty list of
/// units means that the path has other axes.
void require_axes(TomlReader& table, const PathAxes& axes, const std::vector<std::string>& units,
                  const std::string& needed) {
  const bool fits = !units.empty() && axes.size() >= units.size() &&
                    std::equal(units.begin(), units.end(), axes.position_units.begin());
  if (!fits) table.fail("type", "", "needs the axes " + needed + ", in this order");
}

Kinematics read_gantry(const PathAxes& axes, std::vector<TomlReader>& joints) {
  std::vector<std::size_t> axis_of;
  Kinematics made;
  for (TomlReader& joint : joints) {
    const std::string name = joint.text("axis");
    const auto at = std::find(axes.names.begin(), axes.names.end(), name);
    // The placeholder of a faulty name is the path of its key.
    const bool known = std::ranges::none_of(
        axes.names, [](const std::string& one) { return one.find('.') != std::string::npos; });
    if (at == axes.names.end() && !known) throw PartEnded{};
    if (at == axes.names.end())
      joint.fail("axis", '"' + name + '"', "must be the name of an [[axis]]");
    axis_of.push_back(static_cast<std::size_t>(at - axes.names.begin()));
    made.units.push_back(axes.position_units[axis_of.back()]);
  }
  made.map = gantry_map(axes.size(), axis_of);
  return made;
}

Kinematics read_core_xy(TomlReader& table, const PathAxes& axes) {
  require_axes(table, axes, {axes.units.position, axes.units.position}, "x and y");
  return {core_xy_map(axes.size()), axes.position_units};
}

Kinematics read_scara(TomlReader& table, const PathAxes& axes) {
  ScaraSpec spec;
  const std::string& length = axes.units.position;
  spec.arms = table.number_list("arms", length);
  const bool third = spec.arms.size() == 3;
  spec.with_z = axes.path_axes == 3;
  std::vector<std::string> units(axes.path_axes, length);
  if (third) units.emplace_back("deg");
  if (axes.path_axes != 2 && axes.path_axes != 3) units.clear();
  require_axes(
      table, axes, units,
      third ? "x, y, with or without z, and a follower in deg (the direction of the last arm)"
            : "x, y, with or without z");
  if (const auto elbow = table.optional_choice("elbow", elbows))
    spec.elbow = *elbow == 0 ? Elbow::right : Elbow::left;
  if (table.has("offsets")) spec.offsets = table.number_list("offsets", "deg");
  if (spec.with_z) spec.offset_z = table.optional_number("offset_z", length).value_or(0);
  Kinematics made{scara_map(spec), std::vector<std::string>(spec.arms.size(), "deg")};
  if (spec.with_z) made.units.push_back(length);
  return made;
}

Kinematics read_linear_delta(TomlReader& table, const PathAxes& axes) {
  const std::string& length = axes.units.position;
  require_axes(table, axes, {length, length, length}, "x, y and z");
  LinearDeltaSpec spec;
  spec.outer_radius = table.number("outer_radius", length);
  spec.inner_radius = table.number("inner_radius", length);
  spec.arm = table.number("arm", length);
  spec.distance = table.optional_number("distance", length).value_or(0);
  spec.rail_angle = table.optional_number("rail_angle", "deg").value_or(0);
  spec.first_rail = table.optional_number("first_rail", "deg").value_or(0);
  return {linear_delta_map(spec), std::vector<std::string>(3, length)};
}

Kinematics read_map(TomlReader& table, const PathAxes& axes, std::vector<TomlReader>& joints) {
  switch (table.variant("type", map_types)) {
    case 0:
      return read_gantry(axes, joints);
    case 1:
      return read_core_xy(table, axes);
    case 2:
      return read_scara(table, axes);
    default:
      return read_linear_delta(table, axes);
  }
}

void read_joint(TomlReader& joint, const std::string& unit, Spec& spec,
                std::set<std::string>& taken) {
  Units units = spec.units;
  units.position = unit;
  const AxisPart& part = spec.axes.emplace_back(read_axis_part(joint, units, taken));
  if (part.units.position != unit)
    joint.fail("unit", '"' + part.units.position + '"', "must be " + unit + " for this joint");
  joint.finish();
}

}  // namespace

std::optional<JointSpace> read_kinematics(TomlReader& top, const PathAxes& axes, Spec& spec,
                                          std::set<std::string>& taken) {
  auto table = top.optional_table("kinematics");
  if (!table) {
    if (top.has("joint")) top.fail("joint", "", "needs [kinematics]: add it, or remove [[joint]]");
    return {};
  }
  std::vector<TomlReader> joints = top.tables("joint");
  if (joints.empty()) top.fail("joint", "", "is missing: add [[joint]] for each joint");
  Kinematics made;
  try {
    made = read_map(*table, axes, joints);
  } catch (const InputError& error) {  // a map names its own parameters, which are keys
    if (!error.document().empty()) throw;
    throw InputError(table->path(error.key()), error.value(), error.rule());
  }
  if (joints.size() != made.units.size())
    top.fail("joint", std::to_string(joints.size()),
             "must be " + std::to_string(made.units.size()) + " joints for this type");
  JointSpace space{.map = made.map, .limits = {}};
  if (const auto tolerance = table->optional_positive("tolerance", made.units.front()))
    space.tolerance = *tolerance;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    read_joint(joints[k], made.units[k], spec, taken);
    space.limits.push_back(spec.axes.back().limits);
  }
  table->finish();
  return space;
}

}  // namespace jounce::spec_detail
