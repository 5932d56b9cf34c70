// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/axis_server.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "jounce/command/command_table.hpp"
#include "jounce/command/refusal_text.hpp"
#include "jounce/executor/recorder.hpp"
#include "jounce/executor/trace.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/six_digits.hpp"

#include "executor/src/cycle/commands.hpp"
#include "executor/src/cycle/events.hpp"
#include "executor/src/cycle/notices.hpp"

namespace jounce {
namespace {

using Kind = CommandKind;

constexpr std::int64_t no_group = 0;  // an axis that starts alone

bool differ(const std::string& axis, const std::string& table) {
  return !axis.empty() && axis != table;
}

}  // namespace

AxisServer::AxisServer(ExecutorOptions options, Receiver& receiver, MachineExchange& exchange,
                       std::size_t axis, Worker& worker,
                       std::function<double(std::size_t axis)> position_of)
    : options_(std::move(options)),
      axis_(axis),
      receiver_(receiver),
      exchange_(*exchange.axes[axis]),
      cycle_(exchange.cycle),
      commands_(exchange_),
      queues_(exchange_.rows, recorded_rows()),
      builder_(worker, options_.build_apart, options_.group) {
  if (options_.group) dynamics_.emplace(*options_.group);
  if (options_.group)
    group_queue_.emplace(
        *options_.group, worker, options_.build_apart,
        [axes = options_.group->of.axes, position_of = std::move(position_of)] {
          Point places{};
          for (std::size_t k = 0; k < axes.size(); ++k) places[k] = position_of(axes[k]);
          return places;
        },
        [this](std::uint64_t movement) {
          const auto kept = movements_.find(movement);
          return kept == movements_.end() ? nullptr : kept->second.made.program;
        });
  LogColumns more{.path = options_.group.has_value(),
                  .probes = options_.logs_probes,
                  .profile = options_.logs_profile,
                  .compensation = options_.axis.compensation.has_value()};
  if (options_.axis.registration) more.registration = options_.axis.registration->add_to;
  if (options_.log) log_.emplace(*options_.log, options_.units, more);
  if (options_.enable) commands_.send({command::Enable{}});
  commands_.flush();
}

void AxisServer::turn() {
  while (const auto event = receiver_.take_event())
    std::visit([&](const auto& e) { handle(e); }, *event);
  take_built();
  take_answers();
  take_ticks();  // later than the answers: the tick of every answer is then available
  turn_group();
  queues_.report(last_, receiver_);
  commands_.flush();
}

void AxisServer::retire() {
  retired_ = true;
  clear_commands();
  commands_.send({command::Stop{}});
  commands_.flush();
}

void AxisServer::close() {
  take_answers();
  take_ticks();
  if (log_) log_->close();
  if (log_) log_truncated_ = !log_->truncated().empty();
  log_.reset();
}

// ---- requests ----------------------------------------------------------------------------------

void AxisServer::handle(const TableReady& ready) {
  const bool over_time = ready.table.table->axis() == Domain::time;
  notify((over_time ? "table over time " : "cam ") + hex(ready.table.hash).substr(0, 16) + ", " +
         std::to_string(ready.table.table->size()) + " knots");
  if (options_.trace != nullptr) options_.trace->add(axis_, ready.table);
}

std::optional<Refusal> AxisServer::unfit(const ArmRequested& arm) const {
  if (retired_) return Refusal{.cause = Cause::leaving};
  const bool path = arm.mode == wire::ArmMode::path;
  if (path != options_.group.has_value())
    return Refusal{.cause = path ? Cause::not_a_group : Cause::single_axis};
  if (path && group_queue_->has_stages())
    return Refusal{.cause = moving() ? Cause::in_motion : Cause::awaits_acknowledge};
  const bool live = arm.mode == wire::ArmMode::follow_input;
  if (live && options_.follow.what == Follow::What::nothing)
    return Refusal{.cause = Cause::no_master_input};
  if (differ(options_.units.position, arm.slave.units.position) ||
      (live && differ(options_.units.x, arm.slave.units.x)))
    return Refusal{.cause = Cause::wrong_unit};
  return std::nullopt;
}

/// Rejects a table whose unit differs from that of the axis or of its master, with both units.
void AxisServer::refuse_units(const ArmRequested& arm) {
  const Units& table = arm.slave.units;
  std::string words = text({.cause = Cause::wrong_unit}, "");
  words.pop_back();  // the full stop: the units follow
  words += differ(options_.units.position, table.position)
               ? ": the table is in " + table.position + ", the axis in " + options_.units.position
               : ": the table is over " + table.x + ", the master of the axis moves in " +
                     options_.units.x;
  words += '.';
  receiver_.refuse(arm.session, arm.command, words, static_cast<std::int32_t>(Cause::wrong_unit));
  notify("rejected: " + words);
}

/// The position of the axis at the end of its present motion.
double AxisServer::next_rest() const {
  const auto playing = movements_.find(last_.job);
  return playing == movements_.end() ? last_.position
                                     : playing->second.made.last.value_or(last_.position);
}

void AxisServer::handle(const ArmRequested& arm) {
  if (reject_if_full(arm.session, arm.command)) return;
  if (const auto refusal = unfit(arm)) {
    if (refusal->cause == Cause::wrong_unit) return refuse_units(arm);
    return answer({arm.session, arm.command, Kind::arm}, refusal);
  }
  if (builder_.busy())
    builder_.wait(arm);  // replaces a waiting one: the receiver answers only the newest command
  else
    build(arm);
}

/// On a modulo axis, positions a turn apart are equal: a coupling, or a table over time, shifts by
/// whole turns if necessary. A table over time has no coupling of its own.
ArmRequested AxisServer::on_axis(ArmRequested arm) const {
  const double turn = options_.axis.modulo;
  if (arm.mode == wire::ArmMode::play && !arm.master) arm.coupling = {};
  if (turn != 0 && !arm.coupling.slave_period) arm.coupling.slave_period = turn;
  return arm;
}

void AxisServer::build(const ArmRequested& arm) {
  auto built = builder_.build(on_axis(arm), ++numbers_, options_.axis.period, next_rest(),
                              group_queue_ && group_queue_->single_step());
  if (built) this->arm(std::move(*built));
}

void AxisServer::take_built() {
  auto done = builder_.take();
  if (!done) return;
  if (done->built) arm(std::move(*done->built));
  if (done->next) build(*done->next);
}

void AxisServer::arm(MovementBuilder::Built built) {
  const ArmRequested& asked = built.arm;
  arm({asked.session, asked.command, Kind::arm}, std::move(built.made), asked.slave.hash,
      asked.session);
}

void AxisServer::arm(const Request& request, MadeMovement made, const Sha256& hash,
                     std::int64_t group) {
  if (!made.reason.empty())
    return receiver_.refuse(request.session, request.command, made.reason,
                            static_cast<std::int32_t>(Cause::bad_table));
  if (!made.movement) return answer(request, Refusal{.cause = Cause::bad_table});
  const bool resets = last_.state == State::error_stop && request.session != fault_session_;
  const bool stands = last_.state == State::standstill || resets;
  const bool adopts = options_.adopt_start && made.first.has_value() && stands && !moving();
  if (resets || adopts) {
    // Only a movement that will be armed may clear a fault, or change the coordinate.
    if (options_.axis.require_home && !last_.homed && made.movement->absolute())
      return answer(request, Refusal{.cause = Cause::not_homed});
    const MotionState at{.position = adopts ? *made.first : last_.position};
    if (const auto refusal = made.movement->admit(options_.axis, at))
      return answer(request, refusal);
  }
  if (resets) {
    commands_.send({command::Reset{}});
    if (last_.job != 0)
      commands_.send({command::Stop{}});  // the remainder of an underrun is not continued
  }
  if (adopts) commands_.send({command::SetPosition{*made.first}});
  record(made);
  commands_.send({command::Arm{made.movement.get(), group}}, request);
  armed_ = made.movement->id();
  movements_[armed_] = {std::move(made), hash};
}

/// Called before the arm is sent to the axis.
void AxisServer::record(const MadeMovement& made) {
  if (options_.recorder == nullptr) return;
  if (made.program)
    for (const RecordedPathSwitches& part :
         recorded_switches(*made.program, axis_, made.movement->id()))
      options_.recorder->note(part);
  if (made.program)
    for (const RecordedProgram& part : recorded(*made.program, axis_, made.movement->id()))
      options_.recorder->note(part);
  if (!made.source) return;
  RecordedJob job = made.source->job;
  job.axis = axis_;
  options_.recorder->job(job, made.source->time, made.source->cam ? &*made.source->cam : nullptr);
}

void AxisServer::handle(const StartRequested& start) {
  if (reject_if_full(start.session, start.command)) return;
  if (const auto armed = movements_.find(armed_); dynamics_ && armed != movements_.end()) {
    dynamics_->begin();
    set_rate(group_rate(armed->second, 0));
  }
  motion_session_ = start.session;
  start_.request(start.session, start.command, armed_);
  commands_.send({command::Start{start.when, start.tick, start.position, start.session}},
                 {start.session, start.command, Kind::start});
}

void AxisServer::handle(const StopRequested& stop) {
  clear_commands();
  Command command{command::Stop{}};
  if (stop.mode == wire::StopMode::abort) command.what = command::Abort{};
  commands_.send(command, {stop.session, stop.command, command.kind()});
}

void AxisServer::handle(const SessionEnded& ended) {
  const bool silent = ended.why == SessionEnded::Why::silent;
  if (silent) notify("the session timed out: its program sent no heartbeat");
  builder_.cancel();
  if (group_queue_) group_queue_->cancel();
  queues_.close();
  // The motion may belong to a previous owner, who released it while running.
  const bool its_motion = ended.session == motion_session_;
  // Applies also after later commands of the session. An operator's stop is already in transit to the
  // axis, and requires an answer.
  if (ended.session == held_session_ && ended.why != SessionEnded::Why::operator_stop) {
    clear_commands();
    if (group_queue_) group_queue_->release();
    return commands_.send({command::Release{}});
  }
  const bool stops = silent && its_motion && options_.stop_when_silent;
  // An armed motion no longer begins; a move that waits for the previous one, or for its tick,
  // does.
  const bool armed = last_.armed != 0 || busy();
  if (!stops && !armed) return;
  Command command{command::Disarm{}};
  if (stops) command.what = command::Stop{};
  if (stops && group_queue_) group_queue_->clear();  // also the commands after an M word
  if (commands_.last() != command.kind()) commands_.send(command);
}

void AxisServer::handle(const CommandRequested& requested) {
  const CommandKind kind = kind_of(requested.what);
  if (kind == Kind::disable) clear_commands();  // ends more than a stop
  if (kind == Kind::halt && group_queue_ && group_queue_->has_stages()) group_queue_->clear();
  if (reject_if_full(requested.session, requested.command)) return;
  const Request request{requested.session, requested.command, kind};
  if (retired_) return answer(request, Refusal{.cause = Cause::leaving});
  std::visit([&](const auto& what) { obey(what, requested, request); }, requested.what);
}

/// A command that the axis executes as it is, or a command for the queue of a group.
template <class What>
void AxisServer::obey(const What& what, const CommandRequested& requested, const Request& request) {
  if constexpr (is_path_command<What>) {
    if (!group_queue_) return answer(request, Refusal{.cause = Cause::not_a_group});
    if (requested.at >= 0)
      return decline(requested, Cause::no_start_tick,
                     "a command of a group begins after those before it: leave out --at");
    if (group_queue_->full()) return refuse_crowd(requested.session, requested.command);
    motion_session_ = requested.session;
    if (holds_to_run(requested.what)) held_session_ = requested.session;
    return group_queue_->take(what, request);
  } else {
    if (info(request.kind).moves) motion_session_ = requested.session;
    if (holds_to_run(requested.what)) held_session_ = requested.session;
    commands_.send({.what = what, .at = requested.at}, request);
  }
}

void AxisServer::obey(const command::GearIn& /*gear*/, const CommandRequested& requested,
                      const Request& request) {
  couple(requested, request);
}

void AxisServer::obey(const command::GearInPos& /*gear*/, const CommandRequested& requested,
                      const Request& request) {
  couple(requested, request);
}

void AxisServer::obey(const command::CombineAxes& /*gear*/, const CommandRequested& requested,
                      const Request& request) {
  if (options_.follow.what != Follow::What::nothing &&
      options_.second.what == Follow::What::nothing)
    return decline(requested, Cause::no_master_input,
                   "the axis follows one master only: add second = { axis = \"NAME\" } to [follow] "
                   "in its spec");
  couple(requested, request);
}

void AxisServer::couple(const CommandRequested& requested, const Request& request) {
  if (options_.group) return answer(request, Refusal{.cause = Cause::single_axis});
  motion_session_ = requested.session;
  if (options_.follow.what == Follow::What::nothing)
    return answer(request, Refusal{.cause = Cause::no_master_input});
  try {
    const std::uint64_t id = ++numbers_;
    MadeMovement gear{.movement = gear_of(requested.what, id, options_.axis, last_.position)};
    if (options_.recorder != nullptr)
      options_.recorder->note(RecordedGear{axis_, id, requested.what, last_.position});
    couple(std::move(gear), requested.at, request);
  } catch (const InputError& error) {
    decline(requested, Cause::no_value, error.what());
  }
}

void AxisServer::couple(MadeMovement made, std::int64_t at, const Request& request) {
  record(made);
  commands_.send({command::Couple{made.movement.get(), at}}, request);
  const std::uint64_t id = made.movement->id();
  movements_[id] = {std::move(made), {}};
}

/// Starts the plan of cuts of the axis's own cutter.
void AxisServer::start_cuts(const CommandRequested& requested, const Request& request) {
  motion_session_ = requested.session;
  if (options_.follow.what == Follow::What::nothing)
    return answer(request, Refusal{.cause = Cause::no_master_input});
  if (moving()) return answer(request, Refusal{.cause = Cause::in_motion});
  couple(movement_of(*options_.cutter, ++numbers_, options_.axis), requested.at, request);
}

/// Arms and starts the axis's own table. It is accepted when it is armed: nothing can prevent the
/// start then.
void AxisServer::obey(const command::StartTable& /*it*/, const CommandRequested& requested,
                      const Request& request) {
  if (options_.group) return play_program(requested, request);
  if (options_.cutter) return start_cuts(requested, request);
  if (!options_.table)
    return decline(
        requested, Cause::nothing_to_start,
        "the spec of the axis has no table and no cutter of its own to start: send a table with "
        "`jounce stream`, or add cutter = \"FILE\" to its [axis]");
  const Request armed{requested.session, requested.command, Kind::arm};
  if (moving()) return answer(armed, Refusal{.cause = Cause::in_motion});
  const ArmRequested own{.session = requested.session,
                         .command = requested.command,
                         .mode = wire::ArmMode::play,
                         .slave = *options_.table,
                         .master = {}};
  motion_session_ = requested.session;
  commands_.send({command::Disarm{}});  // if the arm fails, the start then starts nothing else
  arm(armed, movement_of(own, ++numbers_, options_.axis.period, last_.position),
      options_.table->hash, no_group);
  commands_.send({command::Start{.tick = requested.at}});
}

/// Arms and starts the program of a group. The start decides whether its axes stand where it begins.
void AxisServer::play_program(const CommandRequested& requested, const Request& request) {
  const auto& sent = options_.group->sent;
  if (!sent)
    return decline(requested, Cause::nothing_to_start,
                   "the group has no program of its own: send a path with `jounce stream`, or add "
                   "program to its [[group]]");
  if (moving()) return answer(request, Refusal{.cause = Cause::in_motion});
  if (group_queue_->has_stages())
    return answer(request, Refusal{.cause = Cause::awaits_acknowledge});
  motion_session_ = requested.session;
  play(movement_of(sent, ++numbers_, *options_.group, group_queue_->single_step()), request,
       requested.at);
}

/// Arms and starts the newest movement of a group.
void AxisServer::play(MadeMovement path, const Request& request, std::int64_t at) {
  record(path);
  const Kept& kept = movements_[numbers_] = {std::move(path), {}};
  dynamics_->begin();
  set_rate(group_rate(kept, 0));
  commands_.send({command::Disarm{}});
  commands_.send({command::Arm{kept.made.movement.get()}});
  commands_.send({command::Start{.tick = at}}, request);
}

// ---- single commands of a group ----------------------------------------------------------------

void AxisServer::turn_group() {
  if (!group_queue_) return;
  if (last_.state == State::disabled && dynamics_->limits()) {
    dynamics_->clear();
    limit_group(true);
  }
  if (movements_.contains(last_.job) && commands_.idle()) set_rate(present_rate());
  while (const auto step = group_queue_->next(last_))
    std::visit([&](const auto& one) { take_step(one); }, *step);
}

void AxisServer::take_step(const GroupQueue::Halt& /*halt*/) {
  commands_.send({command::Halt{}});
}

void AxisServer::take_step(const GroupQueue::Play& step) {
  play(movement_of(step.program, ++numbers_), step.request, -1);
  group_movement_ = numbers_;
  if (!step.notice.empty()) notify(step.notice);
}

void AxisServer::take_step(const GroupQueue::Extend& step) {
  MadeMovement path = movement_of(step.program, ++numbers_);
  record(path);
  commands_.send({command::Extend{path.movement.get(), step.position, step.shift, step.until}},
                 {step.request.session, step.request.command, Kind::extend});
  group_movement_ = path.movement->id();
  movements_[group_movement_] = {std::move(path), {}, step.position, step.shift};
}

void AxisServer::take_step(const GroupQueue::SetLimits& step) {
  set_limits(step.limits, step.request);
}

void AxisServer::take_step(const GroupQueue::Announce& step) {
  if (step.waits)
    notify("M" + std::to_string(step.m_word) + " waits for `jounce order " +
           options_.receiver.executor + " acknowledge`");
  if (step.timeout > 0)
    notify("M" + std::to_string(step.m_word) + " was not acknowledged within " +
           six_digits(step.timeout) + " s: " + std::to_string(step.dropped) +
           (step.dropped == 1 ? " command that follows it was dropped"
                              : " commands that follow it were dropped"));
  events_.push_back({.count = ++event_count_,
                     .kind = wire::EventKind::m_word,
                     .number = static_cast<std::uint32_t>(step.m_word),
                     .on = step.waits,
                     .tick = last_.tick,
                     .position = last_.position});
}

void AxisServer::take_step(const GroupQueue::Note& step) {
  notify(step.text);
}

void AxisServer::obey(const command::GroupAcknowledge& what, const CommandRequested& requested,
                      const Request& request) {
  if (!group_queue_) return answer(request, Refusal{.cause = Cause::not_a_group});
  if (reject_at_tick(requested)) return;
  const auto m_word = group_queue_->m_word();
  const Cause no = group_queue_->acknowledge(what.m_word);
  if (no == Cause::none && m_word) take_step(GroupQueue::Announce{*m_word, false});
  answer(request, no == Cause::none ? std::nullopt : std::optional(Refusal{.cause = no}));
}

void AxisServer::obey(const command::GroupSingleStep& what, const CommandRequested& requested,
                      const Request& request) {
  if (!group_queue_) return answer(request, Refusal{.cause = Cause::not_a_group});
  if (reject_at_tick(requested)) return;
  group_queue_->single_step(what.on);
  answer(request, std::nullopt);
}

void AxisServer::set_limits(const command::GroupSetLimits& what, const Request& request) {
  try {
    dynamics_->set(what);
    limit_group(what.axis != 0);
    if (moving()) set_rate(present_rate());
    answer(request, std::nullopt);
  } catch (const InputError& error) {
    receiver_.refuse(request.session, request.command,
                     error.key() + " " + error.value() + " " + error.rule(),
                     static_cast<std::int32_t>(Cause::no_value));
  }
}

/// Passes the limits to the commands of the group that follow.
void AxisServer::limit_group(bool from_rest) {
  group_queue_->limit(dynamics_->limited(), dynamics_->path(), from_rest);
}

/// The override factor of the program that the group plays.
double AxisServer::present_rate() const {
  const auto playing = movements_.find(last_.job);
  return playing == movements_.end() ? dynamics_->rate()
                                     : group_rate(playing->second, last_.position);
}

/// The override factor of a program at a position: below the commanded one if the limits require it.
double AxisServer::group_rate(const Kept& kept, double position) const {
  const GroupProgram* const program = kept.made.program.get();
  if (program == nullptr) return dynamics_->rate();
  return std::min(dynamics_->rate(part_at(*program, position - kept.origin)),
                  group_queue_->highest_rate());
}

/// Sends an override factor to the group if it differs from the present one, or if a request waits.
void AxisServer::set_rate(double rate, const std::optional<Request>& request, std::int64_t at) {
  const Command command{.what = command::Override{rate}, .at = at};
  if (request)
    commands_.send(command, *request);
  else if (rate != rate_)
    commands_.send(command);
  rate_ = rate;
}

void AxisServer::obey(const command::Override& what, const CommandRequested& requested,
                      const Request& request) {
  if (!dynamics_) return commands_.send({.what = what, .at = requested.at}, request);
  dynamics_->set(what);
  set_rate(present_rate(), request, requested.at);
}

void AxisServer::obey(const command::GroupSetOverride& what, const CommandRequested& requested,
                      const Request& request) {
  if (!dynamics_) return answer(request, Refusal{.cause = Cause::not_a_group});
  dynamics_->set(what);
  limit_group(false);
  set_rate(present_rate(), request, requested.at);
}

/// Queued limits take their place in the order of the commands.
void AxisServer::obey(const command::GroupSetLimits& what, const CommandRequested& requested,
                      const Request& request) {
  if (!dynamics_) return answer(request, Refusal{.cause = Cause::not_a_group});
  if (requested.at >= 0)
    return decline(requested, Cause::no_start_tick,
                   "further limits of a group apply at once: leave out --at");
  if (!what.queued) {
    if (const Cause no = permitted(last_.state, request.kind); no != Cause::none)
      return answer(request, Refusal{.cause = no});
    return set_limits(what, request);
  }
  if (group_queue_->full()) return refuse_crowd(requested.session, requested.command);
  group_queue_->take(what, request);
}

void AxisServer::take_step(const GroupQueue::Reply& reply) {
  if (reply.reason.empty())
    return answer(reply.request, reply.cause == Cause::none
                                     ? std::nullopt
                                     : std::optional(Refusal{.cause = reply.cause}));
  receiver_.refuse(reply.request.session, reply.request.command, reply.reason,
                   static_cast<std::int32_t>(reply.cause));
}

/// Returns the function that records a queue's rows; empty: no record.
Queues::Record AxisServer::recorded_rows() const {
  if (options_.recorder == nullptr) return {};
  return [recorder = options_.recorder, axis = axis_](const HandedOver& what) {
    recorder->note(RecordedRows{axis, what});
  };
}

void AxisServer::obey(const command::QueueSwitch& what, const CommandRequested& requested,
                      const Request& request) {
  if (!reject_at_tick(requested)) answer_queue(request, queues_.queue_switch(what.queue));
}

void AxisServer::obey(const command::QueueClear& what, const CommandRequested& requested,
                      const Request& request) {
  if (!reject_at_tick(requested)) answer_queue(request, queues_.clear(what.queue, what.bank));
}

void AxisServer::obey(const command::QueueEnd& what, const CommandRequested& requested,
                      const Request& request) {
  if (reject_at_tick(requested)) return;
  if (!queues_.end(what.queue))
    return decline(requested, Cause::not_on_path,
                   "the end of this queue cannot be set: the queue is not dynamic, or none of its "
                   "rows ends at rest");
  answer_queue(request, true);
}

/// Rejects a command about a queue, or about the commands of a group, for a later tick.
bool AxisServer::reject_at_tick(const CommandRequested& requested) {
  if (requested.at >= 0)
    decline(requested, Cause::no_start_tick,
            "a command for a queue takes effect at once: leave out --at");
  return requested.at >= 0;
}

void AxisServer::answer_queue(const Request& request, bool done) {
  answer(request, done ? std::nullopt : std::optional(Refusal{.cause = Cause::in_motion}));
}

/// Rejects a command if more wait than any streamer needs: the axis takes one command a tick.
bool AxisServer::reject_if_full(std::int64_t session, std::int32_t command) {
  if (commands_.full()) refuse_crowd(session, command);
  return commands_.full();
}

void AxisServer::refuse_crowd(std::int64_t session, std::int32_t command) {
  receiver_.refuse(session, command, "too many commands are waiting: repeat this one later",
                   static_cast<std::int32_t>(Cause::buffer_full));
}

/// Rejects a command for a reason that is more precise than the text of its cause.
void AxisServer::decline(const CommandRequested& requested, Cause cause,
                         const std::string& reason) {
  receiver_.refuse(requested.session, requested.command, reason, static_cast<std::int32_t>(cause));
}

void AxisServer::handle(const QueueArmRequested& arm) {
  if (reject_if_full(arm.session, arm.command)) return;
  const Request request{arm.session, arm.command, Kind::arm};
  if (retired_) return answer(request, Refusal{.cause = Cause::leaving});
  const auto movement = queues_.movement(arm.queue);
  if (!movement) return answer(request, Refusal{.cause = Cause::no_movement});
  if (movements_.contains(movement->id()))
    return answer(request, Refusal{.cause = Cause::in_motion});
  queues_.begin_with(arm.queue, arm.bank);
  this->arm(request, {.movement = movement, .first = queues_.origin(arm.queue)}, {}, arm.session);
}

void AxisServer::handle(const QueueOpened& opened) {
  const std::uint64_t id = ++numbers_;
  const bool made = queues_.open(opened, id, options_.axis, receiver_);
  if (made && options_.recorder != nullptr)
    options_.recorder->note(RecordedQueue{axis_, id, opened.queue});
}

void AxisServer::handle(const RowsArrived& arrived) {
  queues_.take(arrived, receiver_);
}

void AxisServer::clear_commands() {
  builder_.cancel();
  if (group_queue_) group_queue_->clear();
  if (commands_.waits(Kind::override_)) rate_ = NAN;  // it is sent again
  const bool dropped = commands_.waits(Kind::start) || commands_.waits(Kind::extend);
  for (const std::uint64_t movement : commands_.clear()) movements_.erase(movement);
  if (group_queue_ && dropped) group_queue_->answered(false, group_movement_);
}

// ---- the axis ----------------------------------------------------------------------------------

void AxisServer::take_answers() {
  while (const auto reply = commands_.take_answer()) {
    if (reply->request && !answers_group(*reply)) answer(*reply->request, reply->refused);
    for (const Movement* movement : reply->handed_back) {
      if (movement == nullptr) continue;
      queues_.handed_back(movement->id());
      movements_.erase(movement->id());
    }
  }
}

/// Passes the outcome of a step to the queue of the group. Returns true if the queue decides later
/// how to answer the request.
bool AxisServer::answers_group(const CommandQueue::Reply& reply) {
  const Kind kind = reply.request->kind;
  if (!group_queue_ || !(kind == Kind::extend || is_path_kind(kind))) return false;
  group_queue_->answered(!reply.refused, group_movement_);
  return kind == Kind::extend && reply.refused;
}

void AxisServer::answer(const Request& request, const std::optional<Refusal>& refused) {
  if (request.kind == Kind::start) start_.answer(request.session, request.command, refused);
  // A stop that an axis in a fault rejects still counts as accepted: the axis does not move.
  if (!refused || request.kind == Kind::stop)
    return receiver_.accept(request.session, request.command);
  const std::string reason = refusal_text(*refused, last_, options_);
  receiver_.refuse(request.session, request.command, reason,
                   static_cast<std::int32_t>(refused->cause));
  notify("rejected: " + reason);
}

void AxisServer::take_ticks() {
  for (Tick tick; exchange_.ticks.pop(tick);) {
    if (log_) write(tick);
    if (options_.trace != nullptr) options_.trace->add(axis_, trace_tick(tick));
    const bool with_group = !options_.groups.empty() && tick.finished > last_.finished &&
                            last_.state == State::synchronized_motion;
    if (with_group) ++ended_with_group_;
    Tick reported = last_;
    if (with_group) reported.finished = tick.finished;
    for (const std::string& notice :
         notices_of(reported, tick, options_.units.position, options_.axis, group_names(options_)))
      notify(notice);
    if (tick.fault != last_.fault && tick.fault != Cause::none)
      fault_session_ = receiver_.session();
    for (auto& event : events_of(last_, tick, {options_.switches.of, options_.compare.of},
                                 options_.axis.period, event_count_)) {
      event_count_ = event.count;
      events_.push_back(event);
    }
    start_.follow(last_, tick);
    if (group_queue_) follow_program(tick);
    last_ = tick;
  }
}

/// A tick of a group: the M words that it passes, and the begin of a motion. This may be the first
/// motion of a program that was sent as a whole.
void AxisServer::follow_program(const Tick& tick) {
  const bool extended = last_.job != 0 && tick.job != 0 && tick.finished == last_.finished;
  if (tick.job != last_.job && tick.job == 0)
    pass_m_words(tick);
  else if (tick.job != last_.job) {
    const auto kept = movements_.find(tick.job);
    const auto [made, hash, origin, shift] = kept == movements_.end() ? Kept{} : kept->second;
    m_words_.begin(made.program, extended ? last_.path_time - shift : 0);
    if (made.sent) group_queue_->begins(tick.job, made.program, made.sent, made.sent_last, tick);
  }
  if (tick.job != 0) pass_m_words(tick);
}

void AxisServer::pass_m_words(const Tick& tick) {
  for (wire::Event& event : m_words_.passed(last_, tick, options_.axis.period)) {
    event.count = ++event_count_;
    events_.push_back(event);
  }
}

void AxisServer::write(const Tick& tick) {
  log_->add(tick);
  if (log_truncated_ || log_->truncated().empty()) return;
  log_truncated_ = true;
  notify("the log ends at tick " + std::to_string(tick.tick) + " (" + log_->truncated() +
         "); the axis goes on");
}

wire::Status AxisServer::status() const {
  auto [waiting, capacity] = queues_.fill(last_.job != 0 ? last_.job : last_.armed);
  if (const std::size_t commands = group_queue_ ? group_queue_->taken(last_) : 0; commands > 0) {
    waiting = static_cast<std::uint32_t>(commands);
    capacity = GroupQueue::most_commands;
  }
  wire::Status status{.state = last_.state,
                      .tick = last_.tick,
                      .cycle_ns = options_.axis.period,
                      .master_position = NAN,
                      .slave_position = last_.position,
                      .slave_velocity = last_.velocity,
                      .last_error = static_cast<std::int32_t>(last_.fault),
                      .late_ticks = cycle_.late.load(std::memory_order_relaxed),
                      .finished = static_cast<std::int64_t>(last_.finished),
                      .stopped = static_cast<std::int64_t>(last_.stopped),
                      .actual_position = last_.actual_position,
                      .following_error = last_.following_error,
                      .torque = last_.torque,
                      .override_ = last_.override_,
                      .reason = static_cast<std::int32_t>(reason()),
                      .queue_rows = waiting,
                      .queue_capacity = capacity,
                      .outputs = last_.switches.outputs,
                      .lateness = cycle_.lateness.counts(),
                      .computing = cycle_.computing.counts(),
                      .units = options_.units,
                      .held = last_.held,
                      .homed = last_.homed,
                      .unwritten = unwritten(),
                      .gear = gear(),
                      .gear_master = options_.leads,
                      .ratio = last_.ratio};
  if (last_.compensated) status.correction = last_.correction[0];
  if (last_.job != 0 || last_.progress != Progress::done)
    status.progress = jounce::on_wire(last_.progress);
  if (last_.armed != 0) status.next = last_.waiting ? wire::Next::waiting : wire::Next::armed;
  start_.report(status, receiver_.session(), options_.units.position);
  const auto kept = movements_.find(last_.job != 0 ? last_.job : last_.armed);
  if (kept != movements_.end()) {
    std::copy_n(kept->second.hash.begin(), status.table.size(), status.table.begin());
    if (kept->second.made.movement->synchronized()) status.master_position = last_.master;
  }
  return status;
}

/// The reason why the last motion ended.
Cause AxisServer::reason() const {
  const Cause rests = group_queue_ ? group_queue_->rests_because(last_) : Cause::none;
  return last_.reason == Cause::none ? rests : last_.reason;
}

/// State of the pair of the axis and its live master.
wire::GearState AxisServer::gear() const {
  if (options_.follow.what == Follow::What::nothing) return wire::GearState::none;
  const bool follows = last_.state == State::synchronized_motion && last_.job != 0;
  if (!follows) return wire::GearState::disengaged;
  if (last_.ratio == 0) return wire::GearState::in_cam;
  return last_.progress == Progress::running ? wire::GearState::in_gear : wire::GearState::engaging;
}

std::optional<wire::GroupStatus> AxisServer::group_status() {
  if (!group_queue_) return std::nullopt;
  const auto playing = movements_.find(last_.job);
  const auto program = playing == movements_.end() ? nullptr : playing->second.made.program;
  wire::GroupStatus status =
      group_report_.status(*options_.group, last_, group_queue_->places(), program, *group_queue_);
  if (options_.trace != nullptr && program && program != traced_) {
    options_.trace->set(axis_, *trace_path(*program, *options_.group, playing->second.origin));
  }
  if (program) traced_ = program;
  return status;
}

std::uint8_t AxisServer::unwritten() const {
  const unsigned recorder = options_.recorder != nullptr ? options_.recorder->unwritten() : 0U;
  return static_cast<std::uint8_t>(recorder |
                                   (log_truncated_ ? unsigned{wire::log_unwritten} : 0U));
}

void AxisServer::notify(const std::string& notice) const {
  if (options_.notify) options_.notify(notice);
}

}  // namespace jounce
