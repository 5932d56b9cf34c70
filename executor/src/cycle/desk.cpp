// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/desk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "jounce/command/command_table.hpp"
#include "jounce/command/refusal_text.hpp"
#include "jounce/executor/commands.hpp"
#include "jounce/executor/events.hpp"
#include "jounce/executor/recorder.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Kind = CommandKind;

constexpr std::int64_t no_group = 0;  // an axis that starts alone

bool differ(const std::string& axis, const std::string& table) {
  return !axis.empty() && axis != table;
}

}  // namespace

Desk::Desk(ExecutorOptions options, Receiver& receiver, Post& post, std::size_t axis,
           Worker& worker)
    : options_(std::move(options)),
      axis_(axis),
      receiver_(receiver),
      mail_(*post.mail[axis]),
      vitals_(post.vitals),
      worker_(worker),
      outbox_(mail_),
      queues_(mail_.rows, recorded_rows()) {
  if (options_.log) log_.emplace(*options_.log, options_.units);
  if (options_.enable) outbox_.send({command::Enable{}});
  outbox_.flush();
}

void Desk::turn() {
  while (const auto event = receiver_.take_event())
    std::visit([&](const auto& e) { handle(e); }, *event);
  take_built();
  take_answers();
  take_ticks();  // later than the answers: the tick of every answer is then available
  queues_.report(last_, receiver_);
  outbox_.flush();
}

void Desk::retire() {
  retired_ = true;
  clear_outbox();
  outbox_.send({command::Stop{}});
  outbox_.flush();
}

void Desk::close() {
  take_answers();
  take_ticks();
  if (log_) log_->close();
  if (log_) log_truncated_ = !log_->truncated().empty();
  log_.reset();
}

// ---- requests ----------------------------------------------------------------------------------

void Desk::handle(const TableReady& ready) {
  notify("table " + hex(ready.table.hash).substr(0, 16) + ", " +
         std::to_string(ready.table.table->size()) + " knots");
}

std::optional<Refusal> Desk::unfit(const ArmRequested& arm) const {
  if (retired_) return Refusal{.cause = Cause::leaving};
  const bool live = arm.mode == wire::ArmMode::follow_input;
  if (live && options_.follow.what == Follow::What::nothing)
    return Refusal{.cause = Cause::no_master_input};
  if (differ(options_.units.position, arm.slave.units.position) ||
      ((arm.master || live) && differ(options_.units.x, arm.slave.units.x)))
    return Refusal{.cause = Cause::wrong_unit};
  return std::nullopt;
}

/// The position of the axis at the end of its present motion.
double Desk::next_rest() const {
  const auto playing = movements_.find(last_.job);
  return playing == movements_.end() ? last_.position
                                     : playing->second.made.last.value_or(last_.position);
}

void Desk::handle(const ArmRequested& arm) {
  if (crowded(arm.session, arm.command)) return;
  if (const auto refusal = unfit(arm))
    return answer({arm.session, arm.command, Kind::arm}, refusal);
  if (building_)
    next_arm_ = arm;  // replaces a waiting one: the receiver answers only the newest command
  else
    build(arm);
}

/// On a modulo axis, positions a turn apart are equal: a coupling shifts by whole turns if
/// necessary.
ArmRequested Desk::on_axis(ArmRequested arm) const {
  const double turn = options_.axis.modulo;
  if (turn != 0 && !arm.coupling.slave_period) arm.coupling.slave_period = turn;
  return arm;
}

void Desk::build(const ArmRequested& arm) {
  const std::uint64_t id = ++numbers_;
  const std::size_t knots =
      arm.slave.table->size() + (arm.master ? arm.master->table->size() : std::size_t{0});
  auto now = [arm = on_axis(arm), id, period = options_.axis.period, position = next_rest()] {
    return movement_of(arm, id, period, position);
  };
  if (knots > options_.build_apart)
    building_.emplace(Building{arm, worker_.ask(std::move(now))});
  else
    this->arm({arm.session, arm.command, Kind::arm}, now(), arm.slave.hash, arm.session);
}

void Desk::take_built() {
  using namespace std::chrono_literals;
  if (!building_ || building_->made.wait_for(0s) != std::future_status::ready) return;
  Building built = std::move(*building_);
  building_.reset();
  MadeMovement made = built.made.get();
  const Request request{built.arm.session, built.arm.command, Kind::arm};
  if (!built.void_) arm(request, std::move(made), built.arm.slave.hash, built.arm.session);
  if (const auto next = std::exchange(next_arm_, std::nullopt)) build(*next);
}

