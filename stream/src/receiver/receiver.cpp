// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/receiver/receiver.hpp"

#include <algorithm>
#include <cassert>
#include <type_traits>
#include <utility>

#include "jounce/command/command_table.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/wire.hpp"

namespace jounce {
namespace {

constexpr std::size_t remembered_sessions = 16;
constexpr std::size_t most_answers = 64;  // between two polls, for messages of unknown senders

/// The number of a command; 0: not a command.
std::int32_t number_of(const wire::Body& body) {
  return std::visit(
      [](const auto& each) -> std::int32_t {
        using Each = std::decay_t<decltype(each)>;
        if constexpr (requires { each.command; } && !std::is_same_v<Each, wire::Reply>)
          return each.command;
        else
          return 0;
      },
      body);
}

/// True if it is addressed to an executor; messages from executors and masters are not.
bool is_command(const wire::Body& body) {
  const wire::Lane lane = wire::lane(body);
  return lane == wire::Lane::table || lane == wire::Lane::command;
}

/// True if it can open a session.
bool opens(const wire::Body& body) {
  const auto* const heartbeat = std::get_if<wire::Heartbeat>(&body);
  return (heartbeat != nullptr && !heartbeat->release) ||
         std::holds_alternative<wire::Header>(body) || std::holds_alternative<wire::Queue>(body);
}

ReceiverOptions checked(ReceiverOptions options) {
  if (!wire::is_executor_name(options.executor))
    throw InputError("executor", options.executor, wire::executor_name_rule);
  if (options.credit < 1 || options.credit > 64)
    throw InputError("credit", std::to_string(options.credit), "must be 1 to 64");
  return options;
}

}  // namespace

Receiver::Receiver(ReceiverOptions options, std::int64_t boot)
    : options_(checked(std::move(options))),
      boot_(boot),
      tables_({options_.most_knots, options_.memory, options_.credit}),
      challenge_(draw_challenge()),
      operators_challenge_(draw_challenge()) {
  assert(boot > 0);
}

/// Draws another number each time, and at each boot: SplitMix64 maps 64-bit numbers one to one. It
/// need not be secret: with a key, only its holders can sign for it; without a key, any sender may
/// command.
std::int64_t Receiver::draw_challenge() {
  std::int64_t drawn = 0;
  while (drawn <= 0) {
    auto z = static_cast<std::uint64_t>(boot_) +
             static_cast<std::uint64_t>(++challenges_) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    drawn = static_cast<std::int64_t>(z ^ (z >> 31U));
  }
  return drawn;
}

void Receiver::receive(const wire::Message& message, Nanos now) {
  if (message.executor != options_.executor || !is_command(message.body)) return;
  if (message.session == 0) return receive_operators(message);
  if (message.session != session_) expire(now);
  if (repeats(message, command_)) {
    command_.due = true;
    return;
  }
  if (Refused refused = barred(message)) return answer_barred(message, std::move(refused));
  if (session_ == 0 && opens(message.body)) open(message.session);
  const bool fresh = is_fresh(number_of(message.body));
  const std::uint64_t before = rows_taken_;
  std::visit([&](const auto& body) { take(body); }, message.body);
  if (message.session == session_ && (fresh || rows_taken_ != before)) heard_ = now;
}

/// True if the message proves that its streamer is alive. After the first command, only a new
/// number counts: a repeated message may come from any sender, or from the network.
bool Receiver::is_fresh(std::int32_t number) const {
  const wire::Reply& last = command_.reply;
  const bool waits = number == last.command && last.outcome == wire::Outcome::pending;
  return last.command == 0 || number > last.command || waits;
}

/// True for a command of the last session with a recorded outcome: it gets that answer again.
bool Receiver::repeats(const wire::Message& message, const Record& record) const {
  return session_ == 0 && number_of(message.body) == record.reply.command &&
         number_of(message.body) != 0 && message.session == record.session &&
         message.challenge == record.challenge;
}

/// Reason why this message must have no effect.
Refused Receiver::barred(const wire::Message& message) const {
  const std::int64_t session = message.session;
  if (session == session_ && message.challenge == challenge_) return {};
  // The last owner may stop its motion even after its session, until there is another owner.
  if (session_ == 0 && session == command_.session && message.challenge == command_.challenge &&
      std::holds_alternative<wire::Stop>(message.body))
    return {};
  if (session_ != 0 && session != session_)
    return {wire::Refusal::busy, "the axis belongs to another session"};
  if (std::find(ended_.begin(), ended_.end(), session) != ended_.end())
    return {wire::Refusal::session_ended, {}};
  if (message.challenge != challenge_) return {wire::Refusal::stale_challenge, {}};
  if (!opens(message.body)) return {wire::Refusal::unknown_session, {}};
  return {};
}

void Receiver::answer_barred(const wire::Message& message, Refused refused) {
  const auto answer = [&](const auto& body) {
    using Body = std::decay_t<decltype(body)>;
    if constexpr (requires { body.table; } && !std::is_same_v<Body, wire::Status>)
      refuse_table(message.session, body.table, std::move(refused));
    else if constexpr (std::is_same_v<Body, wire::Queue> || std::is_same_v<Body, wire::Rows>)
      refuse_queue_of(message.session, body.queue, std::move(refused));
    else
      refuse_command(message.session, number_of(message.body), std::move(refused));
  };
  std::visit(answer, message.body);
}

/// Each operator command invalidates the challenge that it carries. Without a key, a stop with a
/// wrong challenge is executed nevertheless: this is safe, and faster.
void Receiver::receive_operators(const wire::Message& message) {
  const std::int32_t number = number_of(message.body);
  const auto* const stop = std::get_if<wire::Stop>(&message.body);
  const auto* const command = std::get_if<wire::Command>(&message.body);
  if (stop == nullptr && (command == nullptr || !is_operators(command->kind))) return;
  if (number == operator_.reply.command && message.challenge == operator_.challenge) {
    operator_.due = true;
    return;
  }
  const bool sudden = stop != nullptr && !options_.key && message.challenge == 0;
  if (message.challenge != operators_challenge_ && !sudden)
    return refuse_command(0, number, {wire::Refusal::stale_challenge, {}});
  operators_challenge_ = draw_challenge();
  operator_ = {.challenge = message.challenge,
               .kind = stop != nullptr ? Record::Kind::stop : Record::Kind::command,
               .reply = {.boot = boot_, .command = number},
               .due = true};
  if (command != nullptr) {
    if (Refused refused = misses(*command)) return settle(operator_, std::move(refused));
    events_.emplace_back(
        CommandRequested{0, number, command->at, command_of(command->kind, command->value)});
    return;
  }
  armed_ = false;
  events_.emplace_back(StopRequested{0, number, stop->mode});
  if (session_ != 0) end(SessionEnded::Why::operator_stop);
}

std::vector<wire::Message> Receiver::poll(Nanos now) {
  expire(now);
  return answers();
}

std::vector<wire::Message> Receiver::answers() {
  for (wire::Ack& ack : tables_.acks(boot_)) send(session_, std::move(ack));
  for (auto& [index, queue] : queues_)
    if (std::exchange(queue.ack_due, false)) send(session_, queue.intake.ack(boot_));
  for (Record* record : {&command_, &operator_})
    if (std::exchange(record->due, false)) send(record->session, record->reply);
  return std::exchange(outgoing_, {});
}

std::optional<StreamEvent> Receiver::take_event() {
  if (events_.empty()) return std::nullopt;
  StreamEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

wire::Message Receiver::status(const wire::Status& status) const {
  return {options_.executor, session_, status, challenge_};
}

void Receiver::send(std::int64_t session, wire::Body body) {
  const std::int64_t challenge = session == 0 ? operators_challenge_ : challenge_;
  outgoing_.push_back({options_.executor, session, std::move(body), challenge});
}

void Receiver::take_table(std::uint32_t table, Refused refused) {
  if (refused) refuse_table(session_, table, std::move(refused));
  if (auto ready = tables_.take_ready()) events_.emplace_back(TableReady{session_, *ready});
}

void Receiver::refuse_table(std::int64_t session, std::uint32_t table, Refused refused) {
  answer_stranger(session, wire::Ack{.boot = boot_,
                                     .table = table,
                                     .refusal = refused.refusal,
                                     .reason = std::move(refused.reason)});
}

/// Answers any sender, up to a bound.
void Receiver::answer_stranger(std::int64_t session, wire::Body body) {
  if (outgoing_.size() < most_answers) send(session, std::move(body));
}

// ---- sessions -----------------------------------------------------------------------------------

void Receiver::open(std::int64_t session) {
  session_ = session;
  armed_ = false;
  command_ = {.session = session, .challenge = challenge_};
}

void Receiver::end(SessionEnded::Why why) {
  tables_.clear();
  queues_.clear();
  armed_queue_.reset();
  challenge_ = draw_challenge();
  // The answer to a stop is still due; nothing else may take effect any more.
  const bool undecided =
      command_.reply.command != 0 && command_.reply.outcome == wire::Outcome::pending;
  if (undecided && command_.kind != Record::Kind::stop)
    settle(command_, {wire::Refusal::session_ended, {}});
  ended_.push_back(session_);
  if (ended_.size() > remembered_sessions) ended_.pop_front();
  events_.emplace_back(SessionEnded{session_, why});
  session_ = 0;
  armed_ = false;
  holds_ = false;
}

void Receiver::expire(Nanos now) {
  const Nanos patience = holds_ ? options_.hold_timeout : options_.session_timeout;
  if (session_ != 0 && now - heard_ > patience) end(SessionEnded::Why::silent);
}

}  // namespace jounce
