#include "jounce/stream/receiver.hpp"

#include <algorithm>
#include <cassert>
#include <new>
#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr std::size_t remembered_sessions = 16;
constexpr std::size_t most_answers = 64;  // between two polls, for messages of strangers

ReceiverOptions checked(ReceiverOptions options) {
  if (!wire::is_executor_name(options.executor))
    throw InputError("executor", options.executor, "must be 1 to 23 of A-Z a-z 0-9 _ -");
  if (options.credit < 1 || options.credit > 64)
    throw InputError("credit", std::to_string(options.credit), "must be 1 to 64");
  return options;
}

}  // namespace

Receiver::Receiver(ReceiverOptions options, std::int64_t boot)
    : options_(checked(std::move(options))), boot_(boot), store_(options_.memory) {
  assert(boot > 0);
}

void Receiver::receive(const wire::Message& message, Nanos now) {
  if (message.executor != options_.executor) return;
  if (message.session == 0 && !std::holds_alternative<wire::Stop>(message.body)) return;
  if (message.session != session_) expire(now);
  std::visit([&](const auto& body) { take(body, message.session); }, message.body);
  if (message.session == session_) heard_ = now;
}

std::vector<wire::Message> Receiver::poll(Nanos now) {
  expire(now);
  for (auto& [table, slot] : slots_)
    if (std::exchange(slot.ack_due, false)) send(session_, ack(table, slot));
  for (Record* record : {&command_, &operator_})
    if (std::exchange(record->due, false)) send(record->session, record->reply);
  return std::exchange(outgoing_, {});
}

