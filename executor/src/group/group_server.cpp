// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/group_server.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/executor/detail/trace.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// "for an acknowledgment of M6", or of the next step.
std::string awaited(std::optional<std::int32_t> m_word) {
  return "for an acknowledgment " +
         (m_word ? "of M" + std::to_string(*m_word) : std::string("in single step"));
}

}  // namespace

GroupServer::GroupServer(ExecutorOptions options, Receiver& receiver, MachineExchange& exchange,
                         std::size_t axis, Worker& worker,
                         std::function<double(std::size_t axis)> position_of)
    : MotionServer(std::move(options), receiver, exchange, axis, worker),
      dynamics_(*options_.group),
      queue_(
          *options_.group, worker, options_.build_apart,
          [axes = options_.group->of.axes, position_of = std::move(position_of)] {
            Point places{};
            for (std::size_t k = 0; k < axes.size(); ++k) places[k] = position_of(axes[k]);
            return places;
          },
          [this](std::uint64_t movement) {
            const auto kept = movements_.find(movement);
            return kept == movements_.end() ? nullptr : kept->second.made.program;
          }) {}

// ---- requests ----------------------------------------------------------------------------------

std::optional<Refusal> GroupServer::unfit(const ArmRequested& arm) const {
  if (arm.mode != wire::ArmMode::path) return Refusal{.cause = Cause::single_axis};
  if (queue_.has_stages())
    return Refusal{.cause = moving() ? Cause::in_motion : Cause::awaits_acknowledge};
  return std::nullopt;
}

void GroupServer::begins(const Kept& armed) {
  dynamics_.begin();
  set_rate(rate_of(armed, 0));
}

void GroupServer::halts() {
  if (queue_.has_stages()) queue_.clear();
}

void GroupServer::obey(const CommandRequested& requested, const Request& request) {
  std::visit([&](const auto& what) { obey(what, requested, request); }, requested.what);
}

/// A command for the queue of the group, or one that the axis of the group executes as it is. Commands
/// of gears are rejected.
template <class What>
void GroupServer::obey(const What& what, const CommandRequested& requested,
                       const Request& request) {
  if constexpr (is_path_command<What>) {
    if (requested.at >= 0)
      return decline(requested, Cause::no_start_tick,
                     "a command of a group begins after the commands before it: leave out --at");
    if (queue_.full()) return refuse_crowd(requested.session, requested.command);
    motion_session_ = requested.session;
    if (holds_to_run(requested.what)) held_session_ = requested.session;
    return queue_.take(what, request);
  } else if (!pass_on(requested, request)) {
    answer(request, Refusal{.cause = Cause::single_axis});
  }
}

/// Arms and starts the program of a group. The start decides whether its axes stand where it begins.
void GroupServer::obey(const command::StartTable& /*it*/, const CommandRequested& requested,
                       const Request& request) {
  const auto& sent = options_.group->sent;
  if (!sent)
    return decline(requested, Cause::nothing_to_start,
                   "the group has no program of its own: send a path with `jounce stream`, or add "
                   "program to its [[group]]");
  if (moving()) return answer(request, Refusal{.cause = Cause::in_motion});
  if (queue_.has_stages()) return answer(request, Refusal{.cause = Cause::awaits_acknowledge});
  motion_session_ = requested.session;
  play(movement_of(sent, ++numbers_, *options_.group, queue_.single_step()), request, requested.at);
}

/// Arms and starts the newest movement of a group.
void GroupServer::play(MadeMovement path, const Request& request, std::int64_t at,
                       bool own_limits) {
  record(path);
  const Kept& kept = movements_[numbers_] = {std::move(path), {}};
  dynamics_.begin(own_limits);
  set_rate(rate_of(kept, 0));
  commands_.send({command::Disarm{}});
  commands_.send({command::Arm{kept.made.movement.get()}});
  commands_.send({command::Start{.tick = at}}, request);
}

void GroupServer::obey(const command::GroupAcknowledge& what, const CommandRequested& requested,
                       const Request& request) {
  if (reject_at_tick(requested)) return;
  const auto m_word = queue_.m_word();
  const bool waits = queue_.rests_because(last_) == Cause::awaits_acknowledge;
  Cause no = queue_.acknowledge(what.m_word);
  if (no == Cause::no_handshake && waits)
    return decline_with(requested, no,
                        "the group waits " + awaited(m_word) + ", not of M" +
                            std::to_string(what.m_word) + ": leave out --m-word" +
                            (m_word ? ", or give " + std::to_string(*m_word) : std::string()));
  if (no == Cause::no_handshake && last_.state == State::error_stop) no = Cause::in_error;
  if (no == Cause::none && m_word) take_step(group_step::Announce{*m_word, false});
  answer(request, no == Cause::none ? std::nullopt : std::optional(Refusal{.cause = no}));
}

