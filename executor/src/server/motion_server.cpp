// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/motion_server.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include "jounce/axis/detail/path_clock.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/command/detail/refusal_text.hpp"
#include "jounce/executor/detail/recorder.hpp"
#include "jounce/executor/detail/trace.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "executor/src/server/events.hpp"
#include "executor/src/server/notices.hpp"

namespace jounce {
namespace {

using Kind = CommandKind;

/// The highest override factor at which a motion keeps the limits: of a table, or of a path.
double highest_override(const MadeMovement& made, const AxisConfig& config) {
  const bool whole = made.program || (made.source && !made.source->job.live);
  if (!made.movement || !whole) return 2;
  return std::min(made.movement->highest_rate(), highest_rate(made.movement->peaks(), config));
}

/// The factor of the speed that a command requests.
double override_of(const CommandRequested& requested) {
  if (const auto* const axis = std::get_if<command::Override>(&requested.what)) return axis->factor;
  return std::get<command::GroupSetOverride>(requested.what).velocity;
}

/// A remark on an accepted override. `most`: highest factor for the present motion.
std::string note_of_override(double factor, double most, const Tick& now) {
  if (now.state == State::error_stop && now.job != 0)
    return "it takes effect when the motion continues, after reset and resume";
  if (!(factor > most * (1 + profiles_detail::rounded_sum))) return "";
  return "the limits permit at most " + six_digits(100 * most) +
         " % of the speed of the present motion";
}

/// A remark on an accepted command, if its effect is not the usual one; "" otherwise. `most`: see
/// note_of_override().
std::string note_of(const CommandRequested& requested, const Tick& now, bool is_group,
                    double most) {
  const Kind kind = kind_of(requested.what);
  if (kind == Kind::override_ || kind == Kind::group_set_override)
    return note_of_override(override_of(requested), most, now);
  if (is_group && kind == Kind::disable && now.job != 0 && now.state != State::error_stop)
    return "the motion that stood still is dropped";
  const bool is_move = kind == Kind::move_absolute || kind == Kind::move_relative ||
                       kind == Kind::move_additive || kind == Kind::move_velocity ||
                       kind == Kind::move_repetitive;
  const bool begins = kind == Kind::resume || is_move || (is_group && info(kind).moves);
  if (begins && now.override_ == 0)
    return "the override is 0 %, so nothing moves until another override";
  if (is_group || requested.at >= 0 || now.later <= now.tick || !info(kind).moves) return "";
  return "it does not wait for the command of tick " + std::to_string(now.later) +
         ", which takes effect in its tick and may replace this motion";
}

bool differ(const std::string& axis, const std::string& table) {
  return !axis.empty() && axis != table;
}

}  // namespace

MotionServer::MotionServer(ExecutorOptions options, Receiver& receiver, MachineExchange& exchange,
                           std::size_t axis, Worker& worker)
    : options_(std::move(options)),
      axis_(axis),
      receiver_(receiver),
      commands_(*exchange.axes[axis]),
      exchange_(*exchange.axes[axis]),
      cycle_(exchange.cycle),
      queues_(exchange_.rows, recorded_rows()),
      builder_(worker, options_.build_apart, options_.group) {
  LogColumns more{.master = !options_.group,
                  .path = options_.group.has_value(),
                  .probes = options_.logs_probes,
                  .profile = options_.logs_profile,
                  .compensation = options_.axis.compensation.has_value()};
  if (options_.axis.registration) more.registration = options_.axis.registration->add_to;
  if (options_.log) log_.emplace(*options_.log, options_.units, more);
  if (options_.enable) commands_.send({command::Enable{}});
  commands_.flush();
}

void MotionServer::turn() {
  while (const auto event = receiver_.take_event())
    std::visit([&](const auto& e) { handle(e); }, *event);
  take_built();
  take_answers();
  take_ticks();  // later than the answers: the tick of every answer is then available
  take_steps();
  queues_.report(last_, receiver_);
  commands_.flush();
}

void MotionServer::retire() {
  retired_ = true;
  clear_commands();
  commands_.send({command::Stop{}});
  commands_.flush();
}

void MotionServer::close() {
  take_answers();
  take_ticks();
  if (log_) log_->close();
  if (log_) log_truncated_ = !log_->truncated().empty();
  log_.reset();
}

// ---- requests ----------------------------------------------------------------------------------

void MotionServer::handle(const TableReady& ready) {
  const bool over_time = ready.table.table->axis() == Domain::time;
  notify((over_time ? "table over time " : "cam ") + hex(ready.table.hash).substr(0, 16) + ", " +
         std::to_string(ready.table.table->size()) + " knots");
  if (options_.trace != nullptr) options_.trace->add(axis_, ready.table);
}

/// The reason to reject an arm; nullopt: none.
std::optional<Refusal> MotionServer::refusal_of(const ArmRequested& arm) const {
  if (retired_) return Refusal{.cause = Cause::leaving};
  if (const auto no = unfit(arm)) return no;
  const bool live = arm.mode == wire::ArmMode::follow_input;
  if (differ(options_.units.position, arm.slave.units.position) ||
      (live && differ(options_.units.x, arm.slave.units.x)))
    return Refusal{.cause = Cause::wrong_unit};
  return std::nullopt;
}

/// Rejects a table whose unit differs from that of the axis or of its master, with both units.
void MotionServer::refuse_units(const ArmRequested& arm) {
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
double MotionServer::next_rest() const {
  const auto playing = movements_.find(last_.job);
  return playing == movements_.end() ? last_.position
                                     : playing->second.made.last.value_or(last_.position);
}

void MotionServer::handle(const ArmRequested& arm) {
  if (reject_if_full(arm.session, arm.command)) return;
  if (const auto refusal = refusal_of(arm)) {
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
ArmRequested MotionServer::on_axis(ArmRequested arm) const {
  const double turn = options_.axis.modulo;
  if (arm.mode == wire::ArmMode::play && !arm.master) arm.coupling = {};
  if (turn != 0 && !arm.coupling.slave_period) arm.coupling.slave_period = turn;
  return arm;
}

void MotionServer::build(const ArmRequested& arm) {
  auto built =
      builder_.build(on_axis(arm), ++numbers_, options_.axis.period, next_rest(), single_step());
  if (built) this->arm(std::move(*built));
}

void MotionServer::take_built() {
  auto done = builder_.take();
  if (!done) return;
  if (done->built) arm(std::move(*done->built));
  if (done->next) build(*done->next);
}

void MotionServer::arm(MovementBuilder::Built built) {
  const ArmRequested& asked = built.arm;
  arm({asked.session, asked.command, Kind::arm}, std::move(built.made), asked.slave.hash,
      asked.session);
}

void MotionServer::arm(const Request& request, MadeMovement made, const Sha256& hash,
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
void MotionServer::record(const MadeMovement& made) {
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

void MotionServer::handle(const StartRequested& start) {
  if (reject_if_full(start.session, start.command)) return;
  const auto armed = movements_.find(armed_);
  if (armed != movements_.end()) begins(armed->second);
  motion_session_ = start.session;
  start_.request(start, armed_);
  const bool at_live_master = start.when == StartAt::master_position && armed_is_live();
  commands_.send({command::Start{start.when, start.tick, start.position, start.session}},
                 {start.session, start.command, Kind::start,
                  at_live_master ? place_of_master(last_, start.position, options_.units.x) : ""});
}

void MotionServer::handle(const StopRequested& stop) {
  clear_commands();
  Command command{command::Stop{}};
  if (stop.mode == wire::StopMode::abort) command.what = command::Abort{};
  commands_.send(command, {stop.session, stop.command, command.kind()});
}

void MotionServer::handle(const SessionEnded& ended) {
  const bool silent = ended.why == SessionEnded::Why::silent;
  if (silent) notify("the session timed out: its program sent no heartbeat");
  builder_.cancel();
  cancel();
  queues_.close();
  // The motion may belong to a previous owner, who released it while running.
  const bool its_motion = ended.session == motion_session_;
  // Applies also after later commands of the session. An operator's stop is already in transit to the
  // axis, and requires an answer.
  if (ended.session == held_session_ && ended.why != SessionEnded::Why::operator_stop) {
    clear_commands();
    release();
    if (silent && moving()) receiver_.stopped_with(ended.session);
    return commands_.send({command::Release{}});
  }
  const bool stops = silent && its_motion && options_.stop_when_silent;
  // An armed motion no longer begins; a move that waits for the previous one, or for its tick,
  // does.
  const bool armed = last_.armed != 0 || busy();
  if (!stops && !armed) return;
  Command command{command::Disarm{}};
  if (stops) command.what = command::Stop{};
  if (stops) drop();  // also the commands after an M word
  if (stops && moving()) receiver_.stopped_with(ended.session);
  if (commands_.last() != command.kind()) commands_.send(command);
}

void MotionServer::handle(const CommandRequested& requested) {
  const CommandKind kind = kind_of(requested.what);
  if (kind == Kind::disable) clear_commands();  // ends more than a stop
  if (kind == Kind::halt) halts();
  if (reject_if_full(requested.session, requested.command)) return;
  const auto playing = movements_.find(last_.job);
  const double most =
      playing == movements_.end() ? 2 : highest_override(playing->second.made, options_.axis);
  const Request request{requested.session, requested.command, kind,
                        note_of(requested, last_, options_.group.has_value(), most)};
  if (retired_) return answer(request, Refusal{.cause = Cause::leaving});
  obey(requested, request);
}

bool MotionServer::pass_on(const CommandRequested& requested, const Request& request) {
  return std::visit([&](const auto& what) { return pass_on(what, requested, request); },
                    requested.what);
}

/// A command that the axis executes as it is.
template <class What>
bool MotionServer::pass_on(const What& what, const CommandRequested& requested,
                           const Request& request) {
  if constexpr (std::is_constructible_v<AxisCommand, const What&>) {
    if (info(request.kind).moves) motion_session_ = requested.session;
    if (holds_to_run(requested.what)) held_session_ = requested.session;
    commands_.send({.what = what, .at = requested.at}, request);
    return true;
  }
  return false;
}

/// Returns the function that records a queue's rows; empty: no record.
Queues::Record MotionServer::recorded_rows() const {
  if (options_.recorder == nullptr) return {};
  return [recorder = options_.recorder, axis = axis_](const HandedOver& what) {
    recorder->note(RecordedRows{axis, what});
  };
}

bool MotionServer::pass_on(const command::QueueSwitch& what, const CommandRequested& requested,
                           const Request& request) {
  if (!reject_at_tick(requested)) answer_queue(request, queues_.queue_switch(what.queue));
  return true;
}

bool MotionServer::pass_on(const command::QueueClear& what, const CommandRequested& requested,
                           const Request& request) {
  if (!reject_at_tick(requested)) answer_queue(request, queues_.clear(what.queue, what.bank));
  return true;
}

bool MotionServer::pass_on(const command::QueueEnd& what, const CommandRequested& requested,
                           const Request& request) {
  if (reject_at_tick(requested)) return true;
  if (queues_.end(what.queue))
    answer_queue(request, true);
  else
    decline(
        requested, Cause::not_on_path,
        "the end of this queue cannot be set: the queue is not dynamic, or none of its rows ends "
        "at rest");
  return true;
}

/// Rejects a command about a queue, or about the commands of a group, for a later tick.
bool MotionServer::reject_at_tick(const CommandRequested& requested) {
  if (requested.at >= 0)
    decline(requested, Cause::no_start_tick,
            "a command for a queue takes effect at once: leave out --at");
  return requested.at >= 0;
}

void MotionServer::answer_queue(const Request& request, bool done) {
  answer(request, done ? std::nullopt : std::optional(Refusal{.cause = Cause::in_motion}));
}

/// Rejects a command if more wait than any streamer needs: the axis takes one command a tick.
bool MotionServer::reject_if_full(std::int64_t session, std::int32_t command) {
  if (commands_.full()) refuse_crowd(session, command);
  return commands_.full();
}

void MotionServer::refuse_crowd(std::int64_t session, std::int32_t command) {
  receiver_.refuse(session, command, "too many commands are waiting: repeat this one later",
                   static_cast<std::int32_t>(Cause::buffer_full));
}

/// Rejects a command for a reason that is more precise than the text of its cause.
void MotionServer::decline(const CommandRequested& requested, Cause cause, FixedReason reason) {
  decline_with(requested, cause, reason.text);
}

void MotionServer::decline_with(const CommandRequested& requested, Cause cause,
                                const std::string& reason) {
  receiver_.refuse(requested.session, requested.command, reason, static_cast<std::int32_t>(cause));
}

void MotionServer::handle(const QueueArmRequested& arm) {
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

void MotionServer::handle(const QueueOpened& opened) {
  const std::uint64_t id = ++numbers_;
  const bool made = queues_.open(opened, id, options_.axis, receiver_);
  if (made && options_.recorder != nullptr)
    options_.recorder->note(RecordedQueue{axis_, id, opened.queue});
}

void MotionServer::handle(const RowsArrived& arrived) {
  queues_.take(arrived, receiver_);
}

void MotionServer::clear_commands() {
  builder_.cancel();
  for (const std::uint64_t movement : commands_.clear()) movements_.erase(movement);
}

// ---- the axis ----------------------------------------------------------------------------------

void MotionServer::take_answers() {
  while (const auto reply = commands_.take_answer()) {
    if (reply->request && !takes_answer(*reply)) answer(*reply->request, reply->refused);
    for (const Movement* movement : reply->handed_back) {
      if (movement == nullptr) continue;
      queues_.handed_back(movement->id());
      movements_.erase(movement->id());
    }
  }
}

bool MotionServer::armed_is_live() const {
  const auto armed = movements_.find(armed_);
  return armed != movements_.end() && armed->second.made.movement->course() == Course::live;
}

void MotionServer::answer(const Request& request, const std::optional<Refusal>& refused) {
  if (request.kind == Kind::start) start_.answer(request.session, request.command, refused);
  // A stop that an axis in a fault rejects still counts as accepted: the axis does not move.
  if (!refused || request.kind == Kind::stop)
    return receiver_.accept(request.session, request.command, request.note);
  const std::string reason = refusal_text(*refused, last_, options_, request.kind, armed_is_live());
  receiver_.refuse(request.session, request.command, reason,
                   static_cast<std::int32_t>(refused->cause));
  notify("rejected: " + reason);
}

void MotionServer::take_ticks() {
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
    for (auto& event :
         events_of(last_, tick, options_.switches.of, options_.axis.period, event_count_)) {
      event_count_ = event.count;
      events_.push_back(event);
    }
    start_.follow(last_, tick);
    follow(tick);
    last_ = tick;
  }
}

void MotionServer::write(const Tick& tick) {
  log_->add(tick);
  if (log_truncated_ || log_->truncated().empty()) return;
  log_truncated_ = true;
  notify("the log ends at tick " + std::to_string(tick.tick) + " (" + log_->truncated() +
         "); the axis goes on");
}

wire::Status MotionServer::status() const {
  const auto [waiting, capacity] = queues_.fill(last_.job != 0 ? last_.job : last_.armed);
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
                      .reason = static_cast<std::int32_t>(last_.reason),
                      .queue_rows = waiting,
                      .queue_capacity = capacity,
                      .outputs = last_.switches.outputs,
                      .lateness = cycle_.lateness.counts(),
                      .computing = cycle_.computing.counts(),
                      .units = options_.units,
                      .held = last_.held,
                      .homed = last_.homed,
                      .unwritten = unwritten(),
                      .gear_master = options_.leads,
                      .ratio = last_.ratio};
  if (last_.compensated) status.correction = last_.correction[0];
  if (last_.job != 0 || last_.progress != Progress::done)
    status.progress = jounce::on_wire(last_.progress);
  if (last_.armed != 0) status.next = last_.waiting ? wire::Next::waiting : wire::Next::armed;
  start_.report(status, receiver_.session(), options_.units, last_);
  const auto kept = movements_.find(last_.job != 0 ? last_.job : last_.armed);
  if (kept != movements_.end()) {
    std::copy_n(kept->second.hash.begin(), status.table.size(), status.table.begin());
    if (kept->second.made.movement->synchronized()) status.master_position = last_.master;
  }
  return status;
}

std::uint8_t MotionServer::unwritten() const {
  const unsigned recorder = options_.recorder != nullptr ? options_.recorder->unwritten() : 0U;
  return static_cast<std::uint8_t>(recorder |
                                   (log_truncated_ ? unsigned{wire::log_unwritten} : 0U));
}

void MotionServer::notify(const std::string& notice) const {
  if (options_.notify) options_.notify(notice);
}

}  // namespace jounce
