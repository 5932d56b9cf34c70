// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/queue_intake.hpp"

#include <string>
#include <utility>

namespace jounce {

Refused QueueIntake::add(const wire::Queue& queue) {
  if (OpenQueue* const open = find(queue.queue)) {
    open->ack_due = true;
    if (open->intake.queue() == queue) return {};
    return {wire::Refusal::bad_queue, "the index belongs to another open queue"};
  }
  if (Refused refused = exceeds(queue)) return refused;
  queues_.emplace(queue.queue, OpenQueue{.intake = RowIntake(queue, limits_.credit)});
  opened_ = queue;
  return {};
}

/// Reason why a new queue cannot be opened.
Refused QueueIntake::exceeds(const wire::Queue& queue) const {
  if (std::string rule = wire::contradiction(queue); !rule.empty())
    return {wire::Refusal::bad_queue, std::move(rule)};
  if (queue.axis == Domain::time && queue.units.x != "s")
    return {wire::Refusal::wrong_unit,
            "a queue over time must have the unit s, not " + queue.units.x};
  if (queue.capacity > limits_.most_rows)
    return {wire::Refusal::too_large,
            "a bank holds at most " + std::to_string(limits_.most_rows) + " rows"};
  if (queues_.size() >= limits_.most_queues)
    return {wire::Refusal::out_of_memory,
            "at most " + std::to_string(limits_.most_queues) + " queues in a session"};
  return {};
}

void QueueIntake::add(const wire::Rows& rows) {
  OpenQueue* const open = find(rows.queue);
  if (open == nullptr) return;
  open->ack_due = true;
  open->intake.add(rows);
  for (wire::Rows& ready : open->intake.take()) ready_.push_back(std::move(ready));
}

std::optional<wire::Queue> QueueIntake::take_opened() {
  return std::exchange(opened_, std::nullopt);
}

std::vector<wire::Rows> QueueIntake::take_rows() {
  return std::exchange(ready_, {});
}

std::vector<wire::QueueAck> QueueIntake::acks(std::int64_t boot) {
  std::vector<wire::QueueAck> acks;
  for (auto& [index, open] : queues_)
    if (std::exchange(open.ack_due, false)) acks.push_back(open.intake.ack(boot));
  return acks;
}

bool QueueIntake::accepts(std::uint32_t queue) const {
  const RowIntake* const intake = intake_of(queue);
  return intake != nullptr && !intake->refused();
}

bool QueueIntake::is_filled(std::uint32_t queue, std::uint8_t bank) const {
  const RowIntake* const intake = intake_of(queue);
  return intake != nullptr && intake->filled(bank);
}

void QueueIntake::level(std::uint32_t queue, const QueueLevel& level) {
  if (OpenQueue* const open = find(queue)) open->ack_due |= open->intake.level(level);
}

void QueueIntake::refuse(std::uint32_t queue, Refused refused, std::int64_t row) {
  OpenQueue* const open = find(queue);
  if (open == nullptr) return;
  open->intake.refuse(std::move(refused), row);
  open->ack_due = true;
}

void QueueIntake::clear_bank(std::uint32_t queue, std::uint8_t bank, std::uint32_t seq) {
  OpenQueue* const open = find(queue);
  if (open == nullptr) return;
  open->intake.clear(bank, seq);
  open->ack_due = true;
}

QueueIntake::OpenQueue* QueueIntake::find(std::uint32_t queue) {
  const auto it = queues_.find(queue);
  return it == queues_.end() ? nullptr : &it->second;
}

const RowIntake* QueueIntake::intake_of(std::uint32_t queue) const {
  const auto it = queues_.find(queue);
  return it == queues_.end() ? nullptr : &it->second.intake;
}

}  // namespace jounce
