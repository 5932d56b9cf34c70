// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/group_queue.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/group/group_command.hpp"
#include "executor/src/group/group_text.hpp"

namespace jounce {
namespace {

bool rests(const Tick& group) {
  return group.state == State::standstill && group.job == 0;
}

}  // namespace

GroupQueue::GroupQueue(const ExecutorGroup& group, Worker& worker, std::size_t most_at_once,
                       std::function<Point()> places, ProgramOf program_of)
    : group_(std::make_shared<const ExecutorGroup>(group)),
      limited_(group_),
      places_(std::move(places)),
      program_of_(std::move(program_of)),
      planner_(worker, most_at_once),
      sent_(stages_, planner_, group_) {}

void GroupQueue::take(const ClientCommand& command, const Request& request) {
  waiting_.push_back({command, request});
}

GroupQueue::~GroupQueue() {
  drop_attempt();
}

void GroupQueue::clear() {
  stages_.drop("the waiting commands do not begin");
  drop_attempt();
  idle_.clear();
  cancel();
}

/// The worker ends its plan soon.
void GroupQueue::drop_attempt() {
  if (attempt_ && attempt_->canceled) *attempt_->canceled = true;
  attempt_.reset();
}

/// The outcome of a step that the axis has still counts.
void GroupQueue::cancel() {
  if (attempt_ && attempt_->program) return waiting_.resize(1);
  waiting_.clear();
  drop_attempt();
  halting_ = false;
  next_way_ = Way::shorter;
}

std::optional<GroupStep> GroupQueue::next(const Tick& group) {
  if (group.state == State::disabled) frame_ = {};
  if (group.tick != seen_) rate_ = std::exchange(rate_seen_, group.rate);
  seen_ = group.tick;
  finished_ = group.finished;
  if (stages_.starts()) return std::nullopt;
  if (auto step = begin_stage(group)) return step;
  if (std::string notice = stages_.take_notice(); !notice.empty())
    return group_step::Note{std::move(notice)};
  if (auto step = sent_.next(group)) return step;
  if (waiting_.empty()) return std::nullopt;
  if (attempt_ && attempt_->program) return std::nullopt;
  return attempt_ ? proceed(group) : begin(group);
}

/// At the end of the present motion. If the motion was ended before, the stages are dropped.
std::optional<GroupStep> GroupQueue::begin_stage(const Tick& group) {
  const bool keeps_path = group.state == State::error_stop && group.job != 0;
  if (stages_.empty() || in_motion(group) || keeps_path) return std::nullopt;
  Stage& stage = stages_.first();
  if (!rests(group) || (stage.finished && group.finished <= *stage.finished)) {
    stages_.drop();
    return std::nullopt;
  }
  if (stage.sent && !stage.gate) stage.gate = stages_.step_gate();
  if (stages_.closed())
    return stages_.wait_at_gate(group.tick, seconds(group_->configs.front().period));
  // A command that is being planned belongs to the last stage.
  const bool grows = attempt_ && attempt_->way == Way::after && !attempt_->adds_stage;
  if (grows && stages_.size() == 1) return std::nullopt;
  if (stage.sent && !sent_.prepare()) return std::nullopt;
  return play_stage(group);
}

/// The first stage begins if it has a motion; otherwise the next one.
std::optional<GroupStep> GroupQueue::play_stage(const Tick& group) {
  const Stage& stage = stages_.first();
  if (!stage.program) {
    stages_.end_first({});
    return begin_stage(group);
  }
  stages_.start();
  return group_step::Play{
      .program = stage.program,
      .request = {.kind = CommandKind::move_linear_absolute},
      .own_limits = !stage.sent && !stage.commands.has_limits(path_limits_, axis_limits_)};
}

/// The group has the first stage, or has rejected it.
void GroupQueue::stage_answered(bool accepted, std::uint64_t movement) {
  if (!accepted) {
    stages_.drop();
    return;
  }
  Stage& stage = stages_.first();
  if (stage.sent)
    sent_.begins(movement, stage);
  else
    playing_ = Playing{.movement = movement,
                       .commands = std::move(stage.commands),
                       .program = stage.program,
                       .group = stage.group,
                       .finished = finished_};
  from_rest_ = false;
  stages_.end_first(finished_);
}

void GroupQueue::answered(bool accepted, std::uint64_t movement) {
  stages_.begin_motion();
  if (sent_.answered(accepted, movement, finished_)) return;
  if (stages_.take_start()) return stage_answered(accepted, movement);
  if (!attempt_ || !attempt_->program) return;
  if (accepted) {
    playing_ = Playing{movement,
                       std::move(attempt_->commands),
                       std::move(attempt_->program),
                       std::move(attempt_->group),
                       attempt_->origin,
                       attempt_->fast,
                       finished_};
    idle_.clear();
    if (attempt_->way == Way::rest) from_rest_ = false;
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

void GroupQueue::begins(std::uint64_t movement, std::shared_ptr<const GroupProgram> motion,
                        std::shared_ptr<const SentProgram> sent, std::size_t last,
                        const Tick& group) {
  sent_.begins(movement, std::move(motion), std::move(sent), last, group);
}

/// Number of the single commands that have not ended, and do not belong to a stage.
std::size_t GroupQueue::unfinished(const Tick& group) const {
  const auto played =
      plays(group) ? static_cast<std::size_t>(playing_->commands.last() - current(group) + 1) : 0;
  return played + waiting_.size() + idle_.size();
}

std::size_t GroupQueue::size(const Tick& group) const {
  return unfinished(group) + stages_.commands();
}

std::size_t GroupQueue::taken(const Tick& group) const {
  return unfinished(group) + stages_.taken();
}

std::optional<std::int32_t> GroupQueue::command(const Tick& group) const {
  return plays(group) ? std::optional(current(group)) : std::nullopt;
}

/// The first command is done with.
group_step::Reply GroupQueue::finish(Cause cause, const std::string& reason) {
  const Request request = waiting_.front().request;
  waiting_.pop_front();
  attempt_.reset();
  halting_ = false;
  next_way_ = Way::shorter;
  return {request, cause, reason};
}

// ---- the next command --------------------------------------------------------------------------

std::optional<GroupStep> GroupQueue::begin(const Tick& group) {
  const auto& [command, request] = waiting_.front();
  if (releasing_ && group.state == State::stopping) return std::nullopt;
  if (const Cause no = permitted(group.state, kind_of(command)); no != Cause::none)
    return finish(no);
  try {
    if (const auto* const what = std::get_if<command::GroupSetLimits>(&command)) {
      const group_step::SetLimits step{*what, request, continues(group)};
      finish(Cause::none);
      return step;
    }
    if (auto step = set_frame(command, group)) return step;
    if (const auto* const what = std::get_if<command::GroupMWord>(&command)) {
      if (what->number < 1) throw InputError("M word", "0", "must be at least 1");
      add_stage(group, Gate{.m_word = what->number, .timeout = what->timeout});
      return finish(Cause::none);
    }
    if (is_fast(command) && blends(command))
      throw InputError("fast", "", "begins and ends at rest: leave out --blend");
    const bool ends_motion = !halting_ && !(rests(group) && stages_.empty());
    if (aborts(command) && ends_motion)
      if (const auto [cause, reason] = invalid_target(); cause != Cause::none)
        return finish(cause, reason);
    if (aborts(command)) stages_.drop("an aborting command replaces the waiting commands");
    if (aborts(command) && !rests(group) && !halting_ && sent_.plays(group))
      stages_.notify("an aborting command ends the program that plays: its rest is dropped");
    if (rests(group)) halting_ = releasing_ = false;
    if (rests(group) && stages_.empty() && !single_step()) return fresh(group);
    if (is_fast(command) && (!aborts(command) || rests(group)))
      return finish(Cause::in_motion,
                    "a fast move begins at rest: send it when the group rests, or with the buffer "
                    "mode aborting");
    if (aborts(command) && !rests(group))
      return std::exchange(halting_, true) ? std::nullopt
                                           : std::optional(GroupStep(group_step::Halt{}));
    if (next_way_ == Way::rest) return follow(group);
    if (auto step = joined(group)) return step;
    return proceed(group);
  } catch (const InputError& error) {
    return finish(Cause::no_value, reason_of(error, *group_));
  }
}

/// A command that changes the frame of the commands after it; nullopt: it is another command.
std::optional<GroupStep> GroupQueue::set_frame(const ClientCommand& command, const Tick& group) {
  const std::size_t axes = group_->coordinates().size();
  if (const auto* const what = std::get_if<command::SetCoordinateTransform>(&command)) {
    frame_ = frame_of(*what, axes, group_->path_axes());
    return finish(Cause::none);
  }
  const auto* const what = std::get_if<command::GroupSetPosition>(&command);
  if (what == nullptr) return std::nullopt;
  frame_ = shifted(frame_, *what, end_of(group), axes);
  return finish(Cause::none);
}

void GroupQueue::limit(GroupDynamics::Next next, bool from_rest) {
  group_ = std::make_shared<const ExecutorGroup>(std::move(next.group));
  limited_ = std::make_shared<const ExecutorGroup>(std::move(next.limited));
  path_limits_ = next.path;
  axis_limits_ = std::move(next.axes);
  from_rest_ = from_rest_ || from_rest;
}

/// True if the next command may continue the present motion.
bool GroupQueue::continues(const Tick& group) const {
  return plays(group) && !playing_->fast && stages_.empty() && !from_rest_ && !single_step();
}

double GroupQueue::highest_rate() const {
  return attempt_ && attempt_->made && attempt_->made->program
             ? highest_rate_of(*attempt_->made->program)
             : 2;
}

Cause GroupQueue::rests_because(const Tick& group) const {
  if (const Cause cause = stages_.rests_because(in_motion(group)); cause != Cause::none)
    return cause;
  const bool ended = playing_ && !in_motion(group) && group.reason == Cause::none &&
                     group.finished == playing_->finished + 1;
  const auto end = ended ? playing_->commands.jog_end() : std::nullopt;
  return end ? end->cause : Cause::none;
}

/// Appends the first waiting command. The answer to it names a velocity that the limits lower.
void GroupQueue::append(PathCommands& commands, const ExecutorGroup& group) {
  const auto& [command, request] = waiting_.front();
  const GroupSpace space = space_of(group);
  try {
    commands.append(command, space);
  } catch (const JogLeadsOutward& error) {
    const JogEnd& end = error.end;
    if (end.cause != Cause::range_end) throw;
    const std::vector<std::string>& names = end.of_joint ? group.names : group.coordinates();
    throw InputError("the jog", "",
                     "leads outward: " + names[end.index] + " stands at the end of its range, " +
                         end_of_range(end, group) + ": jog in another direction");
  }
  std::string note = velocity_note(commands, space, group, is_fast(command));
  if (!note.empty()) waiting_.front().request.note = std::move(note);
}

/// A stage without commands, after all others.
void GroupQueue::add_stage(const Tick& group, std::optional<Gate> gate) {
  const bool rests_before = stages_.empty() && rests(group);
  stages_.add({.commands = commands_from(end_of(group), *group_),
               .program = nullptr,
               .group = group_,
               .finished = rests_before ? std::nullopt : std::optional(group.finished),
               .gate = gate});
}

/// The reason to reject the first waiting command from any place of rest: the present motion then
/// continues. Cause::none: no reason, or the place of rest decides.
std::pair<Cause, std::string> GroupQueue::invalid_target() const {
  if (group_->kinematics) return {};
  const Point place = coordinates_of(places_(), *group_);
  const auto line = line_to_target(waiting_.front().command, group_->coordinates().size(), frame_);
  if (!line) return {};
  try {
    PathCommands commands = commands_from(place, *group_);
    commands.set_frame(frame_);
    commands.append(*line);
    std::string reason =
        planned_motion({.commands = std::move(commands)}, *group_, std::atomic<bool>(false)).reason;
    return {reason.empty() ? Cause::none : Cause::bad_table, std::move(reason)};
  } catch (const InputError& error) {
    return {Cause::no_value, reason_of(error, *group_)};
  }
}

/// A motion from rest. A wait alone moves nothing: it waits for the next command.
std::optional<GroupStep> GroupQueue::fresh(const Tick& group) {
  PathCommands commands = commands_from(end_of(group), *group_);
  commands.set_frame(frame_);
  commands.set_limits(path_limits_, axis_limits_);
  passed_ = first_passed;
  if (aborts(waiting_.front().command)) idle_.clear();
  const ClientCommand& command = waiting_.front().command;
  const bool fast = is_fast(command);
  if (!fast)
    for (const command::GroupWait& wait : idle_) commands.append(wait);
  append(commands, *limited_);
  if (commands.moves()) {
    plan(Way::rest,
         {.commands = std::move(commands), .fast = fast ? std::optional(places_()) : std::nullopt},
         fast ? limited_ : group_);
    return proceed(group);
  }
  if (idle_.size() >= most_commands)
    return finish(Cause::buffer_full, std::to_string(most_commands) + " waits are queued");
  idle_.push_back(std::get<command::GroupWait>(waiting_.front().command));
  return finish(Cause::none);
}

/// The coordinates at the end of the last command.
Point GroupQueue::end_of(const Tick& group) const {
  if (!stages_.empty()) return stages_.last().commands.position();
  if (rests(group)) return coordinates_of(places_(), *group_);
  if (plays(group)) return playing_->commands.position();
  if (sent_.plays(group)) return sent_.end();
  const auto program = program_of_ ? program_of_(group.job) : nullptr;
  if (!program) throw InputError("command", "", "cannot follow the present motion: send it again");
  const Path& path = program->plan->path();
  return path.point(path.pieces().size() - 1, path.pieces().back().length);
}

/// The command follows the end of the last command, at rest.
std::optional<GroupStep> GroupQueue::follow(const Tick& group) {
  if (taken(group) >= most_commands)
    return finish(Cause::buffer_full, std::to_string(taken(group)) + " commands wait (limit " +
                                          std::to_string(most_commands) +
                                          "): send this one again later");
  const bool adds = stages_.empty() || single_step() || stages_.last().sent.has_value();
  PathCommands commands = adds ? commands_from(end_of(group), *group_) : stages_.last().commands;
  commands.set_frame(frame_);
  commands.set_limits(path_limits_, axis_limits_);
  append(commands, *limited_);
  if (!commands.moves() && next_way_ == Way::rest) return std::nullopt;  // until the group rests
  if (!commands.moves())
    return finish(Cause::in_motion, "a wait needs a motion before it: send it after the next line");
  plan(Way::after, {.commands = std::move(commands)}, group_);
  attempt_->adds_stage = adds;
  return proceed(group);
}

/// The command continues the present motion.
std::optional<GroupStep> GroupQueue::joined(const Tick& group) {
  if (!continues(group)) return follow(group);
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
  commands.set_frame(frame_);
  commands.set_limits(path_limits_, axis_limits_);
  append(commands, *playing_->group);
  if (next_way_ == Way::stopping) commands = commands.stopping();
  plan(next_way_,
       {.commands = std::move(commands),
        .before = playing_->program,
        .q = group.position - playing_->origin},
       playing_->group);
  return std::nullopt;
}

void GroupQueue::plan(Way way, PlanTask task, std::shared_ptr<const ExecutorGroup> group) {
  Attempt attempt{way, task.commands, {}, std::make_shared<std::atomic<bool>>(false), group};
  attempt.fast = task.fast.has_value();
  const std::size_t size = task.commands.size();
  const auto work = [task = std::move(task), group = std::move(group),
                     canceled = attempt.canceled] {
    return planned_motion(task, *group, *canceled);
  };
  attempt.planned = planner_.begin(size, work);
  attempt_.emplace(std::move(attempt));
}

/// The planning has ended, or goes on.
std::optional<GroupStep> GroupQueue::proceed(const Tick& group) {
  if (!attempt_->made) {
    if (!is_ready(attempt_->planned)) return std::nullopt;
    attempt_->made = attempt_->planned.get();
  }
  PlannedMotion& made = *attempt_->made;
  if (const std::string reason = made.reason; !reason.empty())
    return finish(Cause::bad_table, reason);
  const Request& request = waiting_.front().request;
  if (attempt_->way == Way::after) {
    if (attempt_->adds_stage || stages_.empty()) add_stage(group, stages_.step_gate());
    Stage& stage = stages_.last();
    stage.commands = std::move(attempt_->commands);
    stage.program = std::move(made.program);
    stage.group = std::move(attempt_->group);
    return finish(Cause::none);
  }
  if (attempt_->way == Way::rest) {
    attempt_->program = made.program;
    const auto& jog = attempt_->commands.jog_end();
    return group_step::Play{
        .program = std::move(made.program),
        .request = request,
        .notice = jog ? text_of(*jog, *group_) : "",
        .own_limits = !attempt_->commands.has_limits(path_limits_, axis_limits_)};
  }
  if (!made.agreement) {
    fail();
    return std::nullopt;
  }
  if (!takes_over(group)) return std::nullopt;
  attempt_->program = made.program;
  attempt_->origin = playing_->origin + made.agreement->position;
  return made.extension(attempt_->origin, request);
}

/// True if the rate of the group suits the longer plan, or if the group rests.
bool GroupQueue::takes_over(const Tick& group) const {
  const double most = highest_rate();
  const bool slower =
      most < highest_rate_of(*playing_->program) * (1 - profiles_detail::rounded_sum);
  return !slower || !plays(group) || (group.rate == rate_ && group.rate <= most);
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
