// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/group_plan.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "jounce/base/detail/listed.hpp"
#include "jounce/path/detail/tool_unit.hpp"
#include "jounce/path/direct.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

void require_coordinates(std::span<const std::string> names, const ExecutorGroup& group) {
  const std::vector<std::string>& own = group.coordinates();
  if (!group.kinematics && names.size() > own.size())
    throw InputError("kinematics", listed(names),
                     "is for a machine with joints, but the group has no kinematics");
  if (!group.kinematics) return require_order(names, own);
  std::vector<std::string> all = own;
  all.insert(all.end(), group.names.begin(), group.names.end());
  const bool with_joints = names.size() > own.size();
  if (std::equal(names.begin(), names.end(), all.begin(),
                 with_joints ? all.end() : all.begin() + static_cast<std::ptrdiff_t>(own.size())))
    return;
  throw InputError("axes", listed(names),
                   "must be " + listed(own) +
                       (with_joints ? " with the joints " + listed(group.names) : std::string()) +
                       ", the coordinates of the group");
}

void require_coordinates(const LimitedProgram& sent, const ExecutorGroup& group) {
  require_coordinates(sent.names, group);
  const std::vector<std::string>& names = group.coordinates();
  std::vector<std::string> units = group.coordinate_units();
  units.insert(units.end(), group.units.begin(), group.units.end());  // the joints
  const auto name = [&](std::size_t k) {
    return k < names.size() ? names[k] : group.names[k - names.size()];
  };
  for (std::size_t k = 0; k < sent.units.size() && k < units.size(); ++k)
    if (!sent.units[k].empty() && !units[k].empty() && sent.units[k] != units[k])
      throw InputError(name(k) + ".unit", sent.units[k],
                       "must be " + units[k] + ", the unit of the axis in the group");
  const std::size_t path_axes = group.path_axes();
  if (sent.units.empty() && sent.program.axes() > path_axes && path_axes < names.size() &&
      !units[path_axes].empty() && units[path_axes] != units.front())
    throw InputError(names[path_axes] + ".unit", units.front(),
                     "must be " + units[path_axes] + ", the unit of the axis in the group");
  require_followers(sent.program, group);
  if (sent.program.axes() >= path_axes && sent.program.axes() < names.size())
    throw InputError(
        names[sent.program.axes()], "",
        "is a follower of the group, but not an axis of the path: add its [[axis]] with "
        "follower = true to the spec of the path");
}

void require_followers(const Program& program, const ExecutorGroup& group) {
  const std::size_t path_axes = group.path_axes();
  if (path_axes < group.coordinates().size() && program.path_axes() > path_axes)
    throw InputError(group.coordinates()[path_axes], "",
                     "is a follower of the group, but a path axis of the path: add follower = true "
                     "to its [[axis]] in the spec of the path");
}

namespace {

std::optional<double> lower(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::min(*a, *b) : a ? a : b;
}

std::optional<double> higher(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::max(*a, *b) : a ? a : b;
}

/// The lower limits of both, and the range that both permit.
Limits common(const Limits& a, const Limits& b) {
  return {.position_min = higher(a.position_min, b.position_min),
          .position_max = lower(a.position_max, b.position_max),
          .velocity = lower(a.velocity, b.velocity),
          .acceleration = lower(a.acceleration, b.acceleration),
          .jerk = lower(a.jerk, b.jerk)};
}

PathLimits common(const PathLimits& a, const PathLimits& b) {
  return {.velocity = std::min(a.velocity, b.velocity),
          .acceleration = std::min(a.acceleration, b.acceleration),
          .deceleration = std::min(a.deceleration, b.deceleration),
          .jerk = std::min(a.jerk, b.jerk),
          .normal_acceleration = std::min(a.normal_acceleration, b.normal_acceleration),
          .total_acceleration = std::min(a.total_acceleration, b.total_acceleration)};
}

/// The limits of the sender, lowered to those of the tool of the group.
GroupLimits of_tool(const GroupLimits& sent, const GroupKinematics& kinematics) {
  if (sent.axes.size() != kinematics.names.size())
    throw InputError("axes", std::to_string(sent.axes.size()),
                     "must be " + std::to_string(kinematics.names.size()) +
                         ", the number of coordinates of the group");
  GroupLimits all{.axes = sent.axes, .path = common(sent.path, kinematics.limits.path)};
  for (std::size_t k = 0; k < all.axes.size(); ++k)
    all.axes[k] = common(sent.axes[k], kinematics.limits.axes[k]);
  return all;
}

/// The limits of the sender, lowered to those of the axes.
GroupLimits of_axes(const GroupLimits& sent, const ExecutorGroup& group) {
  GroupLimits all = within(sent, group.configs);
  for (std::size_t k = 0; k < all.axes.size(); ++k) {
    all.axes[k].position_min = sent.axes[k].position_min;
    all.axes[k].position_max = sent.axes[k].position_max;
  }
  return all;
}

}  // namespace

