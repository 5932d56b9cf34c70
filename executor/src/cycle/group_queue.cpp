// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/group_queue.hpp"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "jounce/axis/group_program.hpp"
#include "jounce/command/command_table.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

GroupLimits limits_of(const std::vector<AxisConfig>& configs) {
  GroupLimits limits = within({.axes = std::vector<Limits>(configs.size())}, configs);
  for (std::size_t k = 0; k < configs.size(); ++k) {
    limits.axes[k].position_min = configs[k].limits.position_min;
    limits.axes[k].position_max = configs[k].limits.position_max;
  }
  return limits;
}

/// The slope of the rate must hold also for the programs that continue this one: the axes may use
/// their limits there.
GroupProgram with_peaks_of_limits(GroupProgram program) {
  for (GroupAxis& axis : program.axes) {
    const Limits& limits = axis.config.limits;
    axis.peaks = {.velocity = *limits.velocity,
                  .acceleration = *limits.acceleration,
                  .jerk = limits.jerk.value_or(axis.peaks.jerk)};
  }
  return program;
}

/// The sentence of an error. A coordinate, such as "to[1]", has the name of its axis.
std::string reason_of(const InputError& error, const std::vector<std::string>& axes) {
  std::string key = error.key();
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (key == "to[" + std::to_string(i + 1) + "]") key = axes[i] + " =";
  if (key == "to" || key == "by") key = "--" + key;
  return key + (error.value().empty() ? "" : " " + error.value()) + " " + error.rule();
}

bool aborts(const ClientCommand& command) {
  return std::visit(
      [](const auto& what) {
        if constexpr (requires { what.path.buffer; })
          return what.path.buffer == PathBuffer::aborting;
        return what.kind == CommandKind::group_jog;
      },
      command);
}

bool rests(const Tick& group) {
  return group.state == State::standstill && group.job == 0;
}

}  // namespace

GroupQueue::GroupQueue(const ExecutorGroup& group, Worker& worker, std::size_t most_at_once,
                       std::function<Point()> places)
    : group_(std::make_shared<const ExecutorGroup>(group)),
      worker_(worker),
      most_at_once_(most_at_once),
      places_(std::move(places)) {}

void GroupQueue::take(const ClientCommand& command, const Request& request) {
  waiting_.push_back({command, request});
}

void GroupQueue::clear() {
  attempt_.reset();
  idle_.clear();
  cancel();
}

/// The outcome of a step that the axis has still counts.
void GroupQueue::cancel() {
  if (attempt_ && attempt_->program) return waiting_.resize(1);
  waiting_.clear();
  attempt_.reset();
  halting_ = false;
  next_way_ = Way::shorter;
}

std::optional<GroupQueue::Step> GroupQueue::next(const Tick& group) {
  if (waiting_.empty()) return std::nullopt;
  if (attempt_ && attempt_->program) return std::nullopt;
  return attempt_ ? proceed() : begin(group);
}

void GroupQueue::answered(bool accepted, std::uint64_t movement) {
  if (!attempt_ || !attempt_->program) return;
  if (accepted) {
    playing_ = Playing{movement, std::move(attempt_->commands), std::move(attempt_->program),
                       attempt_->origin};
    idle_.clear();
  }
  if (accepted || attempt_->way == Way::rest) {
    finish(Cause::none);
  } else {
    fail();
  }
}

/// The next way. A program that is too short gets longer the next time.
void GroupQueue::fail() {
  if (attempt_->way == Way::shorter)
    passed_ = std::min(2 * passed_, static_cast<std::int32_t>(most_commands));
  next_way_ = static_cast<Way>(static_cast<int>(attempt_->way) + 1);
  attempt_.reset();
}

std::size_t GroupQueue::size(const Tick& group) const {
  const auto played =
      plays(group) ? static_cast<std::size_t>(playing_->commands.last() - current(group) + 1) : 0;
  return played + waiting_.size() + idle_.size();
}

/// The first command is done with.
GroupQueue::Reply GroupQueue::finish(Cause cause, const std::string& reason) {
  const Request request = waiting_.front().request;
  waiting_.pop_front();
  attempt_.reset();
  halting_ = false;
  next_way_ = Way::shorter;
  return {request, cause, reason};
}

// ---- the next command --------------------------------------------------------------------------

std::optional<GroupQueue::Step> GroupQueue::begin(const Tick& group) {
  const auto& [command, request] = waiting_.front();
  if (releasing_ && group.state == State::stopping) return std::nullopt;
  if (const Cause no = permitted(group.state, kind_of(command)); no != Cause::none)
    return finish(no);
  try {
    if (rests(group)) {
      halting_ = releasing_ = false;
      return fresh();
    }
    if (aborts(command))
      return std::exchange(halting_, true) ? std::nullopt : std::optional(Step(Halt{}));
    if (next_way_ == Way::rest) return std::nullopt;  // the present motion ends first
    if (auto step = joined(group)) return step;
    return proceed();
  } catch (const InputError& error) {
    return finish(Cause::no_value, reason_of(error, group_->names));
  }
}

