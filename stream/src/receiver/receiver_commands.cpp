// SPDX-License-Identifier: Apache-2.0
// The receiver's commands and queues; sessions are in receiver.cpp, tables are in table_intake.cpp.
#include <algorithm>
#include <cassert>
#include <utility>

#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

void Receiver::refuse_command(std::int64_t session, std::int32_t command, Refused refused) {
  answer_stranger(session, wire::Reply{.boot = boot_,
                                       .command = command,
                                       .outcome = wire::Outcome::refused,
                                       .refusal = refused.refusal,
                                       .reason = std::move(refused.reason)});
}

/// True if this command is newer than the recorded one; it then replaces it, pending. A repeated
/// command gets its answer again, an older one does not.
bool Receiver::is_new(Record& record, Record::Kind kind, std::int32_t command) const {
  if (command < record.reply.command) return false;
  record.due = true;
  if (command == record.reply.command) return false;
  record.kind = kind;
  record.what.reset();
  record.reply = {.boot = boot_, .command = command};
  return true;
}

void Receiver::settle(Record& record, Refused refused) {
  record.reply.outcome = refused ? wire::Outcome::refused : wire::Outcome::accepted;
  record.reply.refusal = refused.refusal;
  record.reply.reason = std::move(refused.reason);
  record.due = true;
}

void Receiver::take(const wire::Arm& arm) {
  if (!is_new(command_, Record::Kind::arm, arm.command)) return;
  armed_ = false;
  armed_queue_.reset();
  if (arm.mode == wire::ArmMode::queue) return arm_queue(arm);
  const auto slave = store().find(arm.slave);
  const bool with_master = arm.mode == wire::ArmMode::follow_table;
  const auto master = with_master ? store().find(arm.master) : std::nullopt;
  if (!slave || (with_master && !master)) {
    return settle(command_,
                  {wire::Refusal::table_missing,
                   std::string(slave ? "the master" : "the slave") + " table " +
                       hex(slave ? arm.master : arm.slave) + " has not arrived completely"});
  }
  std::optional<TableInUnits> driver;
  if (master) driver.emplace(TableInUnits{*master->table, master->units});
  if (Refused refused =
          misfit(arm.mode, {*slave->table, slave->units}, driver ? &*driver : nullptr))
    return settle(command_, std::move(refused));
  events_.emplace_back(
      ArmRequested{session_, arm.command, arm.mode, *slave, master, arm.coupling, arm.end});
}

void Receiver::arm_queue(const wire::Arm& arm) {
  const OpenQueue* const queue = open_queue(arm.queue);
  if (queue == nullptr || queue->intake.refused()) {
    return settle(command_, {wire::Refusal::queue_missing,
                             "queue " + std::to_string(arm.queue) + " is not open"});
  }
  armed_queue_.emplace(arm.queue, arm.bank);
  events_.emplace_back(QueueArmRequested{session_, arm.command, arm.queue, arm.bank});
}

void Receiver::take(const wire::Start& start) {
  if (!is_new(command_, Record::Kind::start, start.command)) return;
  if (!armed_) return settle(command_, {wire::Refusal::not_armed, {}});
  if (armed_queue_) {
    const auto [index, bank] = *armed_queue_;
    const OpenQueue* const queue = open_queue(index);
    if (queue == nullptr || !queue->intake.filled(bank)) {
      return settle(command_, {wire::Refusal::prefill_missing,
                               "queue " + std::to_string(index) +
                                   " has too few rows to start: send more rows first"});
    }
  }
  events_.emplace_back(
      StartRequested{session_, start.command, start.tick, start.when, start.position});
}

void Receiver::take(const wire::Stop& stop) {
  if (!is_new(command_, Record::Kind::stop, stop.command)) return;
  armed_ = false;
  events_.emplace_back(StopRequested{command_.session, stop.command, stop.mode});
}

void Receiver::take(const wire::Heartbeat& heartbeat) {
  if (!is_new(command_, Record::Kind::heartbeat, heartbeat.command)) return;
  settle(command_, {});
  if (heartbeat.release) end(SessionEnded::Why::released);
}

void Receiver::take(const wire::Command& command) {
  if (!is_new(command_, Record::Kind::command, command.command)) return;
  if (Refused refused = misses(command)) return settle(command_, std::move(refused));
  const ClientCommand what = command_of(command.kind, command.value);
  command_.what = what;
  holds_ = holds_ || holds_to_run(what);
  events_.emplace_back(CommandRequested{session_, command.command, command.at, what});
}

