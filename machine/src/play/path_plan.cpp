// SPDX-License-Identifier: Apache-2.0
#include <numeric>
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

StreamPlan path_plan(const std::string& group, const std::vector<Input>& axes) {
  const auto& path = std::get<PathSpec>(axes.front().spec->subject);
  const auto refuse = [](const char* key, const char* rule) { throw InputError(key, "", rule); };
  if (path.overlap) refuse("overlap", "is not possible for a group: its path would depend on time");
  if (!path.override_steps.empty())
    refuse("override", "is a command for a group: `jounce order GROUP override`");
  const Units& units = axes.front().table.units;
  if (units.x != "s") throw InputError("units.time", units.x, "must be s for a group");
  LimitedProgram sent = limited_program(path);
  for (const Input& axis : axes) {
    const bool has_length = sent.names.size() < path.program.path_axes() || !path.joints;
    if (has_length && axis.table.units.position != units.position)
      throw InputError(axis.axis + ".unit", axis.table.units.position,
                       "must be " + units.position + ": the axes of a group have the same unit");
    sent.names.push_back(axis.axis);
  }
  Columns columns;
  columns.p = numbers_of(sent);
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

}  // namespace jounce
