// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/path/program_numbers.hpp"
#include "jounce/stream/sender/client.hpp"

#include "axis/group/group_rig.hpp"
#include "executor/site.hpp"

namespace jounce::test {

/// The options of a plotter: the axes x and y within these limits, and their group, whose program is
/// the contour.
inline std::vector<ExecutorOptions> plotter(const Limits& axis, const PlanWindow& window = {}) {
  constexpr std::size_t x = Plotter::x;
  constexpr std::size_t y = Plotter::y;
  std::vector<ExecutorOptions> axes{axis_named("x", axis, {"", "mm"}),
                                    axis_named("y", axis, {"", "mm"})};
  const std::vector<AxisConfig> configs{axes[x].axis, axes[y].axis};
  const std::vector<std::string> names{"x", "y"};
  ExecutorOptions all = axis_named("plotter", {}, {"", "mm"});
  all.axis = group_config(configs);
  all.enable = false;
  all.group = ExecutorGroup{.of = {{x, y}}, .names = names, .configs = configs, .window = window};
  Limits planned = axis;
  planned.position_min = planned.position_max = std::nullopt;
  all.group->sent = sent_program(
      {.program = contour(150), .limits = {.axes = std::vector<Limits>(2, planned)}}, *all.group);
  axes.push_back(std::move(all));
  return axes;
}

/// The plan of a stream that sends this program to a plotter.
inline StreamPlan stream_of(const LimitedProgram& program) {
  Columns columns;
  columns.p = numbers_of(program);
  columns.x.resize(columns.p.size());
  std::iota(columns.x.begin(), columns.x.end(), 0.0);
  StreamPlan plan;
  plan.executor = "plotter";
  plan.mode = wire::ArmMode::path;
  plan.tables.push_back(
      {Table(Domain::master, Interpolation::linear, Extrapolation::hold, std::move(columns)),
       {"", "mm"}});
  return plan;
}

/// A site with a plotter. each_tick is called after every cycle.
struct PlotterSite : Site {
  explicit PlotterSite(bool recorded = false, const Limits& axis = limits(200, 2000, 1e5),
                       const PlanWindow& window = {})
      : Site(plotter(axis, window), {.masters = {}, .recorded = recorded, .said = {}}) {
    after = [this] {
      if (each_tick) each_tick();
    };
  }
  /// Sends a command in a session of its own.
  CallOutcome order(const char* name, const ClientCommand& command) {
    Client client(link, name, {}, clock);
    const CallOutcome outcome = client.command(command);
    static_cast<void>(client.release());
    return outcome;
  }
  std::function<void()> each_tick;
};

}  // namespace jounce::test
