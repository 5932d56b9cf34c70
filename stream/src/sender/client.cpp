// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/client.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "jounce/command/command_values.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/detail/ask.hpp"

#include "stream/src/sender/reasons.hpp"

namespace jounce {
namespace {

/// True if the executor no longer has this session, and has therefore done nothing.
bool is_over(wire::Refusal refusal) {
  return refusal == wire::Refusal::unknown_session || refusal == wire::Refusal::session_ended ||
         refusal == wire::Refusal::stale_challenge;
}

CallOutcome refused(const wire::Reply& reply) {
  const std::string why = reply.reason.empty() ? "" : ": " + reply.reason;
  return {StreamError::refused, reply.refusal, reply.cause, name(reply.refusal) + why};
}

}  // namespace

Client::Client(Transport& link, std::string executor, ClientOptions options, Clock clock)
    : link_(link),
      executor_(std::move(executor)),
      options_(std::move(options)),
      clock_(std::move(clock)),
      slot_(std::make_unique<CommandSlot>()),
      exceptions_(std::uncaught_exceptions()) {
  if (!wire::is_executor_name(executor_))
    throw InputError("executor", executor_, wire::executor_name_rule);
  link_.subscribe(wire::channel(executor_, wire::Lane::reply), 64);
}

Client::~Client() {
  if (session_ == 0 || std::uncaught_exceptions() > exceptions_) return;
  constexpr Nanos patience = std::chrono::milliseconds(200);
  options_.patience = std::min(options_.patience, patience);
  try {
    static_cast<void>(release());
  } catch (const std::exception&) {
    // The link has failed: the session times out.
  }
}

/// Sends one command under the next number, repeated until its outcome.
CallOutcome Client::ask(const wire::Body& body, Nanos patience) {
  wire::Message message{executor_, session_, {}, challenge_};
  slot_->issue(body);
  const auto reply = jounce::ask(link_, message, *slot_,
                                 {.key = options_.key,
                                  .patience = std::min(patience, options_.patience),
                                  .repeat = options_.repeat},
                                 clock_, rejects_);
  challenge_ = message.challenge;
  if (!reply) {
    const bool foreign = rejects_[wire::Reject::not_authentic] > 0;
    return {StreamError::no_answer, wire::Refusal::none, 0,
            "no answer from " + executor_ +
                (foreign ? "; its messages are unsigned, or signed with another key" : "")};
  }
  if (slot_->number() > 1 && reply->boot != boot_) {
    session_ = 0;
    return {StreamError::restarted, wire::Refusal::none, 0,
            "the executor has restarted, and has not executed the command"};
  }
  boot_ = reply->boot;
  if (reply->outcome == wire::Outcome::refused) return refused(*reply);
  if (reply->outcome == wire::Outcome::accepted) return {.reason = reply->reason};
  return {StreamError::command_timeout, wire::Refusal::none, 0,
          "the executor received the command, but the axis did not accept or reject it in time"};
}

void Client::send(wire::Body body) {
  send_message(link_, {executor_, session_, std::move(body), challenge_}, options_.key);
}

/// Returns the next message for this session.
std::optional<wire::Message> Client::receive(Nanos timeout) {
  auto message = next_message(link_, timeout, rejects_, options_.key);
  const bool ours = message && message->executor == executor_ && message->session == session_;
  return ours ? std::move(message) : std::nullopt;
}

CallOutcome Client::open(Nanos patience) {
  session_ = random_id();
  challenge_ = boot_ = 0;
  *slot_ = CommandSlot();
  CallOutcome outcome = ask(wire::Heartbeat{}, patience);
  if (!outcome.ok()) session_ = 0;
  return outcome;
}

/// Uses the present session, or a new one.
CallOutcome Client::request(const wire::Body& body, Nanos patience) {
  if (session_ != 0) {
    CallOutcome outcome = ask(body, patience);
    if (outcome.error != StreamError::refused || !is_over(outcome.refusal)) return outcome;
  }
  if (CallOutcome outcome = open(patience); !outcome.ok()) return outcome;
  return ask(body, patience);
}

CallOutcome Client::keep() {
  if (session_ == 0)
    return {StreamError::stopped, wire::Refusal::session_ended, 0,
            stream_detail::session_ended_reason};
  CallOutcome outcome = ask(wire::Heartbeat{});
  if (outcome.error != StreamError::refused || !is_over(outcome.refusal)) return outcome;
  session_ = 0;
  const std::string code = name(outcome.refusal);
  const bool explained =
      outcome.refusal == wire::Refusal::session_ended && outcome.reason.size() > code.size() + 2;
  return {StreamError::stopped, outcome.refusal, 0,
          explained ? outcome.reason.substr(code.size() + 2) : stream_detail::session_ended_reason};
}

CallOutcome Client::command(const ClientCommand& command, std::int64_t at) {
  if (const std::string rule = contradiction(command); !rule.empty())
    throw InputError(name(kind_of(command)), "", rule);
  if (at < -1) throw InputError("at", std::to_string(at), "must be -1 or more");
  return request(wire::message_of(command, at));
}

CallOutcome Client::release() {
  if (session_ == 0) return {};
  CallOutcome outcome = ask(wire::Heartbeat{.release = true});
  session_ = 0;
  const bool was_over = outcome.error == StreamError::refused && is_over(outcome.refusal);
  return was_over ? CallOutcome{} : outcome;
}

CallOutcome Client::stop(wire::StopMode mode) {
  return request(wire::Stop{.mode = mode});
}

}  // namespace jounce
