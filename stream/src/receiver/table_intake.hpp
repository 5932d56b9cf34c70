// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "jounce/stream/detail/table_store.hpp"
#include "jounce/stream/message/message.hpp"

#include "stream/src/message/refusal.hpp"
#include "stream/src/receiver/assembly.hpp"

namespace jounce {

/// Limits for the tables of a receiver.
struct TableLimits {
  std::uint32_t most_knots = 0;  ///< greatest number of knots of a table
  std::size_t memory = 0;        ///< greatest memory for all tables, complete or in transit, bytes
  std::uint32_t credit = 0;      ///< greatest number of messages of 12.8 KB in transit
};

/// The arriving tables of a session, each with its index, and the store of the complete tables. The
/// store reserves the memory for a table in transit.
///
///     TableIntake tables(limits);
///     if (Refused no = tables.add(header)) ...           // an answer to its sender
///     tables.add(chunk);
///     if (const auto ready = tables.take_ready()) ...    // after every add()
///     for (wire::Ack ack : tables.acks(boot)) ...        // each due acknowledgment once
///     tables.clear();                                    // the session has ended
class TableIntake {
 public:
  explicit TableIntake(const TableLimits& limits) : limits_(limits), store_(limits.memory) {}

  /// Adds a header or a chunk. Returns a refusal if the index belongs to another table, or if the
  /// chunk does not match its header. Other refusals are part of the acknowledgment of the table. A
  /// chunk that arrives before its header has no effect.
  [[nodiscard]] Refused add(const wire::Header& header);
  [[nodiscard]] Refused add(const wire::Chunk& chunk);

  /// Returns the table that the last add() has completed or found in the store; nullopt: none.
  [[nodiscard]] std::optional<StoredTable> take_ready();
  /// Returns the acknowledgments that are due. `boot`: number of this start of the executor.
  [[nodiscard]] std::vector<wire::Ack> acks(std::int64_t boot);
  /// Drops the tables in transit. Complete tables stay in the store.
  void clear();

  /// The complete tables.
  [[nodiscard]] const TableStore& store() const { return store_; }

 private:
  /// In transit, stored, or refused.
  struct Slot {
    wire::Header header;
    std::optional<Assembly> assembly{};
    std::optional<StoredTable> stored{};
    Refused refused{};
    bool ack_due = true;
  };

  [[nodiscard]] Slot announced(const wire::Header& header);
  void learn(Slot& slot, const Sha256& hash);
  void finish(Slot& slot);
  [[nodiscard]] wire::Ack ack(std::uint32_t table, const Slot& slot, std::int64_t boot) const;

  TableLimits limits_;
  TableStore store_;
  std::map<std::uint32_t, Slot> slots_;
  std::optional<StoredTable> ready_;
};

}  // namespace jounce