void Desk::arm(const Request& request, MadeMovement made, const Sha256& hash, std::int64_t group) {
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
    outbox_.send({command::Reset{}});
    if (last_.job != 0)
      outbox_.send({command::Stop{}});  // the remainder of an underrun is not continued
  }
  if (adopts) outbox_.send({command::SetPosition{*made.first}});
  if (options_.recorder != nullptr && made.source) record(*made.source);
  outbox_.send({command::Arm{made.movement.get(), group}}, request);
  armed_ = made.movement->id();
  movements_[armed_] = {std::move(made), hash};
}

/// Called before the arm is sent to the axis.
void Desk::record(const MadeFrom& source) {
  RecordedJob job = source.job;
  job.axis = axis_;
  options_.recorder->job(job, source.time, source.cam ? &*source.cam : nullptr);
}

void Desk::handle(const StartRequested& start) {
  if (crowded(start.session, start.command)) return;
  motion_session_ = start.session;
  start_ = {.session = start.session, .command = start.command, .movement = armed_};
  outbox_.send({command::Start{start.when, start.tick, start.position, start.session}},
               {start.session, start.command, Kind::start});
}

void Desk::handle(const StopRequested& stop) {
  clear_outbox();
  Command command{command::Stop{}};
  if (stop.mode == wire::StopMode::abort) command.what = command::Abort{};
  outbox_.send(command, {stop.session, stop.command, command.kind()});
}

void Desk::handle(const SessionEnded& ended) {
  const bool silent = ended.why == SessionEnded::Why::silent;
  if (silent) notify("the session timed out: no heartbeat from its streamer");
  drop_builds();
  queues_.close();
  // The motion may belong to a previous owner, who released it while running.
  const bool its_motion = ended.session == motion_session_;
  // Applies also after later commands of the session. An operator's stop is already in transit to the
  // axis, and requires an answer.
  if (ended.session == held_session_ && ended.why != SessionEnded::Why::operator_stop) {
    clear_outbox();
    return outbox_.send({command::Release{}});
  }
  const bool stops = silent && its_motion && options_.stop_when_silent;
  // An armed motion no longer begins; a move that waits for the previous one, or for its tick,
  // does.
  const bool armed = last_.armed != 0 || busy();
  if (!stops && !armed) return;
  Command command{command::Disarm{}};
  if (stops) command.what = command::Stop{};
  if (outbox_.last() != command.kind()) outbox_.send(command);
}

void Desk::handle(const CommandRequested& requested) {
  const CommandKind kind = kind_of(requested.what);
  if (kind == Kind::disable) clear_outbox();  // ends more than a stop
  if (crowded(requested.session, requested.command)) return;
  const Request request{requested.session, requested.command, kind};
  if (retired_) return answer(request, Refusal{.cause = Cause::leaving});
  std::visit([&](const auto& what) { obey(what, requested, request); }, requested.what);
}

/// A command that the axis executes as it is.
template <class What>
void Desk::obey(const What& what, const CommandRequested& requested, const Request& request) {
  if (info(request.kind).moves) motion_session_ = requested.session;
  if (holds_to_run(requested.what)) held_session_ = requested.session;
  outbox_.send({.what = what, .at = requested.at}, request);
}

void Desk::obey(const command::GearIn& /*gear*/, const CommandRequested& requested,
                const Request& request) {
  couple(requested, request);
}

void Desk::obey(const command::GearInPos& /*gear*/, const CommandRequested& requested,
                const Request& request) {
  couple(requested, request);
}

void Desk::couple(const CommandRequested& requested, const Request& request) {
  motion_session_ = requested.session;
  if (options_.follow.what == Follow::What::nothing)
    return answer(request, Refusal{.cause = Cause::no_master_input});
  try {
    const std::uint64_t id = ++numbers_;
    MadeMovement gear{.movement = gear_of(requested.what, id, options_.axis, last_.position)};
    if (options_.recorder != nullptr)
      options_.recorder->note(RecordedGear{axis_, id, requested.what, last_.position});
    outbox_.send({command::Couple{gear.movement.get(), requested.at}}, request);
    movements_[id] = {std::move(gear), {}};
  } catch (const InputError& error) {
    decline(requested, error.what());
  }
}

