// SPDX-License-Identifier: Apache-2.0
// The receiver's tables, from their header to the store; sessions are in receiver.cpp.
#include <new>
#include <utility>

#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {
namespace {

/// True if both headers announce one table, as far as their fields show.
bool agree(const wire::Header& a, const wire::Header& b) {
  if (a.has_hash() && b.has_hash()) return a.hash == b.hash;
  return a.axis == b.axis && a.rule == b.rule && a.outside == b.outside && a.units.x == b.units.x &&
         a.units.position == b.units.position && a.knots == b.knots && a.per_chunk == b.per_chunk;
}

}  // namespace

void Receiver::refuse_table(std::int64_t session, std::uint32_t table, Refused refused) {
  answer_stranger(session, wire::Ack{.boot = boot_,
                                     .table = table,
                                     .refusal = refused.refusal,
                                     .reason = std::move(refused.reason)});
}

void Receiver::take(const wire::Header& header) {
  const auto slot = slots_.find(header.table);
  if (slot == slots_.end()) {
    slots_.emplace(header.table, announced(header));
  } else if (agree(slot->second.header, header)) {
    if (header.has_hash() && !slot->second.header.has_hash()) learn(slot->second, header.hash);
    slot->second.ack_due = true;
  } else {
    refuse_table(session_, header.table,
                 {wire::Refusal::bad_header, "the index belongs to another table"});
  }
}

Receiver::Slot Receiver::announced(const wire::Header& header) {
  Slot slot{.header = header};
  if (header.has_hash()) slot.stored = store_.find(header.hash);
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

void Receiver::take(const wire::Chunk& chunk) {
  const auto it = slots_.find(chunk.table);
  if (it == slots_.end()) return;  // the chunk has overtaken its header
  Slot& slot = it->second;
  slot.ack_due = true;
  if (!slot.assembly) return;
  if (!slot.assembly->add(chunk)) {
    refuse_table(session_, chunk.table,
                 {wire::Refusal::bad_chunk,
                  "chunk " + std::to_string(chunk.seq) + " contradicts its header"});
  } else if (slot.assembly->complete() && slot.header.has_hash()) {
    finish(slot);
  }
}

/// Sets the hash that the first header lacked: of a table that is stored, complete, or in transit.
void Receiver::learn(Slot& slot, const Sha256& hash) {
  slot.header.hash = hash;
  if (slot.refused.refusal == wire::Refusal::out_of_memory) {  // the table may need no space
    Slot again = announced(slot.header);
    slot = std::move(again);
    return;
  }
  if (!slot.assembly) return;
  if (slot.assembly->complete()) return finish(slot);
  slot.stored = store_.find(hash);
  if (!slot.stored) return;
  slot.assembly.reset();
  store_.release(bytes_of(slot.header));
  events_.emplace_back(TableReady{session_, *slot.stored});
}

void Receiver::finish(Slot& slot) {
  auto result = slot.assembly->finish(slot.header.hash);
  slot.assembly.reset();
  if (auto* refused = std::get_if<Refused>(&result)) {
    store_.release(bytes_of(slot.header));
    slot.refused = std::move(*refused);
    return;
  }
  slot.stored = store_.find(slot.header.hash);
  if (slot.stored) {  // announced twice, with two indices
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
    ack.credit = wire::cut(slot.header).chunks_for(options_.credit);
  } else if (slot.stored) {
    ack.next = slot.header.chunks;
  }
  return ack;
}

}  // namespace jounce
