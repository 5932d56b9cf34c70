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

/// True if the end of this session has stopped the axis, or may have stopped it: the executor no
/// longer has the reason.
bool has_stopped(const CallOutcome& over) {
  return over.refusal != wire::Refusal::session_ended ||
         over.cause == static_cast<std::int32_t>(Cause::stopped);
}

/// True if a motion that ended for this cause was not cut short.
bool is_end(Cause cause) {
  switch (cause) {
    case Cause::none:
    case Cause::end_velocity:
    case Cause::pass_ended:
    case Cause::replaced:
    case Cause::released:
    case Cause::range_end:
    case Cause::reach_end:
    case Cause::singular_end:
      return true;
    default:
      return false;
  }
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
  CallOutcome outcome{StreamError::refused, wire::Refusal::session_ended};
  if (session_ != 0) outcome = ask(body, patience);
  if (outcome.error == StreamError::refused && is_over(outcome.refusal)) {
    if (session_ != 0 && has_stopped(outcome)) return ended(outcome);
    if (CallOutcome opened = open(patience); !opened.ok()) return opened;
    outcome = ask(body, patience);
  }
  if (outcome.ok() && std::holds_alternative<wire::Start>(body)) awaits_end_ = true;
  if (outcome.ok() && std::holds_alternative<wire::Stop>(body)) awaits_end_ = false;
  return outcome;
}

/// The session is over: its program must decide whether to continue. The cause is `stopped` if the axis
/// was stopped, too.
CallOutcome Client::ended(const CallOutcome& refused) {
  session_ = 0;
  const bool stopped = has_stopped(refused);
  if (stopped) awaits_end_ = false;
  const std::string code = name(refused.refusal);
  const bool explained =
      refused.refusal == wire::Refusal::session_ended && refused.reason.size() > code.size() + 2;
  return {StreamError::stopped, refused.refusal,
          static_cast<std::int32_t>(stopped ? Cause::stopped : Cause::none),
          explained ? refused.reason.substr(code.size() + 2) : stream_detail::session_ended_reason};
}

CallOutcome Client::keep(Nanos patience) {
  if (session_ == 0) return ended({StreamError::refused, wire::Refusal::session_ended});
  CallOutcome outcome = ask(wire::Heartbeat{}, patience);
  if (outcome.error != StreamError::refused || !is_over(outcome.refusal)) return outcome;
  return ended(outcome);
}

CallOutcome Client::end_of_motion(const wire::Status& status) {
  if (!std::exchange(awaits_end_, false)) return {};
  const std::int32_t number = status.last_error != 0 ? status.last_error : status.reason;
  const auto why = static_cast<Cause>(number);
  if (is_end(why)) return {};
  return {StreamError::stopped, wire::Refusal::none, number,
          "the motion ended early, at " + stream_detail::place_of(status) + ": " + name(why) +
              ": " + meaning(why),
          status.last_error};
}

CallOutcome Client::command(const ClientCommand& command, std::int64_t at) {
  if (const std::string rule = contradiction(command); !rule.empty())
    throw InputError(name(kind_of(command)), "", rule);
  if (at < -1) throw InputError("at", std::to_string(at), "must be -1 or more");
  CallOutcome outcome = request(wire::message_of(command, at));
  if (outcome.ok() && info(kind_of(command)).moves) awaits_end_ = true;
  if (outcome.ok() && kind_of(command) == CommandKind::halt) awaits_end_ = false;
  return outcome;
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