/// Reason why a command cannot be passed to the axis.
Refused Receiver::misses(const wire::Command& command) {
  if (std::string rule = contradiction(command.kind, command.value); !rule.empty())
    return {wire::Refusal::bad_order, std::move(rule)};
  const auto queue_is_missing = [&](const auto& what) {
    if constexpr (requires { what.queue; }) return open_queue(what.queue) == nullptr;
    return false;
  };
  if (std::visit(queue_is_missing, command_of(command.kind, command.value)))
    return {wire::Refusal::queue_missing, {}};
  return {};
}

Receiver::Record* Receiver::pending(std::int64_t session, std::int32_t command) {
  Record& record = session == 0 ? operator_ : command_;
  const bool owed = record.session == session && record.reply.command == command &&
                    record.reply.outcome == wire::Outcome::pending;
  return owed ? &record : nullptr;
}

void Receiver::accept(std::int64_t session, std::int32_t command) {
  Record* const record = pending(session, command);
  if (record == nullptr) return;
  settle(*record, {});
  done(*record);
}

/// Applies the effects of an accepted command.
void Receiver::done(const Record& record) {
  if (record.kind == Record::Kind::arm) armed_ = true;
  if (record.kind == Record::Kind::start) armed_ = false;
  const auto* const clear = record.what ? std::get_if<command::QueueClear>(&*record.what) : nullptr;
  OpenQueue* const queue = clear != nullptr ? open_queue(clear->queue) : nullptr;
  if (queue == nullptr) return;
  queue->intake.clear(clear->bank, clear->seq);
  queue->ack_due = true;
}

void Receiver::refuse(std::int64_t session, std::int32_t command, std::string reason,
                      std::int32_t cause) {
  Record* const record = pending(session, command);
  if (record == nullptr) return;
  settle(*record, {wire::Refusal::axis, std::move(reason)});
  record->reply.cause = cause;
}

// ---- queues -------------------------------------------------------------------------------------

Receiver::OpenQueue* Receiver::open_queue(std::uint32_t queue) {
  const auto it = queues_.find(queue);
  return it == queues_.end() ? nullptr : &it->second;
}

void Receiver::refuse_queue_of(std::int64_t session, std::uint32_t queue, Refused refused) {
  answer_stranger(session, wire::QueueAck{.boot = boot_,
                                          .queue = queue,
                                          .refusal = refused.refusal,
                                          .reason = std::move(refused.reason)});
}

void Receiver::take(const wire::Queue& queue) {
  if (OpenQueue* const open = open_queue(queue.queue)) {
    open->ack_due = true;
    if (open->intake.queue() == queue) return;
    return refuse_queue_of(session_, queue.queue,
                           {wire::Refusal::bad_queue, "the index belongs to another open queue"});
  }
  Refused refused{wire::Refusal::bad_queue, wire::contradiction(queue)};
  if (refused.reason.empty()) refused.refusal = wire::Refusal::none;
  if (!refused && queue.axis == Domain::time && queue.units.x != "s")
    refused = {wire::Refusal::wrong_unit,
               "a queue over time must have the unit s, not " + queue.units.x};
  if (!refused && queue.capacity > options_.most_rows) {
    refused = {wire::Refusal::too_large,
               "a bank holds at most " + std::to_string(options_.most_rows) + " rows"};
  }
  if (!refused && queues_.size() >= options_.most_queues) {
    refused = {wire::Refusal::out_of_memory,
               "at most " + std::to_string(options_.most_queues) + " queues in a session"};
  }
  if (refused) return refuse_queue_of(session_, queue.queue, std::move(refused));
  queues_.emplace(queue.queue, OpenQueue{.intake = RowIntake(queue, options_.credit)});
  events_.emplace_back(QueueOpened{session_, queue});
}

void Receiver::take(const wire::Rows& rows) {
  OpenQueue* const queue = open_queue(rows.queue);
  if (queue == nullptr) return;  // they have overtaken their queue
  queue->ack_due = true;
  queue->intake.add(rows);
  for (wire::Rows& ready : queue->intake.take()) {
    ++rows_taken_;
    events_.emplace_back(RowsArrived{session_, std::move(ready)});
  }
}

void Receiver::level(std::uint32_t queue, const QueueLevel& level) {
  OpenQueue* const open = open_queue(queue);
  if (open != nullptr) open->ack_due |= open->intake.level(level);
}

void Receiver::refuse_queue(std::uint32_t queue, wire::Refusal refusal, std::string reason) {
  OpenQueue* const open = open_queue(queue);
  if (open == nullptr) return;
  open->intake.refuse({refusal, std::move(reason)});
  open->ack_due = true;
}

void Receiver::refuse_row(std::uint32_t queue, std::uint64_t row, std::string reason) {
  OpenQueue* const open = open_queue(queue);
  if (open == nullptr) return;
  open->intake.refuse({wire::Refusal::bad_row, std::move(reason)}, static_cast<std::int64_t>(row));
  open->ack_due = true;
}

}  // namespace jounce
