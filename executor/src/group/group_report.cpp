// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/group_report.hpp"

#include <algorithm>

#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/executor/detail/sent_program.hpp"

namespace jounce {
namespace {

/// The time to the end of the path, if the group moves. At another rate than 1, it is an estimate:
/// the time of the path at the override that is set, at 100 % if it is 0. A hold does not count.
void add_remaining(wire::GroupStatus& status, const Tick& tick, double remaining, bool exact) {
  if (tick.state != State::discrete_motion) return;
  status.estimated = !exact || tick.held || tick.rate != 1 || tick.override_ != 1;
  status.remaining_s = remaining / (tick.override_ > 0 ? tick.override_ : 1);
}

/// The coordinates in the frame of the commands.
std::vector<double> place_of(const Point& places, const ExecutorGroup& group, const Frame& frame) {
  const std::size_t n = group.coordinates().size();
  std::vector<double> place(n, wire::Status::unknown);
  const auto tool = tool_of(places, group);
  if (!tool) return place;
  const Point part = frame == Frame{} ? *tool : within(frame, *tool);
  std::copy_n(part.begin(), n, place.begin());
  return place;
}

}  // namespace

wire::GroupStatus GroupReport::status(const ExecutorGroup& group, const Tick& tick,
                                      const Point& places,
                                      const std::shared_ptr<const GroupProgram>& program,
                                      const GroupQueue& queue) {
  wire::GroupStatus status{.tick = tick.tick,
                           .axes = group.coordinates(),
                           .place = place_of(places, group, queue.frame()),
                           .framed = queue.frame() != Frame{},
                           .commands = static_cast<std::uint32_t>(queue.size(tick)),
                           .position = std::max(0.0, tick.position),
                           .feed = std::max(0.0, tick.velocity),
                           .units = group.coordinate_units()};
  if (program_ != program) {
    program_ = program;
    progress_.reset();
    if (program) progress_.emplace(program->plan);
  }
  if (!progress_) return status;
  const PlanPlace place = progress_->at(tick.path_time);
  const WindowRest beyond = queue.beyond(tick);
  status.length = status.position + program->plan->path().length() - place.position + beyond.length;
  status.look_ahead = place.look_ahead;
  status.line = queue.command(tick).value_or(std::max(0, place.line));
  if (!queue.command(tick)) status.commands += static_cast<std::uint32_t>(place.commands);
  add_remaining(status, tick, place.remaining + beyond.time, beyond.time == 0);
  return status;
}

}  // namespace jounce