/// Arms and starts the axis's own table. It is accepted when it is armed: nothing can prevent the
/// start then.
void Desk::obey(const command::StartTable& /*it*/, const CommandRequested& requested,
                const Request& /*start*/) {
  if (!options_.table)
    return decline(requested, "the axis has no table of its own: send one with `jounce stream`");
  const Request request{requested.session, requested.command, Kind::arm};
  if (moving()) return answer(request, Refusal{.cause = Cause::in_motion});
  const ArmRequested own{.session = requested.session,
                         .command = requested.command,
                         .mode = wire::ArmMode::play,
                         .slave = *options_.table,
                         .master = {}};
  motion_session_ = requested.session;
  outbox_.send({command::Disarm{}});  // if the arm fails, the start then starts nothing else
  arm(request, movement_of(own, ++numbers_, options_.axis.period, last_.position),
      options_.table->hash, no_group);
  outbox_.send({command::Start{.tick = requested.at}});
}

/// Returns the function that records a queue's rows; empty: no record.
Queues::Record Desk::recorded_rows() const {
  if (options_.recorder == nullptr) return {};
  return [recorder = options_.recorder, axis = axis_](const HandedOver& what) {
    recorder->note(RecordedRows{axis, what});
  };
}

void Desk::obey(const command::QueueSwitch& what, const CommandRequested& requested,
                const Request& request) {
  if (untimed(requested)) answer_queue(request, queues_.queue_switch(what.queue));
}

void Desk::obey(const command::QueueClear& what, const CommandRequested& requested,
                const Request& request) {
  if (untimed(requested)) answer_queue(request, queues_.clear(what.queue, what.bank));
}

void Desk::obey(const command::QueueEnd& what, const CommandRequested& requested,
                const Request& request) {
  if (!untimed(requested)) return;
  if (!queues_.end(what.queue))
    return decline(requested, "the queue is not dynamic, or none of its rows ends at rest");
  answer_queue(request, true);
}

/// Declines a command about a queue for a later tick.
bool Desk::untimed(const CommandRequested& requested) {
  if (requested.at >= 0) decline(requested, "queue commands cannot be timed: leave out --at");
  return requested.at < 0;
}

void Desk::answer_queue(const Request& request, bool done) {
  answer(request, done ? std::nullopt : std::optional(Refusal{.cause = Cause::in_motion}));
}

/// Rejects a command if more wait than any streamer needs: the axis takes one command a tick.
bool Desk::crowded(std::int64_t session, std::int32_t command) {
  if (!outbox_.full()) return false;
  receiver_.refuse(session, command, "too many commands are waiting: repeat this one later",
                   static_cast<std::int32_t>(Cause::no_value));
  return true;
}

/// Rejects a command that the protocol permits and this executor does not support.
void Desk::decline(const CommandRequested& requested, const std::string& reason) {
  receiver_.refuse(requested.session, requested.command, reason,
                   static_cast<std::int32_t>(Cause::no_value));
}

void Desk::handle(const QueueArmRequested& arm) {
  if (crowded(arm.session, arm.command)) return;
  const Request request{arm.session, arm.command, Kind::arm};
  if (retired_) return answer(request, Refusal{.cause = Cause::leaving});
  const auto movement = queues_.movement(arm.queue);
  if (!movement) return answer(request, Refusal{.cause = Cause::no_movement});
  if (movements_.contains(movement->id()))
    return answer(request, Refusal{.cause = Cause::in_motion});
  queues_.begin_with(arm.queue, arm.bank);
  this->arm(request, {.movement = movement, .first = queues_.origin(arm.queue)}, {}, arm.session);
}

void Desk::handle(const QueueOpened& opened) {
  const std::uint64_t id = ++numbers_;
  const bool made = queues_.open(opened, id, options_.axis, receiver_);
  if (made && options_.recorder != nullptr)
    options_.recorder->note(RecordedQueue{axis_, id, opened.queue});
}

void Desk::handle(const RowsArrived& arrived) {
  queues_.take(arrived, receiver_);
}

void Desk::clear_outbox() {
  drop_builds();
  for (const std::uint64_t movement : outbox_.clear()) movements_.erase(movement);
}

void Desk::drop_builds() {
  next_arm_.reset();
  if (building_) building_->void_ = true;
}

// ---- the axis ----------------------------------------------------------------------------------

void Desk::take_answers() {
  while (const auto reply = outbox_.take_answer()) {
    if (reply->request) answer(*reply->request, reply->refused);
    for (const Movement* movement : reply->handed_back) {
      if (movement == nullptr) continue;
      queues_.handed_back(movement->id());
      movements_.erase(movement->id());
    }
  }
}

