// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/group_position.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <variant>

#include <nlohmann/json.hpp>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/path/axis_map.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/machine_spec.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {
namespace {

using Parts = std::vector<ConvertedPosition::Part>;

/// The coordinates and joints of a group, each with its range.
struct GroupPlaces {
  std::vector<AxisPart> coordinates, joints;
  std::shared_ptr<const AxisMap> map;
  std::vector<double> start;  ///< start position of each joint
};

/// The error of a file that is not a spec of a machine.
[[noreturn]] void refuse_other_kind(const std::string& file) {
  const Spec spec = read_spec(file);
  throw spec.document.located(InputError("kind", '"' + spec_kind(spec.document.text) + '"',
                                         "must be \"machine\": only its groups have kinematics"));
}

const MachineSpec::Group& group_named(const MachineSpec& machine, const std::string& name) {
  std::vector<std::string> names;
  for (const MachineSpec::Group& group : machine.groups) names.push_back(group.name);
  if (names.empty())
    throw InputError("FILE", machine.document.name,
                     "has no [[group]]: only a group has kinematics");
  if (name.empty() && names.size() == 1) return machine.groups.front();
  if (name.empty())
    throw InputError("--group", "",
                     "is missing: " + machine.document.name + " has " +
                         counted(names.size(), "group") + ", " + listed(names) + ": add --group " +
                         names.front());
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError("--group", name, "must be a group of the machine: " + listed(names));
  return machine.groups[static_cast<std::size_t>(found - names.begin())];
}

/// The higher of two lower ends, or the lower of two higher ends.
std::optional<double> narrower(const std::optional<double>& a, const std::optional<double>& b,
                               bool higher) {
  if (!a || !b) return a ? a : b;
  return higher ? std::max(*a, *b) : std::min(*a, *b);
}

GroupPlaces places_of(const MachineSpec& machine, const MachineSpec::Group& group) {
  if (group.kinematics.empty())
    throw machine.document.located(
        InputError(group.key + ".kinematics", "",
                   "is missing: without it, the coordinates of " + group.name +
                       " are the positions of its axes, and need no conversion"));
  const Spec spec = read_spec(group.kinematics);
  const auto* const path = std::get_if<PathSpec>(&spec.subject);
  if (path == nullptr || !path->joints)
    throw machine.document.located(InputError(group.key + ".kinematics", group.kinematics,
                                              "must be a spec of kind \"path\" with [kinematics]"));
  GroupPlaces places{
      .coordinates = spec.parts(), .joints = {}, .map = path->joints->map, .start = {}};
  const auto tool = places.coordinates.begin() + static_cast<std::ptrdiff_t>(path->program.axes());
  places.joints.assign(tool, places.coordinates.end());
  places.coordinates.erase(tool, places.coordinates.end());
  places.start.resize(places.joints.size());
  for (const MachineSpec::Axis& one : machine.axes) {
    const Spec axis = read_spec(one.spec);
    for (std::size_t k = 0; k < places.joints.size(); ++k) {
      AxisPart& joint = places.joints[k];
      if (joint.name != axis.name) continue;
      places.start[k] = std::get<AxisSpec>(axis.subject).position;
      const Limits range = axis.parts().front().limits;
      joint.limits.position_min = narrower(joint.limits.position_min, range.position_min, true);
      joint.limits.position_max = narrower(joint.limits.position_max, range.position_max, false);
    }
  }
  return places;
}

/// The index of the part with this name; nullopt: none.
std::optional<std::size_t> index_of_part(const std::vector<AxisPart>& parts,
                                         const std::string& name) {
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (parts[k].name == name) return k;
  return std::nullopt;
}

struct NamedValue {
  std::string name, value;
};

std::vector<NamedValue> named(const std::vector<std::string>& values) {
  std::vector<NamedValue> all;
  for (const std::string& one : values) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == one.size())
      throw InputError("VALUE", one, "must be a position with its name, such as x=300mm");
    all.push_back({one.substr(0, equals), one.substr(equals + 1)});
  }
  return all;
}

