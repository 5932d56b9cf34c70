// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/receiver/static_queue.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/detail/row_window.hpp"

#include "stream/src/sender/reasons.hpp"

namespace jounce {
namespace {

wire::Queue checked(wire::Queue queue) {
  if (const std::string rule = contradiction(queue); !rule.empty())
    throw InputError("queue", std::to_string(queue.queue), rule);
  if (queue.mode != wire::QueueMode::static_)
    throw InputError("queue", "dynamic", "must be static: use stream_rows() for a dynamic queue");
  return queue;
}

CallOutcome refused(const wire::QueueAck& ack) {
  const std::string why = ack.reason.empty() ? "" : ": " + ack.reason;
  return {StreamError::refused, ack.refusal, 0, name(ack.refusal) + why};
}

CallOutcome stalled(std::string reason) {
  return {StreamError::stalled, wire::Refusal::none, 0, std::move(reason)};
}

}  // namespace

StaticQueue::StaticQueue(Client& client, wire::Queue queue)
    : client_(client),
      queue_(checked(std::move(queue))),
      banks_{RowWindow(queue_, 0), RowWindow(queue_, 1)} {}

StaticQueue::~StaticQueue() = default;

/// Returns the next answer to this queue's messages.
std::optional<wire::QueueAck> StaticQueue::receive(Nanos until) {
  for (Nanos now = client_.clock_(); now <= until; now = client_.clock_()) {
    const auto message = client_.receive(until - now);
    const auto* const ack = message ? std::get_if<wire::QueueAck>(&message->body) : nullptr;
    if (ack != nullptr && ack->queue == queue_.queue) return *ack;
    if (now == until) break;
  }
  return std::nullopt;
}

CallOutcome StaticQueue::unanswered() const {
  return {StreamError::no_answer, wire::Refusal::none, 0, "no answer from " + client_.executor_};
}

std::optional<wire::QueueAck> StaticQueue::level() {
  static_cast<void>(client_.request(wire::Heartbeat{}));
  for (const Nanos end = client_.clock_() + client_.options_.patience; client_.clock_() <= end;) {
    client_.send(queue_);
    if (const auto ack = receive(client_.clock_() + client_.options_.repeat)) return ack;
  }
  return std::nullopt;
}

CallOutcome StaticQueue::open() {
  if (CallOutcome outcome = client_.request(wire::Heartbeat{}); !outcome.ok()) return outcome;
  const auto ack = level();
  if (!ack) return unanswered();
  return ack->refusal == wire::Refusal::none ? CallOutcome{} : refused(*ack);
}

CallOutcome StaticQueue::fill(std::uint8_t bank, const std::vector<wire::Row>& rows) {
  assert(bank < banks_.size());
  RowWindow& window = banks_[bank];
  std::size_t next = 0;
  bool heard = false;  // an answer has arrived since rows were last taken
  Nanos moved = client_.clock_();
  client_.send(queue_);  // requests the available space
  for (Nanos asked = moved; client_.clock_() - moved <= client_.options_.patience;) {
    const auto ack = receive(client_.clock_() + client_.options_.repeat / 4);
    if (ack) {
      if (ack->refusal != wire::Refusal::none) return refused(*ack);
      heard = true;
      const std::uint64_t before = window.acknowledged();
      window.acknowledge(*ack);
      if (window.acknowledged() > before) {
        moved = client_.clock_();
        heard = false;
      }
      if (window.idle() && next == rows.size()) return {};
      if (window.idle() && window.wants() == 0) {
        return stalled("bank " + std::to_string(bank) + " has no space for " +
                       std::to_string(rows.size() - next) + " rows");
      }
    } else if (client_.clock_() - asked >= client_.options_.repeat) {
      asked = client_.clock_();
      client_.send(queue_);
    }
    while (next < rows.size() && window.wants() > 0) {
      const std::size_t count = std::min({rows.size() - next, window.wants(), wire::rows_each});
      const auto from = rows.begin() + static_cast<std::ptrdiff_t>(next);
      window.push({from, from + static_cast<std::ptrdiff_t>(count)});
      next += count;
    }
    for (wire::Rows& each : window.due(client_.clock_())) client_.send(std::move(each));
  }
  if (!heard) return unanswered();
  return stalled("bank " + std::to_string(bank) + " accepted no more rows for " +
                 stream_detail::milliseconds(client_.options_.patience));
}

CallOutcome StaticQueue::arm(std::uint8_t bank) {
  return client_.request(
      wire::Arm{.mode = wire::ArmMode::queue, .queue = queue_.queue, .bank = bank});
}

CallOutcome StaticQueue::start(std::int64_t tick) {
  return client_.request(wire::Start{.tick = tick});
}

CallOutcome StaticQueue::switch_over() {
  return client_.command(command::QueueSwitch{.queue = queue_.queue});
}

/// Messages still in transit are void: the next one has this number.
CallOutcome StaticQueue::clear(std::uint8_t bank) {
  assert(bank < banks_.size());
  return client_.command(command::QueueClear{
      .queue = queue_.queue, .bank = bank, .seq = static_cast<std::uint32_t>(banks_[bank].sent())});
}

}  // namespace jounce