std::optional<StreamEvent> Receiver::take_event() {
  if (events_.empty()) return std::nullopt;
  StreamEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

wire::Message Receiver::status(const wire::Status& status) const {
  return {options_.executor, session_, status};
}

void Receiver::send(std::int64_t session, wire::Body body) {
  outgoing_.push_back({options_.executor, session, std::move(body)});
}

// ---- sessions -----------------------------------------------------------------------------------

void Receiver::open(std::int64_t session) {
  session_ = session;
  armed_ = false;
  command_ = {.session = session};
}

void Receiver::end(SessionEnded::Why why) {
  for (const auto& [table, slot] : slots_)
    if (slot.assembly) store_.release(bytes_of(slot.header));
  slots_.clear();
  // A stop is still owed its answer; nothing else may take effect any longer.
  const bool undecided = command_.reply.outcome == wire::Outcome::pending;
  if (undecided && (command_.kind == Record::Kind::arm || command_.kind == Record::Kind::start))
    settle(command_, {wire::Refusal::session_ended, {}});
  ended_.push_back(session_);
  if (ended_.size() > remembered_sessions) ended_.pop_front();
  events_.emplace_back(SessionEnded{session_, why});
  session_ = 0;
  armed_ = false;
}

void Receiver::expire(Nanos now) {
  if (session_ != 0 && now - heard_ > options_.session_timeout) end(SessionEnded::Why::silent);
}

/// Why a session that is not the live one may not do anything.
Refused Receiver::stranger(std::int64_t session) const {
  if (session_ != 0) return {wire::Refusal::busy, "the axis belongs to another session"};
  if (std::find(ended_.begin(), ended_.end(), session) != ended_.end())
    return {wire::Refusal::session_ended, {}};
  return {wire::Refusal::unknown_session, {}};
}

// ---- tables -------------------------------------------------------------------------------------

void Receiver::refuse_table(std::int64_t session, std::uint32_t table, Refused refused) {
  if (outgoing_.size() >= most_answers) return;
  send(session, wire::Ack{.boot = boot_,
                          .table = table,
                          .refusal = refused.refusal,
                          .reason = std::move(refused.reason)});
}

void Receiver::take(const wire::Header& header, std::int64_t session) {
  if (session != session_) {
    Refused refused = stranger(session);
    if (refused.refusal != wire::Refusal::unknown_session)
      return refuse_table(session, header.table, std::move(refused));
    open(session);
  }
  const auto slot = slots_.find(header.table);
  if (slot == slots_.end()) {
    slots_.emplace(header.table, announced(header));
  } else if (slot->second.header.hash == header.hash) {
    slot->second.ack_due = true;
  } else {
    refuse_table(session, header.table,
                 {wire::Refusal::bad_header, "this index has another table already"});
  }
}

Receiver::Slot Receiver::announced(const wire::Header& header) {
  Slot slot{.header = header};
  slot.stored = store_.find(header.hash);
  if (slot.stored) {
    events_.emplace_back(TableReady{session_, *slot.stored});
    return slot;
  }
  slot.refused = contradiction(header);
  if (!slot.refused && header.knots > options_.most_knots) {
    slot.refused = {wire::Refusal::too_large,
                    "at most " + std::to_string(options_.most_knots) + " knots"};
  }
  if (!slot.refused && !store_.reserve(bytes_of(header))) {
    slot.refused = {wire::Refusal::out_of_memory,
                    "at most " + std::to_string(options_.memory) + " bytes of tables"};
  }
  if (slot.refused) return slot;
  try {
    slot.assembly.emplace(header);
  } catch (const std::bad_alloc&) {
    store_.release(bytes_of(header));
    slot.refused = {wire::Refusal::out_of_memory, "no memory for the table"};
  }
  return slot;
}

void Receiver::take(const wire::Chunk& chunk, std::int64_t session) {
  if (session != session_) return refuse_table(session, chunk.table, stranger(session));
  const auto it = slots_.find(chunk.table);
  if (it == slots_.end()) return;  // it has overtaken its header
  Slot& slot = it->second;
  slot.ack_due = true;
  if (!slot.assembly) return;
  if (!slot.assembly->add(chunk)) {
    refuse_table(session, chunk.table,
                 {wire::Refusal::bad_chunk,
                  "chunk " + std::to_string(chunk.seq) + " contradicts its header"});
  } else if (slot.assembly->complete()) {
    finish(slot);
  }
}

void Receiver::finish(Slot& slot) {
  auto result = slot.assembly->finish();
  slot.assembly.reset();
  if (auto* refused = std::get_if<Refused>(&result)) {
    store_.release(bytes_of(slot.header));
    slot.refused = std::move(*refused);
    return;
  }
  slot.stored = store_.find(slot.header.hash);
  if (slot.stored) {  // announced twice, under two indices
    store_.release(bytes_of(slot.header));
  } else {
    slot.stored = std::get<StoredTable>(std::move(result));
    store_.put(*slot.stored);
  }
  events_.emplace_back(TableReady{session_, *slot.stored});
}

wire::Ack Receiver::ack(std::uint32_t table, const Slot& slot) const {
  wire::Ack ack{.boot = boot_,
                .table = table,
                .credit = options_.credit,
                .complete = slot.stored.has_value(),
                .refusal = slot.refused.refusal,
                .reason = slot.refused.reason};
  if (slot.assembly) {
    ack.next = slot.assembly->next();
    ack.mask = slot.assembly->mask();
  } else if (slot.stored) {
    ack.next = slot.header.chunks;
  }
  return ack;
}

// ---- commands -----------------------------------------------------------------------------------

void Receiver::refuse_command(std::int64_t session, std::int32_t command, Refused refused) {
  if (outgoing_.size() >= most_answers) return;
  send(session, wire::Reply{.boot = boot_,
                            .command = command,
                            .outcome = wire::Outcome::refused,
                            .refusal = refused.refusal,
                            .reason = std::move(refused.reason)});
}

/// Whether this command is newer than the recorded one, which it then replaces, pending. A repeated
/// one is answered again, an older one is not.
bool Receiver::is_new(Record& record, Record::Kind kind, std::int32_t command) const {
  if (command < record.reply.command) return false;
  record.due = true;
  if (command == record.reply.command) return false;
  record.kind = kind;
  record.reply = {.boot = boot_, .command = command};
  return true;
}

bool Receiver::is_new_of_live(Record::Kind kind, std::int64_t session, std::int32_t command) {
  const bool repeated_after_end =
      session_ == 0 && session == command_.session && command == command_.reply.command;
  if (session == session_ || repeated_after_end) return is_new(command_, kind, command);
  refuse_command(session, command, stranger(session));
  return false;
}

void Receiver::settle(Record& record, Refused refused) {
  record.reply.outcome = refused ? wire::Outcome::refused : wire::Outcome::accepted;
  record.reply.refusal = refused.refusal;
  record.reply.reason = std::move(refused.reason);
  record.due = true;
}

void Receiver::take(const wire::Arm& arm, std::int64_t session) {
  if (!is_new_of_live(Record::Kind::arm, session, arm.command)) return;
  armed_ = false;
  const auto slave = store_.find(arm.slave);
  const bool with_master = arm.mode == wire::ArmMode::follow_table;
  const auto master = with_master ? store_.find(arm.master) : std::nullopt;
  if (!slave || (with_master && !master)) {
    return settle(command_, {wire::Refusal::table_missing,
                             std::string(slave ? "the master" : "the slave") + " table " +
                                 hex(slave ? arm.master : arm.slave) + " is not complete here"});
  }
  std::optional<TableInUnits> driver;
  if (master) driver.emplace(TableInUnits{*master->table, master->units});
  if (Refused refused =
          misfit(arm.mode, {*slave->table, slave->units}, driver ? &*driver : nullptr))
    return settle(command_, std::move(refused));
  events_.emplace_back(ArmRequested{session, arm.command, arm.mode, *slave, master, arm.coupling});
}

void Receiver::take(const wire::Start& start, std::int64_t session) {
  if (!is_new_of_live(Record::Kind::start, session, start.command)) return;
  if (!armed_) return settle(command_, {wire::Refusal::not_armed, {}});
  events_.emplace_back(StartRequested{session, start.command, start.tick});
}

void Receiver::take(const wire::Stop& stop, std::int64_t session) {
  // The last owner may stop its motion even after its session; an operator may always.
  if (session != 0 && session != command_.session)
    return refuse_command(session, stop.command, stranger(session));
  Record& record = session == 0 ? operator_ : command_;
  // An operator's numbers are random: another one is new even if it is lower.
  if (session == 0 && stop.command != record.reply.command) record = {};
  if (!is_new(record, Record::Kind::stop, stop.command)) return;
  armed_ = false;
  events_.emplace_back(StopRequested{session, stop.command, stop.mode});
  if (session == 0 && session_ != 0) end(SessionEnded::Why::operator_stop);
}

void Receiver::take(const wire::Heartbeat& heartbeat, std::int64_t session) {
  if (!is_new_of_live(Record::Kind::heartbeat, session, heartbeat.command)) return;
  settle(command_, {});
  if (heartbeat.release) end(SessionEnded::Why::released);
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
  if (record->kind == Record::Kind::arm) armed_ = true;
  if (record->kind == Record::Kind::start) armed_ = false;
}

void Receiver::refuse(std::int64_t session, std::int32_t command, std::string reason,
                      std::int32_t cause) {
  Record* const record = pending(session, command);
  if (record == nullptr) return;
  settle(*record, {wire::Refusal::axis, std::move(reason)});
  record->reply.cause = cause;
}

}  // namespace jounce