void Desk::answer(const Request& request, const std::optional<Refusal>& refused) {
  if (start_.is(request) && start_.outcome == wire::StartOutcome::none)
    start_.outcome = refused ? wire::StartOutcome::none : wire::StartOutcome::waiting;
  // A stop that an axis in a fault rejects still counts as accepted: the axis does not move.
  if (!refused || request.kind == Kind::stop)
    return receiver_.accept(request.session, request.command);
  receiver_.refuse(request.session, request.command, text(*refused, options_.units.position),
                   static_cast<std::int32_t>(refused->cause));
  notify("refused: " + text(*refused, options_.units.position));
}

void Desk::take_ticks() {
  for (Tick tick; mail_.ticks.pop(tick);) {
    if (log_) write(tick);
    compare(tick);
    for (auto& event : events_of(last_, tick, {options_.switches.of, options_.compare.of},
                                 options_.axis.period, event_count_)) {
      event_count_ = event.count;
      events_.push_back(event);
    }
    follow_start(tick);
    last_ = tick;
  }
}

/// Updates the outcome of the last accepted start: it begins, or its armed movement is gone.
void Desk::follow_start(const Tick& tick) {
  if (start_.outcome != wire::StartOutcome::waiting) return;
  const bool ended = tick.finished > last_.finished && tick.armed != start_.movement;
  if (tick.job == start_.movement || (ended && !tick.dropped)) {
    start_.outcome = wire::StartOutcome::begun;
  } else if (tick.armed != start_.movement) {
    start_.outcome = wire::StartOutcome::dropped;
    const Cause cause = tick.fault != Cause::none ? tick.fault : Cause::stopped;
    start_.why = tick.dropped.value_or(Refusal{.cause = cause});
  }
}

void Desk::write(const Tick& tick) {
  log_->add(tick);
  if (log_truncated_ || log_->truncated().empty()) return;
  log_truncated_ = true;
  notify("the log ends at tick " + std::to_string(tick.tick) + " (" + log_->truncated() +
         "); the axis goes on");
}

/// Reports the changes of the axis since the previous tick.
void Desk::compare(const Tick& tick) {
  const std::string at = " at tick " + std::to_string(tick.tick);
  if (tick.job != 0 && tick.job != last_.job) notify("started" + at);
  if (tick.dropped)
    notify("the armed motion did not start" + at + ": " +
           text(*tick.dropped, options_.units.position));
  if (tick.finished > last_.finished) notify("finished" + at);
  if (tick.stopped > last_.stopped) notify("stopped" + at);
  if (tick.fault == last_.fault) return;
  if (tick.fault != Cause::none) {
    fault_session_ = receiver_.session();
    notify("fault" + at + ": " + name(tick.fault) + ": " + meaning(tick.fault));
  }
}

wire::Status Desk::status() const {
  const auto [waiting, capacity] = queues_.fill(last_.job != 0 ? last_.job : last_.armed);
  wire::Status status{.state = last_.state,
                      .tick = last_.tick,
                      .cycle_ns = options_.axis.period,
                      .master_position = NAN,
                      .slave_position = last_.position,
                      .slave_velocity = last_.velocity,
                      .last_error = static_cast<std::int32_t>(last_.fault),
                      .late_ticks = vitals_.late.load(std::memory_order_relaxed),
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
                      .lateness = vitals_.lateness.counts(),
                      .computing = vitals_.computing.counts(),
                      .units = options_.units,
                      .held = last_.held,
                      .homed = last_.homed,
                      .unwritten = unwritten()};
  if (last_.job != 0 || last_.progress != Progress::done)
    status.progress = jounce::on_wire(last_.progress);
  if (last_.armed != 0) status.next = last_.waiting ? wire::Next::waiting : wire::Next::armed;
  if (start_.session == receiver_.session() && start_.outcome != wire::StartOutcome::none) {
    status.start_command = start_.command;
    status.start = start_.outcome;
    status.start_cause = static_cast<std::int32_t>(start_.why.cause);
    if (start_.outcome == wire::StartOutcome::dropped)
      status.start_reason = text(start_.why, options_.units.position);
  }
  const auto kept = movements_.find(last_.job != 0 ? last_.job : last_.armed);
  if (kept != movements_.end()) {
    std::copy_n(kept->second.hash.begin(), status.table.size(), status.table.begin());
    if (kept->second.made.movement->synchronized()) status.master_position = last_.master;
  }
  return status;
}

std::uint8_t Desk::unwritten() const {
  const unsigned recorder = options_.recorder != nullptr ? options_.recorder->unwritten() : 0U;
  return static_cast<std::uint8_t>(recorder |
                                   (log_truncated_ ? unsigned{wire::log_unwritten} : 0U));
}

void Desk::notify(const std::string& notice) const {
  if (options_.notify) options_.notify(notice);
}

}  // namespace jounce