Point axes_at(const Point& coordinates, const ExecutorGroup& group) {
  if (!group.kinematics) return coordinates;
  const AxisMap& map = *group.kinematics->joints.map;
  std::array<Jet, max_axes> point{};
  std::array<Jet, max_axes> joints{};
  for (std::size_t i = 0; i < map.axes(); ++i) point[i] = {coordinates[i], 0, 0, 0};
  const MapState state =
      map.jets(std::span(point).first(map.axes()), std::span(joints).first(map.joints()));
  if (state == MapState::out_of_reach)
    throw InputError("to", "", "is out of reach of the joints: choose another point");
  if (state == MapState::singular)
    throw InputError("to", "", "is a singular position of the joints: choose another point");
  Point axes{};
  for (std::size_t k = 0; k < map.joints(); ++k) axes[k] = joints[k][0];
  return axes;
}

GroupProgram checked_program(std::shared_ptr<const Plan> plan, const ExecutorGroup& group) {
  GroupProgram made = group_program(std::move(plan), group.configs, group.names, group.units);
  if (group.along) made.length = std::make_shared<const PathLength>(*made.plan);
  return made;
}

std::shared_ptr<const GroupProgram> planned_program(const Program& program,
                                                    const GroupLimits& limits,
                                                    const ExecutorGroup& group,
                                                    const std::atomic<bool>* canceled) try {
  PlanOptions options{.canceled = canceled};
  if (group.kinematics) options.joints = group.kinematics->joints;
  auto path = std::make_shared<const Plan>(
      plan(program, group.kinematics ? of_tool(limits, *group.kinematics) : of_axes(limits, group),
           options));
  if (canceled != nullptr && *canceled) throw PlanCanceled();
  return std::make_shared<const GroupProgram>(checked_program(std::move(path), group));
} catch (const InputError& error) {
  if (!group.kinematics) throw;
  throw in_unit_of_tool(error, group.kinematics->unit);
}

std::shared_ptr<const GroupProgram> fast_program(const Point& from, const Point& to,
                                                 const ExecutorGroup& group) {
  std::vector<Limits> limits;
  for (const AxisConfig& axis : group.configs) limits.push_back(axis.limits);
  const std::size_t measured = group.kinematics ? 0 : group.path_axes();
  auto made = std::make_shared<const Plan>(direct_plan(from, axes_at(to, group), limits, measured));
  return std::make_shared<const GroupProgram>(checked_program(std::move(made), group));
}

GroupSpace space_of(const ExecutorGroup& group) {
  std::vector<Limits> axes;
  for (const AxisConfig& axis : group.configs) axes.push_back(axis.limits);
  if (!group.kinematics) return {.limits = std::move(axes)};
  const GroupKinematics& kinematics = *group.kinematics;
  for (std::size_t k = 0; k < axes.size(); ++k)
    axes[k] = common(axes[k], kinematics.joints.limits[k]);
  return {.limits = kinematics.limits.axes,
          .path = kinematics.limits.path,
          .map = kinematics.joints.map,
          .joints = std::move(axes)};
}

std::optional<Point> tool_of(const Point& axes, const ExecutorGroup& group) {
  if (!group.kinematics) return axes;
  const AxisMap& map = *group.kinematics->joints.map;
  return map.tool(std::span(axes).first(map.joints()));
}

Point coordinates_of(const Point& axes, const ExecutorGroup& group) {
  if (const auto tool = tool_of(axes, group)) return *tool;
  std::string places;
  for (std::size_t k = 0; k < group.names.size(); ++k)
    places += (k == 0 ? "" : ", ") + group.names[k] + " " + six_digits(axes[k]);
  throw InputError("start", "(" + places + ")",
                   "is not a position of the joints for which the kinematics has a position of the "
                   "tool: move the joints to the side of the elbow that the kinematics uses, and "
                   "two motors of one axis to the same position");
}

}  // namespace jounce