/// The first given value that names one of the parts.
std::string first_of(const std::vector<NamedValue>& given, const std::vector<AxisPart>& parts) {
  const auto found = std::find_if(given.begin(), given.end(), [&](const NamedValue& one) {
    return index_of_part(parts, one.name).has_value();
  });
  return found == given.end() ? listed(parts, &AxisPart::name) : found->name;
}

/// The given values in the order of the parts.
std::array<double, max_axes> positions_of(const std::vector<NamedValue>& given,
                                          const std::vector<AxisPart>& parts,
                                          const std::vector<AxisPart>& others) {
  std::vector<std::string> missing;
  for (const AxisPart& part : parts) missing.push_back(part.name);
  std::array<double, max_axes> positions{};
  for (const auto& [name, value] : given) {
    const auto k = index_of_part(parts, name);
    const auto left = std::find(missing.begin(), missing.end(), name);
    if (!k && index_of_part(others, name))
      throw InputError("VALUE", name + "=" + value,
                       "cannot be combined with " + first_of(given, parts) +
                           ": give all coordinates, or all joints");
    if (!k)
      throw InputError("VALUE", name + "=" + value,
                       "names " + name + ", which is not one of " + listed(parts, &AxisPart::name) +
                           ", and not one of " + listed(others, &AxisPart::name) +
                           ": give all coordinates, or all joints");
    if (left == missing.end()) throw InputError("VALUE", name + "=" + value, "is given twice");
    missing.erase(left);
    try {
      positions[*k] = quantity(value, parts[*k].units.position);
    } catch (const InputError& error) {
      throw InputError(name, value, error.rule());
    }
  }
  if (!missing.empty())
    throw InputError(listed(missing), "",
                     std::string(missing.size() == 1 ? "is" : "are") + " missing: give all of " +
                         listed(parts, &AxisPart::name));
  return positions;
}

Parts with_ranges(std::span<const double> positions, const std::vector<AxisPart>& parts) {
  Parts all;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto& [position_min, position_max] =
        std::pair(parts[k].limits.position_min, parts[k].limits.position_max);
    ConvertedPosition::Part part{parts[k].name, positions[k], parts[k].units.position};
    if (position_min && positions[k] < *position_min)
      part.broken = "below position_min, " + six_digits(*position_min) + " " + part.unit;
    if (position_max && positions[k] > *position_max)
      part.broken = "above position_max, " + six_digits(*position_max) + " " + part.unit;
    all.push_back(std::move(part));
  }
  return all;
}

/// "x = 900 mm, y = 0 mm".
std::string position_text(std::span<const double> at, const std::vector<AxisPart>& parts) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k)
    text += (k == 0 ? "" : ", ") + parts[k].name + " = " + six_digits(at[k]) + " " +
            parts[k].units.position;
  return text;
}

/// The last position in reach, within the ranges of the joints, as a remedy. It is on the straight
/// line to `tool` from the position of the tool at which the joints start. `tool` is out of reach.
std::string last_in_reach(const std::array<double, max_axes>& tool, const GroupPlaces& places) {
  const auto start = places.map->tool(places.start);
  if (!start) return ": give another position";
  const std::size_t axes = places.coordinates.size();
  const auto at = [&](double share) {
    std::array<double, max_axes> point{};
    for (std::size_t i = 0; i < axes; ++i) point[i] = (*start)[i] + share * (tool[i] - (*start)[i]);
    return point;
  };
  const auto reaches = [&](double share) {
    std::array<Jet, max_axes> point{};
    std::array<Jet, max_axes> joints{};
    const auto p = at(share);
    for (std::size_t i = 0; i < axes; ++i) point[i] = {p[i], 0, 0, 0};
    if (places.map->jets(std::span(point).first(places.map->axes()),
                         std::span(joints).first(places.map->joints())) != MapState::ok)
      return false;
    std::array<double, max_axes> positions{};
    for (std::size_t k = 0; k < places.joints.size(); ++k) positions[k] = joints[k][0];
    return std::ranges::all_of(with_ranges(positions, places.joints),
                               [](const auto& part) { return part.broken.empty(); });
  };
  if (!reaches(0)) return ": give another position";
  double near = 0;
  double far = 1;
  for (int k = 0; k < 40; ++k) {
    const double half = (near + far) / 2;
    (reaches(half) ? near : far) = half;
  }
  near -= near * 1e-3;  // the rounded digits are in reach, too
  return ": on the line from the start of the joints, " +
         position_text(*start, places.coordinates) + ", the last position in reach is " +
         position_text(at(near), places.coordinates);
}

