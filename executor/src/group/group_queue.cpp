// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/group_queue.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <new>
#include <utility>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/axis/detail/path_clock.hpp"
#include "jounce/base/document.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// The slope of the rate must hold also for the programs that continue this one: the axes may use
/// their limits there. If this program has a reserve, it can be played at a higher rate h. The peaks
/// then are those of a program that uses the limits at this rate.
GroupProgram with_peaks_of_limits(GroupProgram program) {
  double h = 2;
  for (const GroupAxis& axis : program.axes) h = std::min(h, highest_rate(axis.peaks, axis.config));
  for (GroupAxis& axis : program.axes) {
    const Limits& limits = axis.config.limits;
    axis.peaks = {.velocity = *limits.velocity / h,
                  .acceleration = *limits.acceleration / (h * h),
                  .jerk = limits.jerk ? *limits.jerk / (h * h * h) : axis.peaks.jerk};
  }
  return program;
}

/// The highest rate of such a program.
double highest_rate_of(const GroupProgram& program) {
  double rate = 2;
  for (const GroupAxis& axis : program.axes)
    rate = std::min(rate, highest_rate(axis.peaks, axis.config));
  return rate;
}

/// The unit of the coordinates of commands.
const std::string& unit_of(const ExecutorGroup& group) {
  return group.kinematics ? group.kinematics->unit : group.unit;
}

/// Keys of the errors of a path that are options of `jounce order`: corner_distance is
/// "--corner-distance".
constexpr std::array option_keys{
    "to",   "by",   "via",       "center",          "radius",   "clockwise",    "turns",
    "fast", "axis", "deviation", "corner_distance", "velocity", "acceleration", "deceleration",
    "jerk", "zyz",  "along",     "offset",          "rotation", "blend"};

/// The option for a key; "" for another key.
std::string option_of(std::string key) {
  if (key == "VALUE") return key;
  if (std::find(option_keys.begin(), option_keys.end(), key) == option_keys.end()) return "";
  std::replace(key.begin(), key.end(), '_', '-');
  return "--" + key;
}

/// The key of the library for a coordinate of the end of a command.
std::string to_key(std::size_t axis) {
  return "to[" + std::to_string(axis + 1) + "]";
}

/// The sentence of an error, with units. A coordinate, such as "to[1]", has the name of its axis.
std::string reason_of(const InputError& plain, const ExecutorGroup& group) {
  const std::vector<std::string>& axes = group.coordinates();
  const std::string& unit = unit_of(group);
  const std::vector<std::string> units = group.coordinate_units();
  Document document;
  for (std::size_t i = 0; i < axes.size(); ++i) document.units[to_key(i)] = units[i];
  constexpr std::array lengths{"center", "radius", "deviation", "corner_distance"};
  const bool is_length = std::find(lengths.begin(), lengths.end(), plain.key()) != lengths.end();
  if (is_length) document.units[plain.key()] = unit;
  const InputError error = document.located(plain);
  const auto sentence = [&](const std::string& name) {
    return name + (error.value().empty() ? "" : " = " + error.value()) + ": " + error.rule();
  };
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (error.key() == to_key(i)) return sentence(axes[i]);
  if (const std::string option = option_of(error.key()); !option.empty()) return sentence(option);
  return error.key() + (error.value().empty() ? "" : " " + error.value()) + " " + error.rule();
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

/// True for a move in which each axis takes its own shortest time.
bool is_fast(const ClientCommand& command) {
  return std::visit(
      [](const auto& what) {
        if constexpr (requires { what.fast; }) return what.fast;
        return false;
      },
      command);
}

bool blends(const ClientCommand& command) {
  return std::visit(
      [](const auto& what) {
        if constexpr (requires { what.path.buffer; })
          return what.path.buffer >= PathBuffer::blending_low;
        return false;
      },
      command);
}

bool rests(const Tick& group) {
  return group.state == State::standstill && group.job == 0;
}

std::string dropped_text(std::size_t commands) {
  return std::to_string(commands) +
         (commands == 1 ? " command was dropped" : " commands were dropped");
}

}  // namespace

GroupQueue::GroupQueue(const ExecutorGroup& group, Worker& worker, std::size_t most_at_once,
                       std::function<Point()> places, ProgramOf program_of)
    : group_(std::make_shared<const ExecutorGroup>(group)),
      base_(group_),
      worker_(worker),
      most_at_once_(most_at_once),
      places_(std::move(places)),
      program_of_(std::move(program_of)),
      limited_(group_) {}

