// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/detail/executor_tables.hpp"
#include "jounce/design/detail/sync_check.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// The slave of a cam that advances may be shifted by whole passes.
void shift_by_passes(const Table& table, CouplingSpec& coupling) {
  const double stroke = table.columns().p.back() - table.columns().p.front();
  const bool advances = table.outside() == Extrapolation::advance && stroke != 0;
  if (advances && !coupling.slave_period) coupling.slave_period = std::abs(stroke);
}

/// From the first knot on, wherever the master and, of an axis that turns on, the slave are by then.
void begin_at_cut(const Table& table, CouplingSpec& coupling) {
  coupling.master_absolute = false;
  coupling.master_offset = table.start();
  shift_by_passes(table, coupling);
}

/// A remark on the number of the coupling that begin_at_cut() replaces; "" if it is 0.
std::string unused_at_cut(const Units& units, const CouplingSpec& coupling) {
  if (coupling.master_offset == 0) return "";
  return "master_offset = " + six_digits(coupling.master_offset) +
         (units.x.empty() ? "" : " " + units.x) +
         " of [coupling] has no effect: at the next cut, the cam begins at its own start";
}

std::string or_without(const std::string& unit) {
  return unit.empty() ? "no unit" : unit;
}

/// Throws InputError ("live", "master") for tables that do not suit the options.
void require_fit(const Input& input, const PlayOptions& options) {
  const bool is_cam = input.table.table.axis() == Domain::master;
  if (options.live && !is_cam)
    throw InputError(
        "live", "",
        input.name + " is over time, but only a cam follows a live master: leave it out");
  if (!options.master) return;
  const Units& master = options.master->units;
  if (!is_cam)
    throw InputError("master", "",
                     "applies to a cam, but " + input.name + " is over time: leave it out");
  if (options.master->table.axis() != Domain::time)
    throw InputError("master", "", "must be a table over time: the motion of the master");
  if (master.position != input.table.units.x)
    throw InputError("master", "",
                     "has positions in " + or_without(master.position) + ", but the master of " +
                         input.name + " moves in " + or_without(input.table.units.x) +
                         ": give a table over time with positions in that unit");
}

ExecutorTables tables_of(const Input& input, const PlayOptions& options) {
  require_fit(input, options);
  if (options.live) return {input.table, std::nullopt};
  if (!options.master) return executor_tables(input);
  return {input.table, options.master};
}

CamEnd end_of(const Input& input, const PlayOptions& options) {
  if (options.keep_velocity) return CamEnd::keep_velocity;
  return input.spec && stays_in_gear(*input.spec) ? CamEnd::extend : CamEnd::brake;
}

/// Adds the tables of an input to the plan.
SwapPlan add_input(StreamPlan& plan, const Input& input, const PlayOptions& options) {
  const auto coupling = input.spec ? input.spec->coupling : std::nullopt;
  ExecutorTables tables = tables_of(input, options);
  SwapPlan added{.slave = plan.tables.size(), .master = plan.tables.size() + 1};
  plan.tables.push_back({std::move(tables.slave.table), tables.slave.units});
  if (tables.master) {
    plan.tables.push_back({std::move(tables.master->table), tables.master->units});
    added.mode = wire::ArmMode::follow_table;
    added.coupling = coupling.value_or(CouplingSpec{});
  }
  if (options.live) {
    added.mode = wire::ArmMode::follow_input;
    added.coupling = coupling.value_or(CouplingSpec{});
    added.end = end_of(input, options);
    const auto& [cam, units, hash] = plan.tables[added.slave];
    if (options.at_next_cut) {
      if (plan.remark.empty()) plan.remark = unused_at_cut(units, added.coupling);
      begin_at_cut(cam, added.coupling);
    }
    if (options.at_master && is_convertible(units.position, "deg"))
      shift_by_passes(cam, added.coupling);
  }
  return added;
}

std::string comma_separated(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ",") + name;
  return list;
}

}  // namespace

StreamPlan stream_plan(const std::string& executor, const Input& input,
                       const PlayOptions& options) {
  StreamPlan plan;
  plan.executor = executor;
  const SwapPlan first = add_input(plan, input, options);
  plan.mode = first.mode;
  plan.coupling = first.coupling;
  plan.end = first.end;
  if (options.at_next_cut) plan.when = StartAt::end_of_table;
  return plan;
}

void add_swap(StreamPlan& plan, const Input& input, const PlayOptions& options) {
  plan.swaps.push_back(add_input(plan, input, options));
}

std::vector<std::string> executor_names(const std::string& list) {
  std::vector<std::string> names;
  for (const auto name : csv_cells(list)) names.emplace_back(name);
  if (std::find(names.begin(), names.end(), "") != names.end())
    throw InputError("to", list, "lacks a name before or after a comma");
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (!wire::is_executor_name(*name)) throw InputError("to", *name, wire::executor_name_rule);
    if (std::find(names.begin(), name, *name) != name)
      throw InputError("to", list, "names " + *name + " twice: name each axis once");
  }
  return names;
}

std::vector<Input> inputs_for(const std::vector<std::string>& executors,
                              const std::vector<Input>& axes, const std::string& path) {
  std::vector<Input> chosen;
  for (std::size_t i = 0; i < executors.size(); ++i) {
    const auto named = std::find_if(axes.begin(), axes.end(),
                                    [&](const Input& input) { return input.axis == executors[i]; });
    if (axes.size() == 1)
      chosen.push_back(axes.front());
    else if (named != axes.end())
      chosen.push_back(*named);
    else if (axes.size() == executors.size())
      chosen.push_back(axes[i]);
    else
      throw InputError("to", comma_separated(executors),
                       "names " + std::to_string(executors.size()) + " axes, but " + path +
                           " has " + std::to_string(axes.size()) +
                           ": name one executor for each axis");
  }
  return chosen;
}

}  // namespace jounce