Parts joints_at(const std::array<double, max_axes>& tool, const GroupPlaces& places) {
  std::array<Jet, max_axes> point{};
  std::array<Jet, max_axes> joints{};
  std::array<double, max_axes> positions{};
  for (std::size_t i = 0; i < places.coordinates.size(); ++i) point[i] = {tool[i], 0, 0, 0};
  const std::string text = position_text(tool, places.coordinates);
  const MapState state = places.map->jets(std::span(point).first(places.map->axes()),
                                          std::span(joints).first(places.map->joints()));
  if (state == MapState::out_of_reach)
    throw InputError(text, "", "is out of reach of the joints" + last_in_reach(tool, places));
  if (state == MapState::singular)
    throw InputError(text, "", "is a singular position of the joints: give another position");
  for (std::size_t k = 0; k < places.joints.size(); ++k) positions[k] = joints[k][0];
  return with_ranges(positions, places.joints);
}

Parts tool_at(const std::array<double, max_axes>& joints, const GroupPlaces& places) {
  const auto tool = places.map->tool(std::span(joints).first(places.map->joints()));
  if (tool) {
    Parts all = with_ranges(*tool, places.coordinates);
    for (const auto& joint : with_ranges(joints, places.joints))
      if (!joint.broken.empty()) all.push_back(joint);
    return all;
  }
  throw InputError("VALUE", listed(places.joints, &AxisPart::name),
                   "are positions for which the kinematics has no position of the tool: use the "
                   "side of the elbow that the kinematics uses, and the same position for two "
                   "motors of one axis");
}

}  // namespace

bool ConvertedPosition::inside() const {
  return std::ranges::all_of(parts, [](const Part& part) { return part.broken.empty(); });
}

std::string ConvertedPosition::text() const {
  std::string text;
  for (const Part& part : parts)
    text += (text.empty() ? "" : "\n") + part.name + " = " + number(part.position) + " " +
            part.unit + (part.broken.empty() ? "" : " (" + part.broken + ")");
  return text;
}

std::string ConvertedPosition::json() const {
  nlohmann::ordered_json all;
  for (const Part& part : parts) {
    all[part.name] = {{"position", part.position}, {"unit", part.unit}};
    if (!part.broken.empty()) all[part.name]["broken"] = part.broken;
  }
  return all.dump();
}

ConvertedPosition converted_position(const std::string& file, const std::string& group,
                                     const std::vector<std::string>& values) {
  const auto machine = read_machine(file);
  if (!machine) refuse_other_kind(file);
  const GroupPlaces places = places_of(*machine, group_named(*machine, group));
  const std::vector<NamedValue> given = named(values);
  const bool to_tool = std::ranges::any_of(given, [&](const NamedValue& one) {
    return index_of_part(places.joints, one.name) && !index_of_part(places.coordinates, one.name);
  });
  if (to_tool) return {tool_at(positions_of(given, places.joints, places.coordinates), places)};
  return {joints_at(positions_of(given, places.coordinates, places.joints), places)};
}

}  // namespace jounce
