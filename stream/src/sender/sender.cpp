// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/sender.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/wire.hpp"

#include "stream/src/sender/reasons.hpp"

namespace jounce {
namespace {

/// The knots [from, to) of all existing columns.
std::array<std::span<const double>, 4> rows_of(const Columns& columns, std::size_t from,
                                               std::size_t to) {
  std::array<std::span<const double>, 4> rows{columns.x, columns.p, columns.v, columns.a};
  for (auto& column : rows)
    if (!column.empty()) column = column.subspan(from, to - from);
  return rows;
}

}  // namespace

Sender::Sender(StreamPlan plan, std::int64_t session, SenderOptions options)
    : plan_(std::move(plan)), session_(session), options_(options) {
  assert(session > 0);
  require_valid(plan_);
  legs_ = legs_of(plan_);
  outcome_.remark = plan_.remark;
  const std::uint32_t window = options_.pace.window;
  if (window < 1 || window > 64)
    throw InputError("window", std::to_string(window), "must be 1 to 64");
  const std::uint32_t chunk = options_.pace.chunk;
  if (chunk < 4 || chunk > wire::chunk_values) {
    throw InputError("chunk", std::to_string(chunk),
                     "must be 4 to " + std::to_string(wire::chunk_values));
  }
  announce_all();
}

/// A table that fits a window is hashed in advance: this does not delay it, and it is not sent at
/// all if the executor has it.
void Sender::announce_all() {
  for (std::size_t i = 0; i < plan_.tables.size(); ++i) {
    const StreamPlan::Item& item = plan_.tables[i];
    wire::Header header = header_of(item, i, options_.pace.chunk);
    if (!header.has_hash() && header.chunks <= wire::cut(header).chunks_for(options_.pace.window))
      header.hash = content_hash(item.table, item.units);
    static_cast<void>(wire::encode({plan_.executor, session_, header}));  // throws if invalid
    outcome_.progress.chunks += header.chunks;
    headers_.push_back(std::move(header));
  }
}

// ---- output ------------------------------------------------------------------------------------

std::vector<wire::Message> Sender::poll(Nanos now) {
  if (!std::exchange(begun_, true)) heard_ = progressed_ = now;
  if (!ended()) check_patience(now);
  if (stage() == StreamStage::downloading) {
    download(now);
  } else if (!ended()) {
    command(now);
  } else {
    for (wire::Body& body : farewell_.due(now, options_.repeat)) send(std::move(body), now);
  }
  return std::exchange(outgoing_, {});
}

void Sender::send(wire::Body body, Nanos now) {
  outgoing_.push_back({plan_.executor, session_, std::move(body), challenge_});
  sent_ = now;
}

void Sender::download(Nanos now) {
  const wire::Header& header = headers_[table_];
  const bool arrived = window_ && window_->arrived() == header.chunks;
  while (arrived && hash()) continue;
  if (window_) {
    for (const std::uint32_t seq : window_->due(now))
      send(chunk_of(plan_.tables[table_].table, header, seq), now);
    count();
  }
  // A header repeated during chunks requests an ack and keeps the session alive.
  const bool quiet = now - sent_ >= options_.heartbeat;
  // It is repeated sooner until it is answered, and once only its hash can be missing.
  const bool awaited = !window_ || arrived;
  const bool again = awaited && (!header_sent_ || now - *header_sent_ >= options_.repeat);
  const bool news = header.has_hash() && header_sent_ && !told_;
  if (!quiet && !again && !news) return;
  send(header, now);
  header_sent_ = now;
  told_ = header.has_hash();
}

bool Sender::hash() {
  if (stage() != StreamStage::downloading || headers_[table_].has_hash()) return false;
  wire::Header& header = headers_[table_];
  const auto& [table, units, known] = plan_.tables[table_];
  if (!hashing_ || hashing_->table != table_) hashing_.emplace(Hashing{.table = table_});
  const std::size_t from = hashing_->knots;
  const std::size_t to = std::min<std::size_t>(from + header.per_chunk, table.size());
  hashing_->hasher.add(rows_of(table.columns(), from, to));
  hashing_->knots = to;
  if (to < table.size()) return true;
  header.hash =
      hashing_->hasher.result(header.axis, header.rule, header.outside, units, table.size());
  hashing_.reset();
  return true;
}

void Sender::command(Nanos now) {
  if (command_.empty() && now - sent_ >= options_.heartbeat) command_.issue(wire::Heartbeat{});
  if (auto body = command_.due(now, options_.repeat)) send(*std::move(body), now);
}

void Sender::check_patience(Nanos now) {
  const bool silent = now - heard_ > options_.patience;
  const bool late = command_.is_older(now, options_.command_patience);
  if (stage() == StreamStage::releasing && (silent || late)) {
    outcome_.reason = "the executor did not confirm the release";
    return enter(StreamStage::released);
  }
  if (silent) {
    fail(boots_.empty() ? StreamError::no_answer : StreamError::contact_lost,
         "no answer from " + plan_.executor + " for " +
             stream_detail::milliseconds(options_.patience));
  } else if (late) {
    fail(StreamError::command_timeout, "the executor did not accept or reject the command within " +
                                           stream_detail::milliseconds(options_.command_patience));
  } else if (stage() == StreamStage::downloading &&
             now - progressed_ > options_.progress_patience) {
    fail(StreamError::stalled, "the executor has confirmed no part of the table for " +
                                   stream_detail::milliseconds(options_.progress_patience));
  }
}

// ---- input -------------------------------------------------------------------------------------

void Sender::receive(const wire::Message& message, Nanos now) {
  if (message.executor != plan_.executor || message.session != session_) return;
  if (ended()) {
    if (const auto* const reply = std::get_if<wire::Reply>(&message.body)) farewell_.take(*reply);
    return;
  }
  const std::int64_t issued = message.challenge;
  std::visit([&](const auto& body) { take(body, issued, now); }, message.body);
}

/// Records a message from the executor; returns true if it comes from its present boot. A new boot
/// means that the executor has lost its state: a download begins again, any later stage fails.
bool Sender::accept(std::int64_t boot, Nanos now) {
  const bool known = std::find(boots_.begin(), boots_.end(), boot) != boots_.end();
  if (known && boots_.back() != boot) return false;  // from before its restart
  heard_ = now;
  if (known) return true;
  boots_.push_back(boot);
  if (boots_.size() == 1) return true;
  if (stage() != StreamStage::downloading) {
    fail(StreamError::restarted, "the executor has restarted");
    return false;
  }
  if (window_) resent_before_ += window_->resent();
  window_.reset();
  table_ = 0;
  arrived_before_ = 0;
  header_sent_.reset();
  count();
  return false;
}

void Sender::take(const wire::Ack& ack, std::int64_t challenge, Nanos now) {
  if (!accept(ack.boot, now) || stage() != StreamStage::downloading || ack.table != table_) return;
  // A chunk has overtaken its header, or the session is lost: the header opens it again.
  if (ack.refusal == wire::Refusal::unknown_session) return window_.reset();
  if (ack.refusal == wire::Refusal::stale_challenge) return begin_anew(challenge);
  if (ack.refusal == wire::Refusal::out_of_memory && asks_by_name(now)) return;
  if (ack.refusal != wire::Refusal::none) return refused(ack.refusal, ack.reason);
  if (ack.complete && headers_[table_].has_hash()) return next_table(now);
  if (!window_) {
    Pace pace = options_.pace;
    pace.window = wire::cut(headers_[table_]).chunks_for(pace.window);
    window_.emplace(headers_[table_].chunks, pace);
    progressed_ = now;
  }
  if (window_->acknowledge(ack, now)) progressed_ = now;
  count();
}

/// There is no space for a table announced without its hash. The executor may already have it, in
/// play, or twice in this plan. Sends the hash, and ignores answers to earlier messages.
bool Sender::asks_by_name(Nanos now) {
  if (!headers_[table_].has_hash()) {
    while (hash()) continue;
    header_sent_.reset();
    named_ = now;
  }
  return named_ && now - *named_ < options_.patience / 4;
}

/// Discards everything sent before the executor sent its challenge.
void Sender::begin_anew(std::int64_t challenge) {
  if (challenge == challenge_) return;  // already set
  challenge_ = challenge;
  window_.reset();
  header_sent_.reset();
  count();
}

void Sender::next_table(Nanos now) {
  if (window_) resent_before_ += window_->resent();
  window_.reset();
  arrived_before_ += headers_[table_].chunks;
  header_sent_.reset();
  named_.reset();
  progressed_ = now;
  ++table_;
  count();
  if (table_ < headers_.size()) return;
  outcome_.downloaded = true;
  pursue();
}

void Sender::count() {
  outcome_.progress.arrived = arrived_before_ + (window_ ? window_->arrived() : 0);
  outcome_.progress.resent = resent_before_ + (window_ ? window_->resent() : 0);
}

void Sender::take(const wire::Reply& reply, std::int64_t /*challenge*/, Nanos now) {
  if (!accept(reply.boot, now) || !command_.is_answered_by(reply)) return;
  if (reply.outcome == wire::Outcome::refused) {
    refused(reply.refusal, reply.reason, reply.cause);
  } else if (reply.outcome == wire::Outcome::accepted) {
    if (stage() == StreamStage::starting) {
      start_ = reply.command;
      outcome_.progress.note = reply.reason;
    }
    accepted();
  }
}

void Sender::accepted() {
  command_.clear();
  switch (stage()) {
    case StreamStage::arming:
      outcome_.armed = leg_armed_ = true;
      break;
    case StreamStage::starting:
      if (plan_.await && leg_ + 1 == legs_.size()) return enter(StreamStage::waiting);
      outcome_.swaps = leg_;
      outcome_.started = true;
      leg_armed_ = false;
      due_.reset();
      over_.reset();
      waited_ = false;
      if (++leg_ < legs_.size()) return enter(StreamStage::swapping);
      break;
    case StreamStage::stopping:
      outcome_.stopped = true;
      break;
    case StreamStage::releasing:
      return enter(StreamStage::released);
    default:
      return;
  }
  pursue();
}

void Sender::refused(wire::Refusal refusal, const std::string& reason, std::int32_t cause) {
  command_.clear();
  if (stage() == StreamStage::releasing) return enter(StreamStage::released);  // already released
  outcome_.refusal = refusal;
  outcome_.cause = cause;
  const bool begun = outcome_.started || stage() == StreamStage::waiting;
  if (refusal == wire::Refusal::session_ended && begun)
    return fail(StreamError::stopped, stream_detail::session_ended_by(reason));
  const std::string swap = leg_ == 0 ? ""
                                     : " This concerns the table of swap " + std::to_string(leg_) +
                                           "; the motion before it is played to its end.";
  fail(StreamError::refused,
       std::string(name(refusal)) + (reason.empty() ? "" : ": ") + reason + swap);
}

// ---- next goal ----------------------------------------------------------------------------------

wire::Arm Sender::arm_of(const SwapPlan& leg) const {
  return {.mode = leg.mode,
          .slave = headers_[leg.slave].hash,
          .master = leg.mode == wire::ArmMode::follow_table ? headers_[leg.master].hash : Sha256{},
          .coupling = leg.coupling,
          .end = leg.mode == wire::ArmMode::follow_input ? leg.end : CamEnd::brake};
}

void Sender::pursue() {
  const bool more = !given_up_ && leg_ < legs_.size();
  if (more && plan_.goal >= StreamGoal::arm && !leg_armed_) {
    enter(StreamStage::arming);
    command_.issue(arm_of(legs_[leg_]));
  } else if (more && plan_.goal >= StreamGoal::start) {
    const SwapPlan& leg = legs_[leg_];
    enter(StreamStage::starting);
    command_.issue(wire::Start{.tick = leg.when == StartAt::tick ? plan_.start_tick : -1,
                               .when = leg.when,
                               .position = leg.position});
  } else {
    enter(StreamStage::holding);
  }
}

/// A swap has taken place when its table is the active one and nothing waits. A status may be late:
/// if the table is the same as before, this state must have lasted for a while.
void Sender::take(const wire::Status& status, std::int64_t /*challenge*/, Nanos now) {
  constexpr Nanos a_while = std::chrono::milliseconds(500);
  outcome_.fault = status.last_error;
  if (stage() == StreamStage::waiting) return await_start(status);
  if (stage() != StreamStage::swapping) return;
  waited_ |= status.next == wire::Next::waiting;
  const Sha256& hash = headers_[legs_[leg_ - 1].slave].hash;
  const bool there = status.next == wire::Next::nothing &&
                     std::equal(status.table.begin(), status.table.end(), hash.begin());
  const bool stands = status.state == State::disabled || status.state == State::standstill ||
                      status.state == State::error_stop;
  if (there || !stands || status.next != wire::Next::nothing) {
    over_.reset();
  } else if (now - over_.value_or(now) >= a_while) {
    return be_over(status);
  } else if (!over_) {
    over_ = now;
  }
  if (!there) return due_.reset();
  if (!due_) due_ = now;
  const bool new_table = leg_ < 2 || headers_[legs_[leg_ - 2].slave].hash != hash;
  if (waited_ || new_table || now - *due_ >= a_while) pursue();
}

/// Outcome of the last start: the axis reports it as long as the session lives.
void Sender::await_start(const wire::Status& status) {
  if (status.start_command != start_) return;  // older than the start
  if (status.start == wire::StartOutcome::begun) {
    outcome_.swaps = leg_;
    outcome_.started = true;
    leg_armed_ = false;
    ++leg_;
    pursue();
  } else if (status.start == wire::StartOutcome::dropped) {
    outcome_.cause = status.start_cause;
    fail(StreamError::dropped, status.start_reason);
  }
}

/// The axis is at rest and waits for nothing: the start has ended unseen, or will never take place.
void Sender::be_over(const wire::Status& status) {
  outcome_.cause = status.last_error != 0 ? status.last_error : status.reason;
  if (outcome_.cause == 0) return pursue();
  fail(StreamError::stopped, stream_detail::at_rest_reason("the swap", outcome_.cause));
}

void Sender::raise(StreamGoal goal) {
  if (ended() || goal <= plan_.goal) return;
  plan_.goal = goal;
  require_valid(plan_);
  if (stage() == StreamStage::holding) pursue();
}

void Sender::start_at(std::int64_t tick) {
  plan_.start_tick = tick;
  raise(StreamGoal::start);
}

void Sender::stop(wire::StopMode mode) {
  if (ended()) return;
  given_up_ = true;
  if (stage() == StreamStage::downloading) return release();
  enter(StreamStage::stopping);
  command_.issue(wire::Stop{.mode = mode});
}

void Sender::release() {
  if (ended()) return;
  if (boots_.empty()) return enter(StreamStage::released);
  enter(StreamStage::releasing);
  command_.issue(wire::Heartbeat{.release = true});
}

void Sender::fail(StreamError error, std::string reason) {
  if (ended()) return;
  // A waiting start is not canceled: a stop would also end the present motion. A stop by another
  // operator has canceled it.
  const bool canceled = error == StreamError::dropped || error == StreamError::stopped;
  if (stage() == StreamStage::waiting && !canceled)
    reason += "; the accepted start still waits in the axis: a stop cancels it";
  outcome_.error = error;
  outcome_.reason = std::move(reason);
  // The outcome of an unanswered start is unknown: a possible motion is stopped.
  const auto& last = command_.body();
  const bool perhaps_started = last && std::holds_alternative<wire::Start>(*last);
  if (!boots_.empty()) farewell_.begin(command_.number(), perhaps_started);
  enter(StreamStage::failed);
}

const char* name(StreamError error) {
  constexpr const char* names[] = {
      "none",      "no_answer", "contact_lost", "stalled", "command_timeout", "out_of_time",
      "restarted", "refused",   "underrun",     "stopped", "dropped"};
  return names[static_cast<std::size_t>(error)];
}

const char* name(StreamStage stage) {
  constexpr const char* names[] = {"downloading", "arming",  "starting",  "stopping", "swapping",
                                   "waiting",     "holding", "releasing", "released", "failed"};
  return names[static_cast<std::size_t>(stage)];
}

}  // namespace jounce