void GroupServer::obey(const command::GroupSingleStep& what, const CommandRequested& requested,
                       const Request& request) {
  if (reject_at_tick(requested)) return;
  queue_.single_step(what.on);
  answer(request, std::nullopt);
}

/// A group that waits for an acknowledgment is not held: another order continues it.
void GroupServer::obey(const command::Resume& /*what*/, const CommandRequested& requested,
                       const Request& request) {
  if (queue_.rests_because(last_) != Cause::awaits_acknowledge)
    return static_cast<void>(pass_on(requested, request));
  const auto m_word = queue_.m_word();
  decline_with(requested, Cause::awaits_acknowledge,
               "the group is not held: it waits " + awaited(m_word) + ": send `jounce order " +
                   options_.receiver.executor + " acknowledge`");
}

void GroupServer::obey(const command::Override& what, const CommandRequested& requested,
                       const Request& request) {
  dynamics_.set(what);
  set_rate(present_rate(), request, requested.at);
}

void GroupServer::obey(const command::GroupSetOverride& what, const CommandRequested& requested,
                       const Request& request) {
  dynamics_.set(what);
  limit(false);
  set_rate(present_rate(), request, requested.at);
}

/// Queued limits take their place in the order of the commands.
void GroupServer::obey(const command::GroupSetLimits& what, const CommandRequested& requested,
                       const Request& request) {
  if (requested.at >= 0)
    return decline(requested, Cause::no_start_tick,
                   "further limits of a group apply at once: leave out --at");
  if (!what.queued) {
    if (const Cause no = permitted(last_.state, request.kind); no != Cause::none)
      return answer(request, Refusal{.cause = no});
    return set_limits(what, request);
  }
  if (queue_.full()) return refuse_crowd(requested.session, requested.command);
  queue_.take(what, request);
}

void GroupServer::clear_commands() {
  queue_.clear();
  if (commands_.waits(CommandKind::override_)) rate_ = NAN;  // it is sent again
  const bool dropped = commands_.waits(CommandKind::start) || commands_.waits(CommandKind::extend);
  MotionServer::clear_commands();
  if (dropped) queue_.answered(false, movement_);
}

// ---- the steps of the queue --------------------------------------------------------------------

void GroupServer::take_steps() {
  if (last_.state == State::disabled && dynamics_.limits()) {
    dynamics_.clear();
    limit(true);
  }
  if (movements_.contains(last_.job) && commands_.idle()) set_rate(present_rate());
  while (const auto step = queue_.next(last_))
    std::visit([&](const auto& one) { take_step(one); }, *step);
}

void GroupServer::take_step(const group_step::Halt& /*halt*/) {
  commands_.send({command::Halt{}});
}

void GroupServer::take_step(const group_step::Play& step) {
  play(movement_of(step.program, ++numbers_), step.request, -1, step.own_limits);
  movement_ = numbers_;
  if (!step.notice.empty()) notify(step.notice);
}

void GroupServer::take_step(const group_step::Extend& step) {
  MadeMovement path = movement_of(step.program, ++numbers_);
  record(path);
  commands_.send({command::Extend{path.movement.get(), step.position, step.shift, step.until}},
                 {step.request.session, step.request.command, CommandKind::extend});
  movement_ = path.movement->id();
  movements_[movement_] = {std::move(path), {}, step.position, step.shift};
}

void GroupServer::take_step(const group_step::SetLimits& step) {
  set_limits(step.limits, step.request, step.continues);
}

