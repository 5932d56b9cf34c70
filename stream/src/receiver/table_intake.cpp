// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/table_intake.hpp"

#include <new>
#include <utility>

namespace jounce {
namespace {

/// True if both headers announce one table, as far as their fields show.
bool agree(const wire::Header& a, const wire::Header& b) {
  if (a.has_hash() && b.has_hash()) return a.hash == b.hash;
  return a.axis == b.axis && a.rule == b.rule && a.outside == b.outside && a.units.x == b.units.x &&
         a.units.position == b.units.position && a.knots == b.knots && a.per_chunk == b.per_chunk;
}

}  // namespace

Refused TableIntake::add(const wire::Header& header) {
  const auto slot = slots_.find(header.table);
  if (slot == slots_.end()) {
    slots_.emplace(header.table, announced(header));
    return {};
  }
  if (!agree(slot->second.header, header))
    return {wire::Refusal::bad_header, "the index belongs to another table"};
  if (header.has_hash() && !slot->second.header.has_hash()) learn(slot->second, header.hash);
  slot->second.ack_due = true;
  return {};
}

TableIntake::Slot TableIntake::announced(const wire::Header& header) {
  Slot slot{.header = header};
  if (header.has_hash()) slot.stored = store_.find(header.hash);
  if (slot.stored) {
    ready_ = slot.stored;
    return slot;
  }
  slot.refused = contradiction(header);
  if (!slot.refused && header.knots > limits_.most_knots) {
    slot.refused = {wire::Refusal::too_large,
                    "at most " + std::to_string(limits_.most_knots) + " knots"};
  }
  if (!slot.refused && !store_.reserve(bytes_of(header))) {
    slot.refused = {wire::Refusal::out_of_memory,
                    "at most " + std::to_string(limits_.memory) + " bytes of tables"};
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

Refused TableIntake::add(const wire::Chunk& chunk) {
  const auto it = slots_.find(chunk.table);
  if (it == slots_.end()) return {};  // the chunk has overtaken its header
  Slot& slot = it->second;
  slot.ack_due = true;
  if (!slot.assembly) return {};
  if (!slot.assembly->add(chunk))
    return {wire::Refusal::bad_chunk,
            "chunk " + std::to_string(chunk.seq) + " contradicts its header"};
  if (slot.assembly->complete() && slot.header.has_hash()) finish(slot);
  return {};
}

/// Sets the hash that the first header lacked: of a table that is stored, complete, or in transit.
void TableIntake::learn(Slot& slot, const Sha256& hash) {
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
  ready_ = slot.stored;
}

void TableIntake::finish(Slot& slot) {
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
  ready_ = slot.stored;
}

std::optional<StoredTable> TableIntake::take_ready() {
  return std::exchange(ready_, std::nullopt);
}

std::vector<wire::Ack> TableIntake::acks(std::int64_t boot) {
  std::vector<wire::Ack> acks;
  for (auto& [table, slot] : slots_)
    if (std::exchange(slot.ack_due, false)) acks.push_back(ack(table, slot, boot));
  return acks;
}

void TableIntake::clear() {
  for (const auto& [table, slot] : slots_)
    if (slot.assembly) store_.release(bytes_of(slot.header));
  slots_.clear();
}

wire::Ack TableIntake::ack(std::uint32_t table, const Slot& slot, std::int64_t boot) const {
  wire::Ack ack{.boot = boot,
                .table = table,
                .credit = limits_.credit,
                .complete = slot.stored.has_value(),
                .refusal = slot.refused.refusal,
                .reason = slot.refused.reason};
  if (slot.assembly) {
    ack.next = slot.assembly->next();
    ack.mask = slot.assembly->mask();
    ack.credit = wire::cut(slot.header).chunks_for(limits_.credit);
  } else if (slot.stored) {
    ack.next = slot.header.chunks;
  }
  return ack;
}

}  // namespace jounce
