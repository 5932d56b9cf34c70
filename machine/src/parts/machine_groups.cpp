// SPDX-License-Identifier: Apache-2.0
#include "machine/src/parts/machine_groups.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/input.hpp"
#include "jounce/design/make.hpp"
#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/spec.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce::machine_detail {
namespace {

std::size_t index_of(const std::string& key, const std::string& name, const MachineParts& parts) {
  std::vector<std::string> names;
  for (const ExecutorOptions& axis : parts.axes) names.push_back(axis.receiver.executor);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string near = nearest(name, names);
  throw InputError(key, name,
                   near.empty() ? "is not an axis of this machine, which has " + listed(names) +
                                      ": correct the name, or add its [[axis]]"
                                : "is not an axis of this machine: did you mean " + near + "?");
}

/// The motions of the axes of a path over s; the file has one for each axis.
std::vector<Input> path_of(const std::string& file, const ExecutorGroup& group) {
  const std::size_t axes = group.coordinates().size();
  if (const std::string kind = spec_kind(read_file(file)); !kind.empty() && kind != "path")
    throw InputError("program", file,
                     "is of kind \"" + kind + "\", but must be a spec of kind \"path\"");
  std::vector<Input> inputs = read_inputs(file);
  if (!inputs.front().plan)
    throw InputError("program", file,
                     inputs.front().overlap
                         ? "overlaps lines in time, so its path depends on time: "
                           "remove overlap"
                         : "must be a spec of kind \"path\"");
  const auto* const path = std::get_if<PathSpec>(&inputs.front().spec->subject);
  const bool joined = path != nullptr && path->joints;
  if (joined && !group.kinematics)
    throw InputError("program", file,
                     "has [kinematics]: add kinematics = \"FILE\" to the [[group]]");
  if (inputs.size() != axes + (joined ? group.names.size() : 0))
    throw InputError("program", file,
                     "has " + std::to_string(inputs.size()) + " axes, but the group has " +
                         std::to_string(axes));
  return inputs;
}

void require_units(const Input& motion, const std::string& axis, const std::string& unit,
                   const std::string& file) {
  const Units& units = motion.table.units;
  if (units.x != "s")
    throw InputError("program", file, "has the time unit " + units.x + ": use units.time = \"s\"");
  if (!unit.empty() && units.position != unit)
    throw InputError("program", file,
                     "has the unit " + units.position + " for " + motion.axis + ", but the axis " +
                         axis + " of the group has " + unit + ": use the same unit");
}

double tolerance_of(const std::string& text, const std::string& unit) {
  try {
    return quantity(text, unit);
  } catch (const InputError& error) {  // it has no key
    throw InputError("tolerance", text, error.rule());
  }
}

/// The commands of a program. If no M word waits, the group plays the plan of the spec.
std::shared_ptr<const SentProgram> sent_of(const Input& motion, const ExecutorGroup& group) {
  const auto& path = std::get<PathSpec>(motion.spec->subject);
  LimitedProgram program = limited_program(path);
  const bool waits = std::any_of(program.words.begin(), program.words.end(),
                                 [&](const auto& word) { return group.m_words.waits_at(word); });
  if (waits && path.refine)
    throw InputError(
        "refine", "true",
        "is not possible for a program with M words that wait: leave it out, or change "
        "m_words of the [[group]]");
  if (waits || group.kinematics) return sent_program(std::move(program), group);
  return sent_program(std::move(program), checked_program(motion.plan, group));
}

std::shared_ptr<const SentProgram> program_of(const MachineSpec::Group& spec,
                                              const ExecutorGroup& group) {
  std::vector<Input> path = path_of(spec.program, group);
  std::vector<std::string> names;
  for (const Input& axis : path) {
    const std::size_t k = names.size();
    if (!group.kinematics) require_units(axis, group.names[k], group.units[k], spec.program);
    names.push_back(axis.axis);
  }
  require_coordinates(names, group);
  try {
    require_followers(std::get<PathSpec>(path.front().spec->subject).program, group);
    return sent_of(path.front(), group);
  } catch (const InputError& error) {
    throw InputError("program", spec.program,
                     (error.line() > 0 ? "line " + std::to_string(error.line()) + ": " : "") +
                         error.key() + " " + error.value() + " " + error.rule());
  }
}

/// The kinematics of a group from a spec of kind "path". Its joints are the axes of the group.
GroupKinematics kinematics_of(const std::string& file, const ExecutorGroup& group,
                              const std::vector<std::string>& units, MachineParts& parts) {
  const Spec spec = read_spec(file);
  parts.add_files(spec.document.all_files());
  const auto* const path = std::get_if<PathSpec>(&spec.subject);
  if (path == nullptr || !path->joints)
    throw InputError("kinematics", file, "must be a spec of kind \"path\" with [kinematics]");
  const std::vector<AxisPart> axes = spec.parts();
  const std::size_t tool = path->program.axes();
  GroupKinematics made{
      .path_axes = path->program.path_axes(), .joints = *path->joints, .limits = path->limits};
  std::vector<std::string> joints;
  for (std::size_t k = 0; k < axes.size(); ++k)
    (k < tool ? made.names : joints).push_back(axes[k].name);
  for (std::size_t k = 0; k < tool; ++k) made.units.push_back(axes[k].units.position);
  if (joints != group.names)
    throw InputError("kinematics", file,
                     "has the joints " + listed(joints) + ", but the axes of the group are " +
                         listed(group.names) + ": use the same names in the same order");
  for (std::size_t k = 0; k < joints.size(); ++k)
    if (axes[tool + k].units.position != units[k])
      throw InputError("kinematics", file,
                       "has the unit " + axes[tool + k].units.position + " for the joint " +
                           joints[k] + ", but the axis has " + units[k]);
  if (seconds_per_unit(spec) != 1) throw InputError("kinematics", file, "needs units.time = \"s\"");
  made.unit = spec.units.position;
  made.joints.limits = within({.axes = path->joints->limits}, group.configs).axes;
  return made;
}

ExecutorGroup group_of(const MachineSpec::Group& spec, MachineParts& parts) {
  ExecutorGroup group;
  std::vector<std::string> units;
  const auto add = [&](const char* key, const std::string& name) {
    const std::size_t index = index_of(key, name, parts);
    group.of.axes.push_back(index);
    group.names.push_back(name);
    group.configs.push_back(resolved(parts.axes[index].axis));
    units.push_back(parts.axes[index].units.position);
  };
  for (const std::string& name : spec.axes) {
    add("axes", name);
    if (spec.kinematics.empty() && units.back() != units.front())
      throw InputError("axes", name,
                       "has the unit " + units.back() + ", but " + spec.axes.front() + " has " +
                           units.front() + ": use the same unit, or move it to followers = [\"" +
                           name + "\"]");
  }
  if (std::all_of(units.begin(), units.end(), [&](const auto& u) { return u == units.front(); }))
    group.unit = units.front();
  for (const std::string& name : spec.followers) {
    if (!spec.kinematics.empty())
      throw InputError(
          "followers", name,
          "cannot be combined with kinematics: leave it out, and use follower = true in "
          "the spec of the kinematics");
    if (std::count(group.names.begin(), group.names.end(), name) > 0)
      throw InputError("followers", name, "is already an axis of this group: name each axis once");
    add("followers", name);
    ++group.followers;
  }
  group.units = units;
  if (!spec.kinematics.empty())
    group.kinematics = kinematics_of(spec.kinematics, group, units, parts);
  return group;
}

/// The [compare] of the program: along the path, or of two axes of the group.
AxisCompare compare_of(const Spec& program) {
  AxisCompare made;
  if (!program.compare) return made;
  const double unit = seconds_per_unit(program);
  if (const auto& plane = program.compare->plane) {
    made.plane = plane;
    made.plane->pulse *= unit;
    const std::vector<AxisPart> axes = program.parts();  // in the order of the group
    for (std::size_t k = 0; k < made.plane_axes.size(); ++k)
      made.plane_axes[k] = static_cast<std::size_t>(
          std::find_if(
              axes.begin(), axes.end(),
              [&](const AxisPart& axis) { return axis.name == program.compare->plane_axes[k]; }) -
          axes.begin());
    return made;
  }
  if (program.compare->axis != "path")
    throw program.document.located(
        InputError("compare.axis", program.compare->axis,
                   "must be \"path\" in the program of a group: add [compare] to the spec of the "
                   "axis instead"));
  made.list = program.compare->compare;
  made.list->pulse *= unit;
  return made;
}

ExecutorOptions made(const MachineSpec::Group& spec, const MachineOptions& options,
                     MachineParts& parts) {
  ExecutorOptions made;
  ExecutorGroup& group = made.group.emplace(group_of(spec, parts));
  const ExecutorOptions& first = parts.axes[group.of.axes.front()];
  made.units = {"", group.kinematics ? group.kinematics->unit : first.units.position};
  if (spec.tolerance) group.of.tolerance = tolerance_of(*spec.tolerance, group.unit);
  group.m_words = {.all = !spec.m_words,
                   .numbers = spec.m_words.value_or(std::vector<std::int32_t>{}),
                   .timeout = spec.m_word_timeout};
  if (!spec.program.empty()) {
    const Spec program = read_spec(spec.program);
    parts.add_files(program.document.all_files());
    made.compare = compare_of(program);
    group.along = made.compare.list.has_value();
    group.sent = program_of(spec, group);
  }
  if (made.compare.plane && group.kinematics)
    throw InputError("program", spec.program,
                     "compares a plane of two coordinates, which is not possible with kinematics: "
                     "compare along the path");
  made.axis = group_config(group.configs);
  made.receiver.executor = spec.name;
  made.receiver.session_timeout = first.receiver.session_timeout;
  made.enable = false;  // its axes are enabled first
  made.stop_when_silent = first.stop_when_silent;
  made.build_apart = 0;  // a path of a hundred arcs may take a second
  // Never alone: its axes are there besides.
  if (!options.log.empty()) made.log = log_of(options.log, spec.name, 2);
  return made;
}

}  // namespace

