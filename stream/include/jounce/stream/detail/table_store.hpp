// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <list>
#include <optional>

#include "jounce/stream/receiver/stored_table.hpp"

namespace jounce {

/// Complete tables by their hash. A limit applies to the memory of these tables and of the tables
/// in transit together.
///
/// New tables replace the oldest tables that have no other owner. So only the thread that owns the
/// store frees the memory of a table, never a thread that has played the table.
class TableStore {
 public:
  /// `bytes`: greatest memory of all knots.
  explicit TableStore(std::size_t bytes) : limit_(bytes) {}

  /// Returns the table with this hash; nullopt: none.
  [[nodiscard]] std::optional<StoredTable> find(const Sha256& hash) const;

  /// Reserves memory for a table in transit. Returns false if it does not fit, even if old tables
  /// are removed.
  [[nodiscard]] bool reserve(std::size_t bytes);
  /// Frees memory that reserve() has reserved.
  void release(std::size_t bytes);

  /// Stores a table for which memory is reserved; the reservation then belongs to the table.
  /// Requires that no table with this hash is stored.
  void put(StoredTable table);

  /// Number of tables.
  [[nodiscard]] std::size_t tables() const { return tables_.size(); }
  /// Memory of all tables, and reserved memory.
  [[nodiscard]] std::size_t bytes() const { return used_; }

 private:
  std::size_t limit_;
  std::size_t used_ = 0;
  std::list<StoredTable> tables_;  // the oldest first
};

}  // namespace jounce
