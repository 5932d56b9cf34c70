#include "jounce/executor/desk.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>
#include <variant>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Kind = Command::Kind;

bool differ(const std::string& axis, const std::string& table) {
  return !axis.empty() && axis != table;
}

wire::AxisState on_wire(State state) {
  switch (state) {
    case State::disabled:
      return wire::AxisState::disabled;
    case State::standstill:
      return wire::AxisState::standstill;
    case State::discrete_motion:
      return wire::AxisState::discrete_motion;
    case State::synchronized_motion:
      return wire::AxisState::synchronized_motion;
    case State::stopping:
      return wire::AxisState::stopping;
    default:
      break;
  }
  return wire::AxisState::error_stop;
}

/// The tables as a motion; nothing where they do not make one.
std::unique_ptr<Job> made(const ArmRequested& arm, std::uint64_t id, std::int64_t period,
                          double position) {
  const double tick = static_cast<double>(period) * 1e-9;
  try {
    return arm.master ? std::make_unique<Job>(id, arm.master->table, arm.slave.table, tick,
                                              arm.coupling, position)
                      : std::make_unique<Job>(id, arm.slave.table, nullptr, tick);
  } catch (const InputError&) {
    return nullptr;
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace

Desk::Desk(ExecutorOptions options, Receiver& receiver, Post& post, std::size_t axis,
           Worker& worker)
    : options_(std::move(options)),
      receiver_(receiver),
      mail_(*post.mail[axis]),
      vitals_(post.vitals),
      worker_(worker) {
  if (options_.log) log_.emplace(*options_.log, options_.units);
  if (options_.enable) order({.kind = Kind::enable});
  flush();
}

void Desk::turn() {
  while (const auto event = receiver_.take_event())
    std::visit([&](const auto& e) { handle(e); }, *event);
  take_built();
  take_answers();
  take_ticks();  // the later: the tick of every answer is there to be taken
  flush();
}

void Desk::retire() {
  retired_ = true;
  clear_outbox();
  order({.kind = Kind::stop});
  flush();
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
  if (arm.mode == wire::ArmMode::follow_input) return Refusal{.cause = Cause::no_master_input};
  if (differ(options_.units.position, arm.slave.units.position) ||
      (arm.master && differ(options_.units.x, arm.slave.units.x)))
    return Refusal{.cause = Cause::wrong_unit};
  return std::nullopt;
}

/// Where the axis will stand when what it plays now is over.
double Desk::next_rest() const {
  const auto playing = jobs_.find(last_.job);
  return playing == jobs_.end() ? last_.position : playing->second.job->last().slave[0];
}

void Desk::handle(const ArmRequested& arm) {
  if (const auto refusal = unfit(arm))
    return answer({arm.session, arm.command, Kind::arm}, refusal);
  if (building_)
    next_arm_ = arm;  // one that waited is void: the receiver answers the newest command only
  else
    build(arm);
}

void Desk::build(const ArmRequested& arm) {
  const std::uint64_t id = ++numbers_;
  const std::size_t knots =
      arm.slave.table->size() + (arm.master ? arm.master->table->size() : std::size_t{0});
  auto make = [arm, id, period = options_.axis.period, position = next_rest()] {
    return made(arm, id, period, position);
  };
  if (knots <= options_.build_apart) return this->arm(arm, make());
  building_.emplace(Building{arm, worker_.ask(std::move(make))});
}

void Desk::take_built() {
  using namespace std::chrono_literals;
  if (!building_ || building_->job.wait_for(0s) != std::future_status::ready) return;
  Building built = std::move(*building_);
  building_.reset();
  std::unique_ptr<Job> job = built.job.get();
  if (!built.void_) arm(built.arm, std::move(job));
  if (const auto next = std::exchange(next_arm_, std::nullopt)) build(*next);
}

void Desk::arm(const ArmRequested& arm, std::unique_ptr<Job> job) {
  const Request request{arm.session, arm.command, Kind::arm};
  if (!job) return answer(request, Refusal{.cause = Cause::bad_table});
  if (last_.fault != Cause::none && arm.session != fault_session_) {
    // Only a job that will be armed may clear a fault.
    const double at = options_.adopt_start ? job->first().slave[0] : last_.position;
    if (const auto refusal = admit(*job, options_.axis, at)) return answer(request, refusal);
    order({.kind = Kind::reset});
  }
  if (options_.adopt_start && !moving())
    order({.kind = Kind::set_position, .position = job->first().slave[0]});
  order({.kind = Kind::arm, .movement = job.get()}, request);
  const std::uint64_t id = job->id();
  jobs_[id] = {std::move(job), arm.slave.hash};
}

void Desk::handle(const StartRequested& start) {
  motion_session_ = start.session;
  order({.kind = Kind::start, .at = start.tick}, {start.session, start.command, Kind::start});
}

void Desk::handle(const StopRequested& stop) {
  clear_outbox();
  const Kind kind = stop.mode == wire::StopMode::abort ? Kind::abort : Kind::stop;
  order({.kind = kind}, {stop.session, stop.command, kind});
}

void Desk::handle(const SessionEnded& ended) {
  const bool silent = ended.why == SessionEnded::Why::silent;
  if (silent) notify("the owner has fallen silent");
  drop_builds();
  // The motion may be that of an owner before, who released it to run on.
  const bool its_motion = ended.session == motion_session_;
  order({.kind = silent && its_motion && options_.stop_when_silent ? Kind::stop : Kind::disarm});
}

// Orders and queues are understood, and refused: this axis plays tables.
void Desk::handle(const OrderRequested& order) {
  receiver_.refuse(order.session, order.command, "this axis plays tables only",
                   static_cast<std::int32_t>(Cause::no_value));
}

void Desk::handle(const QueueArmRequested& arm) {
  receiver_.refuse(arm.session, arm.command, "this axis plays tables only",
                   static_cast<std::int32_t>(Cause::no_value));
}

void Desk::handle(const QueueOpened& opened) {
  receiver_.refuse_queue(opened.queue.queue, wire::Refusal::bad_queue,
                         "this axis plays tables only");
}

/// A stop goes ahead of whatever has not reached the axis yet, and makes it void.
void Desk::clear_outbox() {
  drop_builds();
  for (const Command& command : outbox_) {
    if (command.movement != nullptr) jobs_.erase(command.movement->id());
    unanswered_.erase(command.id);
  }
  outbox_.clear();
}

void Desk::drop_builds() {
  next_arm_.reset();
  if (building_) building_->void_ = true;
}

// ---- the axis ----------------------------------------------------------------------------------

void Desk::order(Command command) {
  command.id = ++numbers_;
  outbox_.push_back(command);
}

/// An order that somebody waits for.
void Desk::order(const Command& command, const Request& request) {
  order(command);
  unanswered_[numbers_] = request;
}

void Desk::flush() {
  for (; !outbox_.empty() && under_way_ < Mail::most_commands; outbox_.pop_front()) {
    mail_.commands.push(outbox_.front());
    ++under_way_;
  }
}

void Desk::take_answers() {
  for (Answer from_axis; mail_.answers.pop(from_axis);) {
    if (from_axis.id != 0) --under_way_;
    if (const auto it = unanswered_.find(from_axis.id); it != unanswered_.end()) {
      answer(it->second, from_axis.refused);
      unanswered_.erase(it);
    }
    for (const Movement* movement : from_axis.handed_back)
      if (movement != nullptr) jobs_.erase(movement->id());
  }
}

void Desk::answer(const Request& request, const std::optional<Refusal>& refused) {
  // A stop that an axis in a fault does not obey is a stop all the same: it does not move.
  if (!refused || request.kind == Kind::stop)
    return receiver_.accept(request.session, request.command);
  receiver_.refuse(request.session, request.command, refused->text(),
                   static_cast<std::int32_t>(refused->cause));
  notify("refused: " + refused->text());
}

void Desk::take_ticks() {
  for (Tick tick; mail_.ticks.pop(tick);) {
    if (log_) write(tick);
    compare(tick);
    last_ = tick;
  }
}

void Desk::write(const Tick& tick) {
  log_->add(tick);
  if (log_truncated_ || log_->truncated().empty()) return;
  log_truncated_ = true;
  notify("the log ends at tick " + std::to_string(tick.tick) + " (" + log_->truncated() +
         "); the axis goes on");
}

/// Tells what has become of the axis since the tick before.
void Desk::compare(const Tick& tick) {
  const std::string at = " at tick " + std::to_string(tick.tick);
  if (tick.job != 0 && tick.job != last_.job) notify("started" + at);
  if (tick.finished > last_.finished) notify("finished" + at);
  if (tick.stopped > last_.stopped) notify("stopped" + at);
  if (tick.fault == last_.fault) return;
  if (tick.fault != Cause::none) {
    fault_session_ = receiver_.session();
    notify(std::string("fault: ") + name(tick.fault) + ": " + meaning(tick.fault) + at);
  }
}

wire::Status Desk::status() const {
  wire::Status status{.state = on_wire(last_.state),
                      .tick = last_.tick,
                      .cycle_ns = options_.axis.period,
                      .master_position = NAN,
                      .slave_position = last_.position,
                      .slave_velocity = last_.velocity,
                      .last_error = static_cast<std::int32_t>(last_.fault),
                      .late_ticks = vitals_.late.load(std::memory_order_relaxed),
                      .finished = static_cast<std::int64_t>(last_.finished),
                      .stopped = static_cast<std::int64_t>(last_.stopped),
                      .units = options_.units};
  if (last_.armed != 0) status.next = last_.waiting ? wire::Next::waiting : wire::Next::armed;
  const auto kept = jobs_.find(last_.job != 0 ? last_.job : last_.armed);
  if (kept != jobs_.end()) {
    std::copy_n(kept->second.hash.begin(), status.table.size(), status.table.begin());
    if (kept->second.job->synchronized()) status.master_position = last_.master;
  }
  return status;
}

void Desk::notify(const std::string& notice) const {
  if (options_.notify) options_.notify(notice);
}

}  // namespace jounce
