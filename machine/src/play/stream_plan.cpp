// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/design/executor_tables.hpp"
#include "jounce/design/sync_check.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// From the first knot on, wherever the master and, of an axis that turns on, the slave are by then.
void begin_at_cut(const Table& table, CouplingSpec& coupling) {
  coupling.master_absolute = false;
  coupling.master_offset = table.start();
  const double stroke = table.columns().p.back() - table.columns().p.front();
  const bool turns = table.outside() == Extrapolation::advance && stroke != 0;
  if (turns && !coupling.slave_period) coupling.slave_period = std::abs(stroke);
}

ExecutorTables tables_of(const Input& input, const PlayOptions& options) {
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
    if (options.at_next_cut) begin_at_cut(plan.tables.back().table, added.coupling);
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
