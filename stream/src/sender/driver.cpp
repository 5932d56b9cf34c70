// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/driver.hpp"

#include <algorithm>
#include <exception>
#include <utility>
#include <variant>

#include "jounce/stream/detail/ask.hpp"
#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/detail/receiver_pump.hpp"
#include "jounce/stream/detail/row_sender.hpp"
#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/receiver/receiver_options.hpp"

#include "stream/src/sender/outbox.hpp"
#include "stream/src/sender/reasons.hpp"

namespace jounce {

namespace {

/// Calls functions of the caller. After the first exception, it keeps this exception and calls no
/// function again, so that the axis can be stopped first.
class Callbacks {
 public:
  template <class Function, class Result>
  Result call(const Function& function, Result otherwise) {
    if (failure_) return otherwise;
    try {
      return function();
    } catch (...) {
      failure_ = std::current_exception();
      return otherwise;
    }
  }
  template <class Progress, class Value>
  void report(const Progress& progress, const Value& value) {
    if (progress) call([&] { return progress(value), true; }, false);
  }
  /// True if the caller cancels, or a function has thrown.
  bool cancelled(const std::function<bool()>& asked) {
    const bool yes = asked && call(asked, true);
    return yes || failure_ != nullptr;
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
};

}  // namespace

StreamOutcome stream_tables(Transport& link, StreamPlan plan, const StreamOptions& options,
                            const Clock& clock, std::int64_t session) {
  const std::string replies = wire::channel(plan.executor, wire::Lane::reply);
  if (!plan.swaps.empty() || plan.await)
    link.subscribe(wire::channel(plan.executor, wire::Lane::status), queue_capacity);
  Sender sender(std::move(plan), session, options.sender);
  link.subscribe(replies, queue_capacity);
  Rejects rejects;
  Callbacks caller;
  stream_detail::Outbox outbox(link, options.key, clock);
  bool stopped = false;
  for (const Nanos begin = clock();;) {
    if (clock() - begin > options.total)
      sender.fail(StreamError::out_of_time, stream_detail::time_over_reason(options.total));
    for (const auto& message : sender.poll(clock())) outbox.send(message);
    caller.report(options.progress, sender.outcome().progress);
    if (sender.done()) break;

    const Nanos wait = sender.hash() ? Nanos{} : options.period;
    drain(link, wait, options.key, rejects,
          [&](const wire::Message& message) { sender.receive(message, clock()); });
    if (!stopped && caller.cancelled(options.cancelled)) {
      stopped = true;
      sender.stop(wire::StopMode::stop);
    }
    if (sender.at_goal()) sender.release();
  }
  caller.rethrow();
  return sender.outcome();
}

RowOutcome stream_rows(Transport& link, RowPlan plan, const RowOptions& options, const Clock& clock,
                       std::int64_t session) {
  const std::string executor = plan.executor;
  Callbacks caller;
  plan.rows = [&, source = std::move(plan.rows)](std::size_t most) {
    return caller.call([&] { return source(most); }, std::vector<wire::Row>{});
  };
  RowSender sender(std::move(plan), session, options.sender);
  link.subscribe(wire::channel(executor, wire::Lane::reply), queue_capacity);
  Rejects rejects;
  stream_detail::Outbox outbox(link, options.key, clock);
  for (;;) {
    for (const auto& message : sender.poll(clock())) outbox.send(message);
    caller.report(options.progress, sender.outcome().progress);
    if (sender.done()) break;
    drain(link, options.period, options.key, rejects,
          [&](const wire::Message& message) { sender.receive(message, clock()); });
    if (caller.cancelled(options.cancelled)) sender.stop(wire::StopMode::stop);
  }
  caller.rethrow();
  return sender.outcome();
}

wire::Reply operator_command(Transport& link, const std::string& executor, wire::Body body,
                             Nanos patience, const std::optional<wire::Key>& key,
                             const Clock& clock) {
  link.subscribe(wire::channel(executor, wire::Lane::reply), queue_capacity);
  wire::Message message{executor, 0, {}};
  CommandSlot slot(static_cast<std::int32_t>(random_id() & 0x3FFFFFFF));
  slot.issue(std::move(body));
  Rejects rejects;
  const auto reply = ask(link, message, slot, {.key = key, .patience = patience}, clock, rejects);
  return reply.value_or(wire::Reply{});
}

bool operator_stop(Transport& link, const std::string& executor, wire::StopMode mode,
                   Nanos patience, const std::optional<wire::Key>& key, const Clock& clock) {
  const wire::Reply reply =
      operator_command(link, executor, wire::Stop{.mode = mode}, patience, key, clock);
  return reply.outcome == wire::Outcome::accepted;
}

std::optional<wire::Message> next_status(Transport& link, const std::string& executor,
                                         Nanos timeout, const std::optional<wire::Key>& key,
                                         const Clock& clock) {
  link.subscribe(wire::channel(executor, wire::Lane::status), 1);
  Rejects rejects;
  drain(link, Nanos{}, key, rejects, [](const wire::Message& /*old*/) {});
  const Nanos end = clock() + timeout;
  for (Nanos left = timeout; left > Nanos{}; left = end - clock()) {
    auto message = next_message(link, left, rejects, key);
    if (message && message->executor == executor &&
        std::holds_alternative<wire::Status>(message->body))
      return message;
  }
  return std::nullopt;
}

ReceiverPump::ReceiverPump(Transport& link, const std::vector<ReceiverOptions>& options,
                           std::int64_t boot, Clock clock)
    : link_(link), clock_(std::move(clock)) {
  for (const ReceiverOptions& one : options) {
    by_name_.push_back({.name = one.executor,
                        .receiver = &receivers_.emplace_back(one, boot),
                        .half_a_window = one.credit * wire::message_values / 2});
    link_.subscribe(wire::channel(one.executor, wire::Lane::table), queue_capacity);
    link_.subscribe(wire::channel(one.executor, wire::Lane::command), queue_capacity);
  }
  if (!options.empty()) key_ = options.front().key;
  std::sort(by_name_.begin(), by_name_.end(),
            [](const Named& a, const Named& b) { return a.name < b.name; });
}

void ReceiverPump::run(Nanos timeout) {
  drain(link_, timeout, key_, rejects_, [&](const wire::Message& message) { take(message); });
  answer();
}

void ReceiverPump::answer() {
  for (Named& each : by_name_) {
    each.unanswered = 0;
    for (const auto& message : each.receiver->poll(clock_())) send_message(link_, message, key_);
  }
}

/// Answers after half a window, so that the streamer sends the next half meanwhile.
void ReceiverPump::take(const wire::Message& message) {
  if (const auto* const master = std::get_if<wire::Master>(&message.body)) {
    for (const auto& [name, take] : masters_)
      if (name == message.executor) take(*master);
    return;
  }
  if (claims_ && std::holds_alternative<wire::Claim>(message.body)) return claims_(message);
  const auto found =
      std::lower_bound(by_name_.begin(), by_name_.end(), message.executor,
                       [](const Named& each, const std::string& name) { return each.name < name; });
  if (found == by_name_.end() || found->name != message.executor) return;
  found->receiver->receive(message, clock_());
  // Other sessions wait until the end of the iteration: the number of answers to them is bounded.
  if (message.session == 0 || message.session != found->receiver->session()) return;
  const auto* const chunk = std::get_if<wire::Chunk>(&message.body);
  found->unanswered += chunk != nullptr ? chunk->values.size() : wire::message_values;
  if (found->unanswered < found->half_a_window) return;
  found->unanswered = 0;
  for (const auto& reply : found->receiver->answers()) send_message(link_, reply, key_);
}

void ReceiverPump::publish(wire::Status status, std::size_t axis) {
  const Receiver& receiver = receivers_[axis];
  status.boot = receiver.boot();
  status.rejected = static_cast<std::int64_t>(rejects_.total());
  status.not_authentic = static_cast<std::int64_t>(rejects_[wire::Reject::not_authentic]);
  send_message(link_, receiver.status(status), key_);
}

void ReceiverPump::announce(wire::Event event, std::size_t axis) {
  event.boot = receivers_[axis].boot();
  send_message(link_, {receivers_[axis].executor(), 0, event}, key_);
}

void ReceiverPump::publish_master(wire::MasterStatus status, std::size_t axis) {
  status.boot = receivers_[axis].boot();
  send_message(link_, {receivers_[axis].executor(), 0, status}, key_);
}

void ReceiverPump::publish_group(wire::GroupStatus status, std::size_t axis) {
  status.boot = receivers_[axis].boot();
  send_message(link_, {receivers_[axis].executor(), 0, status}, key_);
}

void ReceiverPump::subscribe_claims(std::function<void(const wire::Message&)> take) {
  claims_ = std::move(take);
  for (const Receiver& receiver : receivers_)
    link_.subscribe(wire::channel(receiver.executor(), wire::Lane::claim), queue_capacity);
}

void ReceiverPump::subscribe(const std::string& master,
                             std::function<void(const wire::Master&)> take) {
  link_.subscribe(wire::channel(master, wire::Lane::master), queue_capacity);
  masters_.emplace_back(master, std::move(take));
}

}  // namespace jounce