void add_machine_group(const MachineSpec::Group& spec, const Document& document,
                       const MachineOptions& options, MachineParts& parts) {
  const bool taken = std::any_of(parts.axes.begin(), parts.axes.end(), [&](const auto& axis) {
    return axis.receiver.executor == spec.name;
  });
  if (taken)
    throw document.located(InputError(spec.key + ".name", spec.name,
                                      "is also the name of an axis of this machine: rename one"));
  if (!wire::is_executor_name(spec.name))
    throw document.located(InputError(spec.key + ".name", spec.name, wire::executor_name_rule));
  try {
    parts.axes.push_back(made(spec, options, parts));
    for (const std::size_t axis : parts.axes.back().group->of.axes)
      parts.axes[axis].groups.push_back(spec.name);
  } catch (const InputError& error) {
    const bool of_kinematics = error.document() == spec.kinematics;
    if (!error.document().empty())  // an error in one of the two files, or a missing file
      throw document.naming(spec.key + (of_kinematics ? ".kinematics" : ".program"),
                            error.document(), error);
    throw document.located(InputError(spec.key + "." + error.key(), error.value(), error.rule()));
  }
}

InputError in_group(const MachineSpec& machine, const MachineParts& parts,
                    const InputError& error) {
  for (const MachineSpec::Group& group : machine.groups) {
    if (!error.key().starts_with(group.name + ".")) continue;
    Document document = machine.document;
    const std::string tolerance = group.key + ".tolerance";
    for (const ExecutorOptions& axis : parts.axes)
      if (axis.group && axis.receiver.executor == group.name)
        document.units[tolerance] = axis.group->unit;
    if (group.tolerance) document.given[tolerance] = quantity_unit(*group.tolerance);
    if (document.given[tolerance].empty()) document.given.erase(tolerance);
    return document.located(
        InputError(group.key + error.key().substr(group.name.size()), error.value(), error.rule()));
  }
  return error;
}

}  // namespace jounce::machine_detail
