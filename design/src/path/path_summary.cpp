// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/base/units.hpp"
#include "jounce/design/detail/path_text.hpp"
#include "jounce/path/along.hpp"
#include "jounce/path/command_times.hpp"
#include "jounce/path/path_length.hpp"

namespace jounce {
namespace {

/// The greatest factor of an override; at least 1.
double greatest_factor(const PathSpec& path) {
  double greatest = 1;
  for (const FactorRequest& step : path.override_steps) greatest = std::max(greatest, step.factor);
  return greatest;
}

/// Gives each dwell the line of its own command: the plan has only the lines of the pieces beside it.
void name_dwells(const Program& program, const Plan& plan, PathCost& cost) {
  std::vector<std::size_t> dwells;
  for (std::size_t k = 0; k < program.commands().size(); ++k)
    if (program.commands()[k].kind == Program::Kind::dwell) dwells.push_back(k);
  if (dwells.empty()) return;
  const std::vector<CommandStart> starts = command_starts(program, plan, dwells);
  for (SpeedLoss& loss : cost.losses) {
    if (loss.cause != LossCause::dwell) continue;
    const auto nearest = std::min_element(
        starts.begin(), starts.end(), [&](const CommandStart& a, const CommandStart& b) {
          return std::abs(a.where - loss.where) < std::abs(b.where - loss.where);
        });
    loss.line = program.commands()[dwells[static_cast<std::size_t>(nearest - starts.begin())]].line;
  }
}

}  // namespace

Report path_report(const Spec& spec, const Plan& played) {
  Report report = check_along(played, greatest_factor(std::get<PathSpec>(spec.subject)));
  for (Finding& f : report.findings) {
    if (!f.axis.empty()) {  // the number of the axis
      const AxisPart& axis = spec.axes[std::stoul(f.axis) - 1];
      f.axis = axis.name;
    } else if (f.quantity.ends_with("celeration")) {
      f.unit = rate_unit(spec.units.position, spec.units.x, 2);
    }
  }
  return report;
}

std::vector<EventPlace> places_of(const PathSpec& path, const Plan& plan,
                                  std::span<const GcodeEvent> events) {
  std::vector<std::size_t> commands;
  for (const GcodeEvent& event : events) commands.push_back(event.command);
  const std::vector<CommandStart> starts = command_starts(path.program, plan, commands);
  std::vector<EventPlace> places;
  std::vector<Motion> axes(plan.path().axes());
  const PathLength length(plan);
  for (std::size_t k = 0; k < events.size(); ++k) {
    EventPlace place{
        .event = events[k], .where = length.at(starts[k].where).length, .time = starts[k].time};
    plan.at(place.time, axes);
    for (std::size_t i = 0; i < axes.size(); ++i) place.position[i] = axes[i].position;
    places.push_back(std::move(place));
  }
  return places;
}

std::vector<EventPlace> places_of_lines(const PathSpec& path, const Plan& plan) {
  std::vector<GcodeEvent> lines;
  const auto commands = path.program.commands();
  for (std::size_t k = 0; k < commands.size(); ++k)
    if (const int line = commands[k].line; lines.empty() || lines.back().line != line)
      lines.push_back({.word = "line " + std::to_string(line), .line = line, .command = k});
  return places_of(path, plan, lines);
}

PathSummary summary_of(const Spec& spec, const Plan& played) {
  const auto& path = std::get<PathSpec>(spec.subject);
  const bool overridden = !path.override_steps.empty();
  const Plan plan =
      overridden ? jounce::plan(path.program, path.limits, {.joints = path.joints}) : played;
  const PathLength length(plan);
  PathSummary summary{.duration = plan.duration(),
                      .played = overridden ? std::optional(played.duration()) : std::nullopt,
                      .stop_duration = plan.stop_duration(),
                      .lower_bound = lower_bound(plan),
                      .length = length.whole(),
                      .cost = {},
                      .corners = plan.corners(),
                      .events = {},
                      .along = path_report(spec, played),
                      .fit = plan.given().fit};
  summary.cost = cost_of(plan, summary.corners);
  name_dwells(path.program, plan, summary.cost);
  for (SpeedLoss& loss : summary.cost.losses) loss.where = length.at(loss.where).length;
  for (CornerRecord& corner : summary.corners) corner.where = length.at(corner.where).length;
  summary.events = places_of(path, played, path.events);
  return summary;
}

}  // namespace jounce
