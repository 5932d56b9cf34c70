// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/receiver_impl.hpp"

#include <cassert>
#include <type_traits>
#include <utility>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/wire.hpp"

namespace jounce {
namespace {

constexpr std::size_t most_answers = 64;  // between two polls, for messages of unknown senders

/// True if it is addressed to an executor; messages from executors and masters are not.
bool is_command(const wire::Body& body) {
  const wire::Lane lane = wire::lane(body);
  return lane == wire::Lane::table || lane == wire::Lane::command;
}

/// The reason why a session ended, for its program; "" for its own release.
std::string reason_of(SessionEnded::Why why) {
  switch (why) {
    case SessionEnded::Why::operator_stop:
      return "another operator stopped the axis";
    case SessionEnded::Why::silent:
      return "no heartbeat of this program arrived in time, so the executor ended its session";
    case SessionEnded::Why::released:
      break;
  }
  return "";
}

ReceiverOptions checked(ReceiverOptions options) {
  if (!wire::is_executor_name(options.executor))
    throw InputError("executor", options.executor, wire::executor_name_rule);
  if (options.credit < 1 || options.credit > 64)
    throw InputError("credit", std::to_string(options.credit), "must be 1 to 64");
  return options;
}

}  // namespace

Receiver::Impl::Impl(ReceiverOptions options, std::int64_t boot)
    : options_(checked(std::move(options))),
      boot_(boot),
      challenges_(boot),
      session_({options_.session_timeout, options_.hold_timeout}),
      tables_({options_.most_knots, options_.memory, options_.credit}),
      queues_({options_.most_rows, options_.most_queues, options_.credit}),
      command_(boot),
      operator_(boot) {
  assert(boot > 0);
}

void Receiver::Impl::receive(const wire::Message& message, Nanos now) {
  if (message.executor != options_.executor || !is_command(message.body)) return;
  if (message.session == 0) return receive_operators(message);
  if (message.session != session_.id()) expire(now);
  const std::int32_t number = command_number(message.body);
  if (session_.is_of_last_owner(message) && number != 0 && number == command_.number())
    return command_.repeat();
  if (Refused refused = session_.bars(message, challenges_.session()))
    return answer_barred(message, std::move(refused));
  if (session_.is_free() && opens_session(message.body)) open(message.session);
  const bool is_news = command_.is_news(number);
  const std::size_t before = events_.size();
  std::visit([&](const auto& body) { take(body); }, message.body);
  const bool has_rows =
      std::holds_alternative<wire::Rows>(message.body) && events_.size() != before;
  if (message.session == session_.id() && (is_news || has_rows)) session_.receive(now);
}

void Receiver::Impl::answer_barred(const wire::Message& message, Refused refused) {
  const auto answer = [&](const auto& body) {
    using Body = std::decay_t<decltype(body)>;
    if constexpr (requires { body.table; } && !std::is_same_v<Body, wire::Status>)
      refuse_table(message.session, body.table, std::move(refused));
    else if constexpr (std::is_same_v<Body, wire::Queue> || std::is_same_v<Body, wire::Rows>)
      refuse_queue_of(message.session, body.queue, std::move(refused));
    else
      refuse_command(message.session, command_number(message.body), std::move(refused));
  };
  std::visit(answer, message.body);
}

std::vector<wire::Message> Receiver::Impl::poll(Nanos now) {
  expire(now);
  return answers();
}

std::vector<wire::Message> Receiver::Impl::answers() {
  for (wire::Ack& ack : tables_.acks(boot_)) send(session_.id(), std::move(ack));
  for (wire::QueueAck& ack : queues_.acks(boot_)) send(session_.id(), std::move(ack));
  if (auto reply = command_.take_reply()) send(session_.owner(), std::move(*reply));
  if (auto reply = operator_.take_reply()) send(0, std::move(*reply));
  return std::exchange(outgoing_, {});
}

std::optional<StreamEvent> Receiver::Impl::take_event() {
  if (events_.empty()) return std::nullopt;
  StreamEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

wire::Message Receiver::Impl::status(const wire::Status& status) const {
  return {options_.executor, session_.id(), status, challenges_.session()};
}

void Receiver::Impl::send(std::int64_t session, wire::Body body) {
  const std::int64_t challenge = session == 0 ? challenges_.operators() : challenges_.session();
  outgoing_.push_back({options_.executor, session, std::move(body), challenge});
}

/// Answers any sender, up to a bound.
void Receiver::Impl::answer_stranger(std::int64_t session, wire::Body body) {
  if (outgoing_.size() < most_answers) send(session, std::move(body));
}

void Receiver::Impl::refuse_table(std::int64_t session, std::uint32_t table, Refused refused) {
  answer_stranger(session, wire::Ack{.boot = boot_,
                                     .table = table,
                                     .refusal = refused.refusal,
                                     .reason = std::move(refused.reason)});
}

void Receiver::Impl::refuse_queue_of(std::int64_t session, std::uint32_t queue, Refused refused) {
  answer_stranger(session, wire::QueueAck{.boot = boot_,
                                          .queue = queue,
                                          .refusal = refused.refusal,
                                          .reason = std::move(refused.reason)});
}

void Receiver::Impl::refuse_command(std::int64_t session, std::int32_t command, Refused refused) {
  answer_stranger(session, wire::Reply{.boot = boot_,
                                       .command = command,
                                       .outcome = wire::Outcome::refused,
                                       .refusal = refused.refusal,
                                       .cause = refused.cause,
                                       .reason = std::move(refused.reason)});
}

// ---- sessions -----------------------------------------------------------------------------------

void Receiver::Impl::open(std::int64_t session) {
  session_.open(session, challenges_.session());
  armed_ = false;
  command_.clear();
}

void Receiver::Impl::end(SessionEnded::Why why) {
  tables_.clear();
  queues_.clear();
  armed_ = false;
  armed_queue_.reset();
  challenges_.renew_session();
  const Cause cause = why == SessionEnded::Why::operator_stop ? Cause::stopped : Cause::none;
  // The answer to a stop is still due; nothing else may take effect any more.
  if (command_.waits(command_.number()) && command_.kind() != LastCommand::Kind::stop)
    command_.settle(
        {wire::Refusal::session_ended, reason_of(why), static_cast<std::int32_t>(cause)});
  events_.emplace_back(SessionEnded{session_.id(), why});
  session_.end(reason_of(why), cause);
}

void Receiver::Impl::expire(Nanos now) {
  if (session_.is_silent(now)) end(SessionEnded::Why::silent);
}

// ---- tables and queues --------------------------------------------------------------------------

void Receiver::Impl::take_table(std::uint32_t table, Refused refused) {
  if (refused) refuse_table(session_.id(), table, std::move(refused));
  if (auto ready = tables_.take_ready()) events_.emplace_back(TableReady{session_.id(), *ready});
}

void Receiver::Impl::take(const wire::Queue& queue) {
  if (Refused refused = queues_.add(queue))
    refuse_queue_of(session_.id(), queue.queue, std::move(refused));
  if (auto opened = queues_.take_opened())
    events_.emplace_back(QueueOpened{session_.id(), std::move(*opened)});
}

void Receiver::Impl::take(const wire::Rows& rows) {
  queues_.add(rows);
  for (wire::Rows& ready : queues_.take_rows())
    events_.emplace_back(RowsArrived{session_.id(), std::move(ready)});
}

void Receiver::Impl::level(std::uint32_t queue, const QueueLevel& level) {
  queues_.level(queue, level);
}

void Receiver::Impl::refuse_queue(std::uint32_t queue, wire::Refusal refusal, std::string reason) {
  queues_.refuse(queue, {refusal, std::move(reason)});
}

void Receiver::Impl::refuse_row(std::uint32_t queue, std::uint64_t row, std::string reason) {
  queues_.refuse(queue, {wire::Refusal::bad_row, std::move(reason)},
                 static_cast<std::int64_t>(row));
}

}  // namespace jounce