void GroupQueue::take(const ClientCommand& command, const Request& request) {
  waiting_.push_back({command, request});
}

GroupQueue::~GroupQueue() {
  drop_attempt();
}

void GroupQueue::clear() {
  if (const std::size_t dropped = drop_stages(); dropped > 0)
    dropped_because_ = "the waiting commands do not begin: " + dropped_text(dropped);
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

std::optional<GroupQueue::Step> GroupQueue::next(const Tick& group) {
  if (group.state == State::disabled) frame_ = {};
  if (group.tick != seen_) rate_ = std::exchange(rate_seen_, group.rate);
  seen_ = group.tick;
  finished_ = group.finished;
  if (starts_stage_) return std::nullopt;
  if (auto step = begin_stage(group)) return step;
  if (!dropped_because_.empty()) return Note{std::exchange(dropped_because_, {})};
  if (auto step = cut(group)) return step;
  if (auto step = next_window(group)) return step;
  if (waiting_.empty()) return std::nullopt;
  if (attempt_ && attempt_->program) return std::nullopt;
  return attempt_ ? proceed(group) : begin(group);
}

/// At the end of the present motion. If the motion was ended before, the stages are dropped.
std::optional<GroupQueue::Step> GroupQueue::begin_stage(const Tick& group) {
  const bool keeps_path = group.state == State::error_stop && group.job != 0;
  if (stages_.empty() || in_motion(group) || keeps_path) return std::nullopt;
  Stage& stage = stages_.front();
  if (!rests(group) || (stage.finished && group.finished <= *stage.finished)) {
    drop_stages();
    return std::nullopt;
  }
  if (single_step_ && stage.sent && !stage.gate) stage.gate = Gate{.is_step = true};
  if (stage.gate && !acknowledged_) return pass_gate(group);
  // A command that is being planned belongs to the last stage.
  const bool grows = attempt_ && attempt_->way == Way::after && !attempt_->adds_stage;
  if (grows && stages_.size() == 1) return std::nullopt;
  if (stage.sent && !prepare()) return std::nullopt;
  if (stages_.front().program) {
    starts_stage_ = true;
    const Stage& begins = stages_.front();
    return Play{
        .program = begins.program,
        .request = {.kind = CommandKind::move_linear_absolute},
        .own_limits = !begins.sent && !begins.commands.has_limits(path_limits_, axis_limits_)};
  }
  end_stage({});
  return begin_stage(group);
}

/// The group rests at a gate that is not open.
std::optional<GroupQueue::Step> GroupQueue::pass_gate(const Tick& group) {
  const Gate gate = *stages_.front().gate;
  const bool arrives = gate_since_ < 0;
  if (arrives) gate_since_ = group.tick;
  if (arrives && !gate.is_step) return Announce{gate.m_word, true};
  const double waited =
      static_cast<double>(group.tick - gate_since_) * seconds(group_->configs.front().period);
  if (!(gate.timeout > 0 && waited >= gate.timeout)) return std::nullopt;
  unacknowledged_ = true;
  return Announce{gate.m_word, false, gate.timeout, drop_stages() - 1};  // without the gate itself
}

/// Drops all stages but the one whose beginning the group has already. Returns the number of their commands.
std::size_t GroupQueue::drop_stages() {
  const auto first = stages_.begin() + (starts_stage_ ? 1 : 0);
  std::size_t dropped = 0;
  for (auto stage = first; stage != stages_.end(); ++stage) dropped += stage->size();
  stages_.erase(first, stages_.end());
  gate_since_ = -1;
  acknowledged_ = false;
  preparing_ = {};
  return dropped;
}

/// The first stage has begun, or has no motion.
void GroupQueue::end_stage(std::optional<std::uint64_t> finished) {
  stages_.pop_front();
  gate_since_ = -1;
  acknowledged_ = false;
  if (!stages_.empty()) stages_.front().finished = finished;
}

std::optional<std::int32_t> GroupQueue::m_word() const {
  const bool waits = gate_since_ >= 0 && !acknowledged_ && !stages_.empty();
  return waits && !stages_.front().gate->is_step ? std::optional(stages_.front().gate->m_word)
                                                 : std::nullopt;
}

Cause GroupQueue::acknowledge(std::int32_t number) {
  const bool waits = gate_since_ >= 0 && !acknowledged_ && !stages_.empty();
  if (!waits || (number != 0 && number != m_word())) return Cause::no_handshake;
  acknowledged_ = true;
  return Cause::none;
}

void GroupQueue::answered(bool accepted, std::uint64_t movement) {
  unacknowledged_ = false;
  if (cut_ && cut_->program) return cut_answered(accepted, movement);
  if (window_ && window_->program) return window_answered(accepted, movement);
  if (std::exchange(starts_stage_, false)) {
    Stage& stage = stages_.front();
    if (accepted && stage.sent)
      sent_ = PlayingSent{movement, stage.program, *stage.sent};
    else if (accepted)
      playing_ = Playing{.movement = movement,
                         .commands = std::move(stage.commands),
                         .program = stage.program,
                         .group = stage.group,
                         .finished = finished_};
    if (!accepted) {
      drop_stages();
      return;
    }
    from_rest_ = false;
    end_stage(finished_);
    return;
  }
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

std::size_t GroupQueue::size(const Tick& group) const {
  std::size_t all = taken(group);
  for (const Stage& stage : stages_)
    if (stage.sent && stage.sent->first < stage.sent->last)
      all += stage.sent->last - stage.sent->first - (stage.gate ? 1 : 0);
  return all;
}

std::size_t GroupQueue::taken(const Tick& group) const {
  const auto played =
      plays(group) ? static_cast<std::size_t>(playing_->commands.last() - current(group) + 1) : 0;
  std::size_t after = 0;
  for (const Stage& stage : stages_)
    after += !stage.sent  ? stage.size()
             : stage.gate ? (stage.sent->first < stage.sent->last ? 2 : 1)
                          : 0;  // it belongs to the present motion
  return played + after + waiting_.size() + idle_.size();
}

std::optional<std::int32_t> GroupQueue::command(const Tick& group) const {
  return plays(group) ? std::optional(current(group)) : std::nullopt;
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
    if (const auto* const what = std::get_if<command::GroupSetLimits>(&command)) {
      const SetLimits step{*what, request, continues(group)};
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
    if (aborts(command))
      if (const std::size_t dropped = drop_stages(); dropped > 0)
        dropped_because_ =
            "an aborting command replaces the waiting commands: " + dropped_text(dropped);
    if (aborts(command) && !rests(group) && !halting_ && sent_ && group.job == sent_->movement)
      dropped_because_ = "an aborting command ends the program that plays: its rest is dropped";
    if (rests(group)) halting_ = releasing_ = false;
    if (rests(group) && stages_.empty() && !single_step_) return fresh(group);
    if (is_fast(command) && (!aborts(command) || rests(group)))
      return finish(Cause::in_motion,
                    "a fast move begins at rest: send it when the group rests, or with the buffer "
                    "mode aborting");
    if (aborts(command) && !rests(group))
      return std::exchange(halting_, true) ? std::nullopt : std::optional(Step(Halt{}));
    if (next_way_ == Way::rest) return follow(group);
    if (auto step = joined(group)) return step;
    return proceed(group);
  } catch (const InputError& error) {
    return finish(Cause::no_value, reason_of(error, *group_));
  }
}

/// A command that changes the frame of the commands after it; nullopt: it is another command.
std::optional<GroupQueue::Step> GroupQueue::set_frame(const ClientCommand& command,
                                                      const Tick& group) {
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
  return plays(group) && !playing_->fast && stages_.empty() && !from_rest_ && !single_step_;
}

double GroupQueue::highest_rate() const {
  return attempt_ && attempt_->made && attempt_->made->program
             ? highest_rate_of(*attempt_->made->program)
             : 2;
}

namespace {

std::string valued(double number, const std::string& unit) {
  return six_digits(number) + (unit.empty() ? "" : " " + unit);
}

/// "12.5 mm": the end of the position range of an axis.
std::string end_of_range(const JogEnd& end, const ExecutorGroup& group) {
  const std::vector<std::string> units = end.of_joint ? group.units : group.coordinate_units();
  return valued(end.limit, end.index < units.size() ? units[end.index] : group.unit);
}

}  // namespace

/// The notice of a jog: where it ends, and why.
std::string GroupQueue::text_of(const JogEnd& end) const {
  std::string text = "the jog ends at";
  const std::vector<std::string>& names = group_->coordinates();
  const std::vector<std::string> units = group_->coordinate_units();
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? " " : ", ") + names[i] + " = " + valued(end.place[i], units[i]);
  const std::string& axis = end.of_joint ? group_->names[end.index] : names[end.index];
  if (end.cause == Cause::range_end)
    return text + ": there, " + axis + " reaches the end of its position range, " +
           end_of_range(end, *group_);
  if (end.cause == Cause::reach_end) return text + ": there, the reach of the joints ends";
  if (end.cause == Cause::singular_end)
    return text + ", before a singular position: there, " + axis +
           " limits the jog to 1 % of its velocity";
  return "";
}

Cause GroupQueue::rests_because(const Tick& group) const {
  if (gate_since_ >= 0 && !acknowledged_) return Cause::awaits_acknowledge;
  if (unacknowledged_ && !in_motion(group)) return Cause::no_acknowledge;
  const bool ended = playing_ && !in_motion(group) && group.reason == Cause::none &&
                     group.finished == playing_->finished + 1;
  const auto end = ended ? playing_->commands.jog_end() : std::nullopt;
  return end ? end->cause : Cause::none;
}

/// No commands yet, from this place.
PathCommands GroupQueue::commands_from(const Point& place) const {
  PathCommands commands(group_->coordinates().size(), place, 1, group_->path_axes());
  std::vector<double> modulo;
  for (const AxisConfig& axis : group_->configs) modulo.push_back(axis.modulo);
  if (!group_->kinematics) commands.set_modulo(std::move(modulo));
  return commands;
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
  const auto lowered = is_fast(command) ? std::nullopt : commands.lowered_velocity(space);
  const std::vector<std::string> units = group.coordinate_units();
  const std::string& axis_unit = units[commands.moves_only_follower().value_or(0)];
  const std::string unit = (axis_unit.empty() ? "u" : axis_unit) + "/s";
  const double given = commands.commanded_velocity();
  if (!lowered && axis_unit != units.front() && std::isfinite(given))
    waiting_.front().request.note =
        "only followers move, so the velocity is " + valued(given, unit);
  if (!lowered) return;
  waiting_.front().request.note =
      "the limits lower the velocity from " + six_digits(lowered->commanded) + " " + unit +
      (lowered->everywhere ? " to " : " to at most ") + six_digits(lowered->permitted) + " " + unit;
}

/// A stage without commands, after all others.
void GroupQueue::add_stage(const Tick& group, std::optional<Gate> gate) {
  const bool rests_before = stages_.empty() && rests(group);
  stages_.push_back({.commands = commands_from(end_of(group)),
                     .program = nullptr,
                     .group = group_,
                     .finished = rests_before ? std::nullopt : std::optional(group.finished),
                     .gate = gate});
}

namespace {

/// A line to the target of an absolute command, if the target does not depend on the place where the
/// command begins.
std::optional<command::MoveLinearAbsolute> line_to_target(const ClientCommand& command,
                                                          std::size_t axes, const Frame& frame) {
  const auto line = [&](const auto& what) -> std::optional<command::MoveLinearAbsolute> {
    if constexpr (requires {
                    what.to;
                    what.path;
                  }) {
      const auto end =
          what.to.begin() + static_cast<std::ptrdiff_t>(std::min(axes, what.to.size()));
      const auto missing =
          std::count_if(what.to.begin(), end, [](double x) { return std::isnan(x); });
      const bool none = missing == end - what.to.begin();
      if (!what.relative && !none && (missing == 0 || frame.shifts()))
        return command::MoveLinearAbsolute{.to = what.to};
    }
    return std::nullopt;
  };
  return std::visit(line, command);
}

}  // namespace

/// The reason to reject the first waiting command from any place of rest: the present motion then
/// continues. Cause::none: no reason, or the place of rest decides.
std::pair<Cause, std::string> GroupQueue::invalid_target() const {
  if (group_->kinematics) return {};
  const Point place = coordinates_of(places_(), *group_);
  const auto line = line_to_target(waiting_.front().command, group_->coordinates().size(), frame_);
  if (!line) return {};
  try {
    PathCommands commands = commands_from(place);
    commands.set_frame(frame_);
    commands.append(*line);
    std::string reason =
        planned({.commands = std::move(commands)}, *group_, std::atomic<bool>(false)).reason;
    return {reason.empty() ? Cause::none : Cause::bad_table, std::move(reason)};
  } catch (const InputError& error) {
    return {Cause::no_value, reason_of(error, *group_)};
  }
}

/// A motion from rest. A wait alone moves nothing: it waits for the next command.
std::optional<GroupQueue::Step> GroupQueue::fresh(const Tick& group) {
  PathCommands commands = commands_from(end_of(group));
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
  if (!stages_.empty()) return stages_.back().commands.position();
  if (rests(group)) return coordinates_of(places_(), *group_);
  if (plays(group)) return playing_->commands.position();
  if (sent_ && group.job == sent_->movement)
    return sent_->part.of->sent.program.place_before(sent_->part.last);
  const auto program = program_of_ ? program_of_(group.job) : nullptr;
  if (!program) throw InputError("command", "", "cannot follow the present motion: send it again");
  const Path& path = program->plan->path();
  return path.point(path.pieces().size() - 1, path.pieces().back().length);
}

/// The command follows the end of the last command, at rest.
std::optional<GroupQueue::Step> GroupQueue::follow(const Tick& group) {
  if (taken(group) >= most_commands)
    return finish(Cause::buffer_full, std::to_string(taken(group)) + " commands wait (limit " +
                                          std::to_string(most_commands) +
                                          "): send this one again later");
  const bool adds = stages_.empty() || single_step_ || stages_.back().sent.has_value();
  PathCommands commands = adds ? commands_from(end_of(group)) : stages_.back().commands;
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
std::optional<GroupQueue::Step> GroupQueue::joined(const Tick& group) {
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

/// Plans so many commands at once, or starts the planning in the thread of the worker.
std::future<GroupQueue::Planned> GroupQueue::begun(std::size_t commands,
                                                   std::function<Planned()> work) {
  if (commands > most_at_once_) return worker_.ask(std::move(work));
  std::promise<Planned> now;
  now.set_value(work());
  return now.get_future();
}

void GroupQueue::plan(Way way, Task task, std::shared_ptr<const ExecutorGroup> group) {
  Attempt attempt{way, task.commands, {}, std::make_shared<std::atomic<bool>>(false), group};
  attempt.fast = task.fast.has_value();
  const std::size_t size = task.commands.size();
  const auto work = [task = std::move(task), group = std::move(group),
                     canceled = attempt.canceled] { return planned(task, *group, *canceled); };
  attempt.planned = begun(size, work);
  attempt_.emplace(std::move(attempt));
}

GroupQueue::Planned GroupQueue::planned(const Task& task, const ExecutorGroup& group,
                                        const std::atomic<bool>& canceled) {
  try {
    const std::vector<Limits> limits = space_of(group).limits;
    const auto program =
        task.fast ? fast_program(*task.fast, task.commands.position(), group)
                  : planned_program(task.commands.program(), {.axes = limits}, group, &canceled);
    Planned made;
    if (task.before != nullptr) {
      made.agreement = agreement(*task.before->plan, *program->plan, task.q);
      if (!made.agreement) return made;
    }
    made.program = std::make_shared<const GroupProgram>(with_peaks_of_limits(*program));
    return made;
  } catch (const PlanCanceled&) {
    return {};
  } catch (const InputError& error) {
    return {.reason = reason_of(error, group)};
  } catch (const std::bad_alloc&) {
    return {.reason = "the path does not fit into the memory of the executor"};
  }
}

/// The planning has ended, or goes on.
std::optional<GroupQueue::Step> GroupQueue::proceed(const Tick& group) {
  if (!attempt_->made) {
    if (attempt_->planned.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      return std::nullopt;
    attempt_->made = attempt_->planned.get();
  }
  Planned& made = *attempt_->made;
  if (const std::string reason = made.reason; !reason.empty())
    return finish(Cause::bad_table, reason);
  const Request& request = waiting_.front().request;
  if (attempt_->way == Way::after) {
    if (attempt_->adds_stage || stages_.empty())
      add_stage(group, single_step_ ? std::optional(Gate{.is_step = true}) : std::nullopt);
    Stage& stage = stages_.back();
    stage.commands = std::move(attempt_->commands);
    stage.program = std::move(made.program);
    stage.group = std::move(attempt_->group);
    return finish(Cause::none);
  }
  if (attempt_->way == Way::rest) {
    attempt_->program = made.program;
    const auto& jog = attempt_->commands.jog_end();
    return Play{.program = std::move(made.program),
                .request = request,
                .notice = jog ? text_of(*jog) : "",
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
