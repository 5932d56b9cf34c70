// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "jounce/machine/play_plan.hpp"
#include "jounce/path/program_numbers.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

bool is_path(const std::vector<Input>& axes) {
  return axes.size() > 1 && axes.front().spec &&
         std::holds_alternative<PathSpec>(axes.front().spec->subject);
}

namespace {

/// An axis of a path.
struct NamedAxis {
  std::string name;
  Units units;
};

StreamPlan path_plan(const std::string& group, PathSpec path, const std::vector<NamedAxis>& axes) {
  const auto refuse = [](const char* key, const char* rule) { throw InputError(key, "", rule); };
  if (path.overlap) refuse("overlap", "is not possible for a group: its path would depend on time");
  if (!path.override_steps.empty())
    refuse("override", "is a command for a group: `jounce order GROUP override`");
  const Units& units = axes.front().units;
  if (units.x != "s") throw InputError("units.time", units.x, "must be s for a group");
  const std::size_t lengths = path.program.path_axes();
  LimitedProgram sent = limited_program(std::move(path));
  for (const NamedAxis& axis : axes) {
    if (sent.names.size() < lengths && axis.units.position != units.position)
      throw InputError(axis.name + ".unit", axis.units.position,
                       "must be " + units.position +
                           ": the axes of a group that are no followers have the same unit");
    sent.names.push_back(axis.name);
    sent.units.push_back(axis.units.position);
  }
  if (std::all_of(sent.units.begin(), sent.units.end(),
                  [&](const std::string& unit) { return unit == units.position; }))
    sent.units.clear();
  Columns columns;
  columns.p = numbers_of(sent);
  sent.program = Program(1);  // its memory is free for the other column
  columns.x.resize(columns.p.size());
  std::iota(columns.x.begin(), columns.x.end(), 0.0);
  StreamPlan plan;
  plan.executor = group;
  plan.mode = wire::ArmMode::path;
  plan.tables.push_back(
      {Table(Domain::master, Interpolation::linear, Extrapolation::hold, std::move(columns)),
       {"", units.position}});
  return plan;
}

}  // namespace

StreamPlan path_plan(const std::string& group, const std::vector<Input>& axes) {
  std::vector<NamedAxis> named;
  for (const Input& axis : axes) named.push_back({axis.axis, axis.table.units});
  return path_plan(group, std::get<PathSpec>(axes.front().spec->subject), named);
}

std::optional<StreamPlan> gcode_path_plan(const std::string& group, const std::string& path,
                                          const std::string& machine, const std::string& axis) {
  if (machine.empty() || path == "-" || !axis.empty()) return std::nullopt;
  Spec spec = gcode_spec(path, machine);
  std::vector<NamedAxis> named;
  for (const AxisPart& part : spec.parts()) named.push_back({part.name, part.units});
  if (named.size() < 2) return std::nullopt;
  return path_plan(group, std::move(std::get<PathSpec>(spec.subject)), named);
}

}  // namespace jounce
