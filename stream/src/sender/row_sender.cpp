// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/row_sender.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/wire.hpp"

#include "stream/src/sender/reasons.hpp"

namespace jounce {
namespace {

void require_valid(const RowPlan& plan, std::int64_t session) {
  if (const std::string rule = contradiction(plan.queue); !rule.empty())
    throw InputError("queue", std::to_string(plan.queue.queue), rule);
  if (plan.queue.mode != wire::QueueMode::dynamic)
    throw InputError("queue", "static", "must be dynamic: use StaticQueue for a static queue");
  if (plan.queue.axis == Domain::time && plan.queue.units.x != "s")
    throw InputError("unit of x", plan.queue.units.x, "must be s over time");
  if (plan.start_tick < -1)
    throw InputError("start_tick", std::to_string(plan.start_tick), "must be -1 or more");
  if (!plan.rows) throw InputError("rows", "", "must have a source");
  static_cast<void>(wire::encode({plan.executor, session, plan.queue}));  // throws if invalid
}

}  // namespace

RowSender::RowSender(RowPlan plan, std::int64_t session, SenderOptions options)
    : plan_(std::move(plan)),
      session_(session),
      options_(options),
      window_(plan_.queue, 0, options.pace) {
  assert(session > 0);
  require_valid(plan_, session);
}

// ---- output ------------------------------------------------------------------------------------

std::vector<wire::Message> RowSender::poll(Nanos now) {
  if (!std::exchange(begun_, true)) heard_ = progressed_ = now, asked_ = now - options_.repeat;
  check_patience(now);
  if (ended()) {
    for (wire::Body& body : farewell_.due(now, options_.repeat)) send(std::move(body), now);
    return std::exchange(outgoing_, {});
  }
  fill(now);
  go_on();
  // A repeated queue message requests an ack, and keeps the session alive until it is armed.
  const Nanos pause = stage_ == Stage::opening ? options_.repeat : options_.heartbeat;
  if (stage_ < Stage::stopping && now - asked_ >= pause) {
    asked_ = now;
    send(plan_.queue, now);
    if (stage_ == Stage::playing && command_.empty()) command_.issue(wire::Heartbeat{});
  }
  if (stage_ < Stage::stopping)
    for (wire::Rows& rows : window_.due(now)) send(std::move(rows), now);
  if (auto body = command_.due(now, options_.repeat)) send(*std::move(body), now);
  return std::exchange(outgoing_, {});
}

void RowSender::send(wire::Body body, Nanos /*now*/) {
  outgoing_.push_back({plan_.executor, session_, std::move(body), challenge_});
}

/// Takes rows from the source as space permits.
void RowSender::fill(Nanos now) {
  if (!waits_for_rows()) progressed_ = now;
  if (stage_ == Stage::opening || stage_ >= Stage::stopping) return;
  while (!exhausted_ && window_.wants() > 0) {
    auto rows = plan_.rows(std::min(window_.wants(), wire::rows_each));
    if (rows.empty()) break;
    exhausted_ = rows.back().last;
    outcome_.progress.sent += rows.size();
    window_.push(std::move(rows));
    progressed_ = now;
  }
  outcome_.progress.messages = window_.sent();
  outcome_.progress.resent = window_.resent();
}

/// True if enough rows have arrived to begin or to continue.
bool RowSender::is_filled() const {
  const std::uint64_t more = window_.acknowledged() - starved_at_;
  return outcome_.progress.all || more >= plan_.queue.prefill;
}

/// True if no motion takes place until more rows arrive.
bool RowSender::waits_for_rows() const {
  return stage_ == Stage::filling || (stage_ == Stage::playing && starving_);
}

void RowSender::go_on() {
  if (stage_ == Stage::filling && is_filled())
    enter(Stage::arming, wire::Arm{.mode = wire::ArmMode::queue, .queue = plan_.queue.queue});
  else if (stage_ == Stage::playing && starving_ && is_filled())
    enter(Stage::resetting, wire::message_of(command::Reset{}));
  else if (stage_ == Stage::playing && outcome_.progress.finished)
    enter(Stage::releasing, wire::Heartbeat{.release = true});
}

void RowSender::enter(Stage stage, wire::Body command) {
  stage_ = stage;
  command_.issue(std::move(command));
}

/// True if a motion is in progress or possible: it must not run dry.
bool RowSender::may_move() const {
  return outcome_.progress.started || stage_ == Stage::starting ||
         (command_.body() && std::holds_alternative<wire::Start>(*command_.body()));
}

void RowSender::check_patience(Nanos now) {
  if (ended()) return;
  const bool silent = now - heard_ > options_.patience;
  const bool late = command_.is_older(now, options_.command_patience);
  if (stage_ == Stage::releasing && (silent || late)) {
    outcome_.reason = "the executor did not confirm the release";
    stage_ = Stage::ended;
  } else if (silent) {
    fail(boot_ == 0 ? StreamError::no_answer : StreamError::contact_lost,
         "no answer from " + plan_.executor);
  } else if (late) {
    fail(StreamError::command_timeout,
         "the executor received the command, but the axis did not accept or reject it in time");
  } else if (waits_for_rows() && now - progressed_ > options_.progress_patience) {
    fail(starving_ ? StreamError::underrun : StreamError::stalled,
         "the source returned no more rows, but the axis waits for rows");
  }
}

// ---- input -------------------------------------------------------------------------------------

void RowSender::receive(const wire::Message& message, Nanos now) {
  if (message.executor != plan_.executor || message.session != session_) return;
  if (ended()) {
    if (const auto* const reply = std::get_if<wire::Reply>(&message.body)) farewell_.take(*reply);
    return;
  }
  const std::int64_t issued = message.challenge;
  std::visit([&](const auto& body) { take(body, issued, now); }, message.body);
}

/// A restart of the executor ends a rolling stream: the number of played rows is unknown.
bool RowSender::accept(std::int64_t boot, Nanos now) {
  if (boot_ != 0 && boot != boot_ && stage_ != Stage::opening) {
    fail(StreamError::restarted, "the executor has restarted");
    farewell_ = {};
    return false;
  }
  boot_ = boot;
  heard_ = now;
  return true;
}

void RowSender::take(const wire::QueueAck& ack, std::int64_t challenge, Nanos now) {
  if (ack.queue != plan_.queue.queue || !accept(ack.boot, now)) return;
  if (ack.refusal == wire::Refusal::stale_challenge) {
    if (challenge == challenge_) return;  // sent before the challenge arrived: late
    if (stage_ == Stage::opening) {
      challenge_ = challenge;
      asked_ = now - options_.repeat;
      return;
    }
  }
  if (ack.refusal != wire::Refusal::none) return refused(ack.refusal, ack.reason, 0);
  if (stage_ == Stage::opening) stage_ = Stage::filling;
  window_.acknowledge(ack);
  watch(ack);
}

/// Evaluates the state of the motion in an ack.
void RowSender::watch(const wire::QueueAck& ack) {
  RowProgress& progress = outcome_.progress;
  progress.acknowledged = window_.acknowledged();
  progress.played = std::max(progress.played, static_cast<std::uint64_t>(ack.played));
  progress.all = exhausted_ && window_.idle();
  if (!progress.started || stage_ >= Stage::stopping) return;
  if (ack.progress == wire::Progress::done) progress.finished = true;
  if (ack.progress == wire::Progress::broken)
    return fail(StreamError::stopped, "the axis was stopped; it plays no more rows");
  if (ack.progress != wire::Progress::starving || starving_) return;
  ++progress.underruns;
  if (!plan_.resume) {
    fail(StreamError::underrun,
         "buffer underrun: rows arrived too slowly, and the axis stopped on its path");
    return;
  }
  starving_ = true;
  starved_at_ = progress.acknowledged;
}

void RowSender::take(const wire::Reply& reply, std::int64_t /*challenge*/, Nanos now) {
  if (!accept(reply.boot, now) || !command_.is_answered_by(reply)) return;
  if (reply.outcome == wire::Outcome::refused)
    refused(reply.refusal, reply.reason, reply.cause);
  else if (reply.outcome == wire::Outcome::accepted)
    accepted();
}

void RowSender::accepted() {
  command_.clear();
  switch (stage_) {
    case Stage::arming:
      return enter(Stage::starting, wire::Start{.tick = plan_.start_tick});
    case Stage::starting:
      outcome_.progress.started = true;
      stage_ = Stage::playing;
      return;
    case Stage::resetting:
      return enter(Stage::resuming, wire::message_of(command::Resume{}));
    case Stage::resuming:
      starving_ = false;
      stage_ = Stage::playing;
      return;
    case Stage::stopping:
      return enter(Stage::releasing, wire::Heartbeat{.release = true});
    case Stage::releasing:
      stage_ = Stage::ended;
      return;
    default:
      return;
  }
}

void RowSender::refused(wire::Refusal refusal, const std::string& reason, std::int32_t cause) {
  command_.clear();
  if (stage_ == Stage::releasing) {  // already released
    stage_ = Stage::ended;
    return;
  }
  outcome_.refusal = refusal;
  outcome_.cause = cause;
  if (refusal == wire::Refusal::session_ended && outcome_.progress.started)
    return fail(StreamError::stopped, stream_detail::session_ended_by(reason));
  fail(StreamError::refused, std::string(name(refusal)) + (reason.empty() ? "" : ": ") + reason);
}

void RowSender::stop(wire::StopMode mode) {
  if (stage_ >= Stage::stopping) return;
  if (boot_ == 0) {
    stage_ = Stage::ended;
    return;
  }
  enter(Stage::stopping, wire::Stop{.mode = mode});
}

void RowSender::fail(StreamError error, std::string reason) {
  if (ended()) return;
  outcome_.error = error;
  outcome_.reason = std::move(reason);
  if (boot_ != 0) farewell_.begin(command_.number(), may_move());
  stage_ = Stage::ended;
}

}  // namespace jounce