/// A motion from rest. A wait alone moves nothing: it waits for the next command.
std::optional<GroupQueue::Step> GroupQueue::fresh() {
  PathCommands commands(group_->names.size(), places_());
  passed_ = first_passed;
  if (aborts(waiting_.front().command)) idle_.clear();
  for (const command::GroupWait& wait : idle_) commands.append(wait);
  commands.append(waiting_.front().command, group_->configs);
  if (commands.moves()) {
    plan(Way::rest, std::move(commands), nullptr);
    return proceed();
  }
  if (idle_.size() >= most_commands)
    return finish(Cause::buffer_full, std::to_string(most_commands) + " waits are queued");
  idle_.push_back(std::get<command::GroupWait>(waiting_.front().command));
  return finish(Cause::none);
}

/// The command continues the present motion.
std::optional<GroupQueue::Step> GroupQueue::joined(const Tick& group) {
  if (!plays(group))
    return finish(Cause::in_motion,
                  "the group plays a path that was sent as a whole: wait for its end, or send the "
                  "command with the buffer mode aborting");
  const std::int32_t now = current(group);
  const PathCommands& all = playing_->commands;
  if (all.size() >= 2 * most_commands)
    return finish(Cause::buffer_full, "the motion has " + std::to_string(all.size()) +
                                          " commands that must be planned together: send this "
                                          "one when the group rests");
  if (static_cast<std::size_t>(all.last() - now + 1) >= most_commands)
    return finish(Cause::buffer_full, std::to_string(all.last() - now + 1) +
                                          " commands wait (limit " + std::to_string(most_commands) +
                                          "): send this one again later");
  const bool shortens = now - all.first() > passed_;
  if (next_way_ == Way::shorter && !shortens) next_way_ = Way::longer;
  PathCommands commands = next_way_ == Way::shorter  ? all.from(now - passed_ / 2)
                          : next_way_ == Way::slower ? all.slowed(*playing_->program->plan)
                                                     : all;
  commands.append(waiting_.front().command, group_->configs);
  if (next_way_ == Way::stopping) commands = commands.stopping();
  plan(next_way_, std::move(commands), &group);
  return std::nullopt;
}

/// Plans at once, or starts the planning in the thread of the worker. `group`: null for a motion
/// from rest.
void GroupQueue::plan(Way way, PathCommands commands, const Tick* group) {
  const auto before = group != nullptr ? playing_->program : nullptr;
  const double q = group != nullptr ? group->position - playing_->origin : 0;
  const auto work = [commands, group_of = group_, before, q] {
    return planned(commands, *group_of, before.get(), q);
  };
  std::future<Planned> result;
  if (commands.size() > most_at_once_) {
    result = worker_.ask(work);
  } else {
    std::promise<Planned> now;
    now.set_value(work());
    result = now.get_future();
  }
  attempt_.emplace(Attempt{way, std::move(commands), std::move(result)});
}

GroupQueue::Planned GroupQueue::planned(const PathCommands& commands, const ExecutorGroup& group,
                                        const GroupProgram* before, double q) {
  try {
    auto path =
        std::make_shared<const Plan>(jounce::plan(commands.program(), limits_of(group.configs)));
    Planned made;
    if (before != nullptr) {
      made.agreement = agreement(*before->plan, *path, q);
      if (!made.agreement) return made;
    }
    made.program = std::make_shared<const GroupProgram>(with_peaks_of_limits(
        group_program(std::move(path), group.configs, group.names, group.unit)));
    return made;
  } catch (const InputError& error) {
    return {.reason = reason_of(error, group.names)};
  } catch (const std::bad_alloc&) {
    return {.reason = "the path does not fit into the memory of the executor"};
  }
}

/// The planning has ended.
std::optional<GroupQueue::Step> GroupQueue::proceed() {
  if (attempt_->planned.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  Planned made = attempt_->planned.get();
  if (!made.reason.empty()) return finish(Cause::bad_table, made.reason);
  const Request& request = waiting_.front().request;
  if (attempt_->way == Way::rest) {
    attempt_->program = made.program;
    return Play{std::move(made.program), request};
  }
  if (!made.agreement) {
    fail();
    return std::nullopt;
  }
  attempt_->program = made.program;
  attempt_->origin = playing_->origin + made.agreement->position;
  return Extend{std::move(made.program), attempt_->origin, made.agreement->shift,
                made.agreement->until, request};
}

// ---- the present motion ------------------------------------------------------------------------

bool GroupQueue::plays(const Tick& group) const {
  return playing_ && group.job == playing_->movement;
}

/// Number of the command that the group plays.
std::int32_t GroupQueue::current(const Tick& group) const {
  const auto pieces = playing_->program->plan->path().pieces();
  const double q = group.position - playing_->origin;
  const auto after = std::upper_bound(pieces.begin() + 1, pieces.end(), q,
                                      [](double at, const PathPiece& p) { return at < p.start; });
  const PathPiece& here = *std::prev(after);
  return playing_->commands.number_at(here.line, q - here.start);
}

}  // namespace jounce
