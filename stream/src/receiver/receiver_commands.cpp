// SPDX-License-Identifier: Apache-2.0
// Commands: what each needs, and what the axis's answer changes. Messages and sessions are in receiver.cpp.
#include <cassert>
#include <utility>

#include "jounce/command/detail/command_table.hpp"

#include "stream/src/receiver/receiver_impl.hpp"

namespace jounce {

void Receiver::Impl::take(const wire::Arm& arm) {
  if (!command_.begin(LastCommand::Kind::arm, arm.command)) return;
  armed_ = false;
  armed_queue_.reset();
  if (arm.mode == wire::ArmMode::queue) return arm_queue(arm);
  const auto slave = store().find(arm.slave);
  const bool with_master = arm.mode == wire::ArmMode::follow_table;
  const auto master = with_master ? store().find(arm.master) : std::nullopt;
  if (!slave || (with_master && !master)) {
    return command_.settle(
        {wire::Refusal::table_missing, std::string(slave ? "the master" : "the slave") + " table " +
                                           hex(slave ? arm.master : arm.slave) +
                                           " has not arrived completely"});
  }
  std::optional<TableInUnits> driver;
  if (master) driver.emplace(TableInUnits{*master->table, master->units});
  if (Refused refused =
          misfit(arm.mode, {*slave->table, slave->units}, driver ? &*driver : nullptr))
    return command_.settle(std::move(refused));
  events_.emplace_back(
      ArmRequested{session_.id(), arm.command, arm.mode, *slave, master, arm.coupling, arm.end});
}

void Receiver::Impl::arm_queue(const wire::Arm& arm) {
  if (!queues_.accepts(arm.queue)) {
    return command_.settle(
        {wire::Refusal::queue_missing, "queue " + std::to_string(arm.queue) + " is not open"});
  }
  armed_queue_.emplace(arm.queue, arm.bank);
  events_.emplace_back(QueueArmRequested{session_.id(), arm.command, arm.queue, arm.bank});
}

void Receiver::Impl::take(const wire::Start& start) {
  if (!command_.begin(LastCommand::Kind::start, start.command)) return;
  if (!armed_) return command_.settle({wire::Refusal::not_armed, {}});
  if (armed_queue_) {
    const auto [index, bank] = *armed_queue_;
    if (!queues_.is_filled(index, bank)) {
      return command_.settle(
          {wire::Refusal::prefill_missing,
           "queue " + std::to_string(index) + " has too few rows to start: send more rows first"});
    }
  }
  events_.emplace_back(
      StartRequested{session_.id(), start.command, start.tick, start.when, start.position});
}

void Receiver::Impl::take(const wire::Stop& stop) {
  if (!command_.begin(LastCommand::Kind::stop, stop.command)) return;
  armed_ = false;
  events_.emplace_back(StopRequested{session_.owner(), stop.command, stop.mode});
}

void Receiver::Impl::take(const wire::Heartbeat& heartbeat) {
  if (!command_.begin(LastCommand::Kind::heartbeat, heartbeat.command)) return;
  command_.settle({});
  if (heartbeat.release) end(SessionEnded::Why::released);
}

void Receiver::Impl::take(const wire::Command& command) {
  if (!command_.begin(LastCommand::Kind::command, command.command)) return;
  if (Refused refused = misses(command)) return command_.settle(std::move(refused));
  const ClientCommand what = command_of(command.kind, command.value);
  command_.keep(what);
  if (holds_to_run(what)) session_.hold();
  events_.emplace_back(CommandRequested{session_.id(), command.command, command.at, what});
}

/// Reason why a command cannot be passed to the axis.
Refused Receiver::Impl::misses(const wire::Command& command) const {
  if (std::string rule = contradiction(command.kind, command.value); !rule.empty())
    return {wire::Refusal::bad_order, std::move(rule)};
  const auto queue_is_missing = [&](const auto& what) {
    if constexpr (requires { what.queue; }) return !queues_.is_open(what.queue);
    return false;
  };
  if (std::visit(queue_is_missing, command_of(command.kind, command.value)))
    return {wire::Refusal::queue_missing, {}};
  return {};
}

// ---- the axis's answers -------------------------------------------------------------------------

LastCommand* Receiver::Impl::pending(std::int64_t session, std::int32_t command) {
  if (session != 0 && session != session_.owner()) return nullptr;
  LastCommand& record = session == 0 ? operator_ : command_;
  return record.waits(command) ? &record : nullptr;
}

void Receiver::Impl::accept(std::int64_t session, std::int32_t command, std::string note) {
  LastCommand* const record = pending(session, command);
  if (record == nullptr) return;
  record->settle({wire::Refusal::none, std::move(note)});
  done(*record);
}

/// Applies the effects of an accepted command.
void Receiver::Impl::done(const LastCommand& record) {
  if (record.kind() == LastCommand::Kind::arm) armed_ = true;
  if (record.kind() == LastCommand::Kind::start) armed_ = false;
  if (!record.what()) return;
  if (const auto* const clear = std::get_if<command::QueueClear>(&*record.what()))
    queues_.clear_bank(clear->queue, clear->bank, clear->seq);
}

void Receiver::Impl::refuse(std::int64_t session, std::int32_t command, std::string reason,
                            std::int32_t cause) {
  if (LastCommand* const record = pending(session, command))
    record->settle({wire::Refusal::axis, std::move(reason), cause});
}

// ---- operators ----------------------------------------------------------------------------------

/// Each operator command invalidates the challenge that it carries. Without a key, a stop with a
/// wrong challenge is executed nevertheless: this is safe, and faster.
void Receiver::Impl::receive_operators(const wire::Message& message) {
  const std::int32_t number = command_number(message.body);
  const auto* const stop = std::get_if<wire::Stop>(&message.body);
  const auto* const command = std::get_if<wire::Command>(&message.body);
  if (stop == nullptr && (command == nullptr || !is_operators(command->kind))) return;
  if (number == operator_.number() && message.challenge == operators_last_challenge_)
    return operator_.repeat();
  const bool sudden = stop != nullptr && !options_.key && message.challenge == 0;
  if (message.challenge != challenges_.operators() && !sudden)
    return refuse_command(0, number, {wire::Refusal::stale_challenge, {}});
  challenges_.renew_operators();
  operators_last_challenge_ = message.challenge;
  operator_.replace(stop != nullptr ? LastCommand::Kind::stop : LastCommand::Kind::command, number);
  if (command != nullptr) {
    if (Refused refused = misses(*command)) return operator_.settle(std::move(refused));
    events_.emplace_back(
        CommandRequested{0, number, command->at, command_of(command->kind, command->value)});
    return;
  }
  armed_ = false;
  events_.emplace_back(StopRequested{0, number, stop->mode});
  if (!session_.is_free()) end(SessionEnded::Why::operator_stop);
}

}  // namespace jounce