void GroupServer::take_step(const group_step::Announce& step) {
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

void GroupServer::take_step(const group_step::Note& step) {
  notify(step.text);
}

void GroupServer::take_step(const group_step::Reply& reply) {
  if (reply.reason.empty())
    return answer(reply.request, reply.cause == Cause::none
                                     ? std::nullopt
                                     : std::optional(Refusal{.cause = reply.cause}));
  receiver_.refuse(reply.request.session, reply.request.command, reply.reason,
                   static_cast<std::int32_t>(reply.cause));
}

/// Passes the outcome of a step to the queue. Returns true if the queue decides later how to answer the
/// request.
bool GroupServer::takes_answer(const CommandQueue::Reply& reply) {
  const CommandKind kind = reply.request->kind;
  if (kind != CommandKind::extend && !is_path_kind(kind)) return false;
  queue_.answered(!reply.refused, movement_);
  return kind == CommandKind::extend && reply.refused;
}

// ---- limits and override -----------------------------------------------------------------------

namespace {

/// "1 (x) or 2 (y)", the numbers of axes with these names.
std::string numbered(const std::vector<std::string>& names) {
  std::string all;
  for (std::size_t k = 0; k < names.size(); ++k)
    all += (k == 0                  ? ""
            : k + 1 == names.size() ? " or "
                                    : ", ") +
           std::to_string(k + 1) + " (" + names[k] + ")";
  return all;
}

}  // namespace

namespace {

/// A remark on further limits of an axis that are above its own limits, which remain.
std::string remaining_limits(const command::GroupSetLimits& what, const ExecutorGroup& group) {
  if (what.axis < 1) return "";
  const auto k = static_cast<std::size_t>(what.axis) - 1;
  const Limits& own = group.configs[k].limits;
  const std::string& unit = k < group.units.size() ? group.units[k] : group.unit;
  std::string lower;
  const auto compare = [&](const char* name, double given, const std::optional<double>& limit,
                           const char* per) {
    if (!limit || !(given > *limit)) return;
    lower += (lower.empty() ? "" : ", ") + std::string(name) + " " + six_digits(*limit) +
             (unit.empty() ? "" : " " + unit + per);
  };
  compare("velocity", what.dynamics.velocity, own.velocity, "/s");
  compare("acceleration", what.dynamics.acceleration, own.acceleration, "/s^2");
  compare("jerk", what.dynamics.jerk, own.jerk, "/s^3");
  return lower.empty() ? "" : "the lower limits of " + group.names[k] + " remain: " + lower;
}

}  // namespace

void GroupServer::set_limits(const command::GroupSetLimits& what, const Request& request,
                             bool continues) {
  try {
    dynamics_.set(what, continues);
    limit(what.axis != 0 && !what.queued);
    if (moving()) set_rate(present_rate());
    Request noted = request;
    noted.note = remaining_limits(what, *options_.group);
    answer(noted, std::nullopt);
  } catch (const InputError& error) {
    const InputError named(
        "--" + error.key(), error.value(),
        error.key() == "axis" ? "must be " + numbered(options_.group->names) : error.rule());
    receiver_.refuse(request.session, request.command, named.what(),
                     static_cast<std::int32_t>(Cause::no_value));
  }
}

/// Passes the limits to the commands of the group that follow.
void GroupServer::limit(bool from_rest) {
  queue_.limit(dynamics_.next(), from_rest);
}

/// The override factor of the program that the group plays.
double GroupServer::present_rate() const {
  const auto playing = movements_.find(last_.job);
  return playing == movements_.end() ? dynamics_.rate() : rate_of(playing->second, last_.position);
}

/// The override factor of a program at a position: below the commanded one if the limits require it.
double GroupServer::rate_of(const Kept& kept, double position) const {
  const GroupProgram* const program = kept.made.program.get();
  if (program == nullptr) return dynamics_.rate();
  return std::min(dynamics_.rate(*program, position - kept.origin), queue_.highest_rate());
}

/// Sends an override factor to the group if it differs from the present one, or if a request waits.
void GroupServer::set_rate(double rate, const std::optional<Request>& request, std::int64_t at) {
  const Command command{.what = command::Override{rate}, .at = at};
  if (request)
    commands_.send(command, *request);
  else if (rate != rate_)
    commands_.send(command);
  rate_ = rate;
}

// ---- the motion --------------------------------------------------------------------------------

/// A tick of a group: the M words that it passes, and the begin of a motion. This may be the first
/// motion of a program that was sent as a whole.
void GroupServer::follow(const Tick& tick) {
  const bool extended = last_.job != 0 && tick.job != 0 && tick.finished == last_.finished;
  if (tick.job != last_.job && tick.job == 0)
    pass_m_words(tick);
  else if (tick.job != last_.job) {
    const auto kept = movements_.find(tick.job);
    const auto [made, hash, origin, shift] = kept == movements_.end() ? Kept{} : kept->second;
    m_words_.begin(made.program, extended ? last_.path_time - shift : 0);
    if (made.sent) queue_.begins(tick.job, made.program, made.sent, made.sent_last, tick);
  }
  if (tick.job != 0) pass_m_words(tick);
}

void GroupServer::pass_m_words(const Tick& tick) {
  for (wire::Event& event : m_words_.passed(last_, tick, options_.axis.period)) {
    event.count = ++event_count_;
    events_.push_back(event);
  }
}

wire::Status GroupServer::status() const {
  wire::Status status = MotionServer::status();
  if (const std::size_t commands = queue_.taken(last_); commands > 0) {
    status.queue_rows = static_cast<std::uint32_t>(commands);
    status.queue_capacity = GroupQueue::most_commands;
  }
  if (last_.reason == Cause::none)
    status.reason = static_cast<std::int32_t>(queue_.rests_because(last_));
  return status;
}

std::optional<wire::GroupStatus> GroupServer::group_status() {
  const auto playing = movements_.find(last_.job);
  const auto program = playing == movements_.end() ? nullptr : playing->second.made.program;
  wire::GroupStatus status =
      report_.status(*options_.group, last_, queue_.places(), program, queue_);
  if (options_.trace != nullptr && program && program != traced_) {
    options_.trace->set(axis_, *trace_path(*program, *options_.group, playing->second.origin));
  }
  if (program) traced_ = program;
  return status;
}

}  // namespace jounce
