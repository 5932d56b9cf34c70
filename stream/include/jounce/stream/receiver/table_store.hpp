// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <optional>

#include "jounce/base/hash.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// A complete table, shared with its players.
struct StoredTable {
  Sha256 hash{};
  Units units;
  std::shared_ptr<const Table> table;
};

/// Complete tables by their hash, within a memory bound shared with tables in transit.
///
/// New tables replace the oldest ones without another owner. The thread that owns the store
/// therefore frees a table's memory, never the thread that plays the table and releases it.
class TableStore {
 public:
  /// `bytes`: memory of all knots, at most.
  explicit TableStore(std::size_t bytes) : limit_(bytes) {}

  [[nodiscard]] std::optional<StoredTable> find(const Sha256& hash) const;

  /// Reserves bytes for a table in transit; returns false if they do not fit, even without old
  /// tables.
  [[nodiscard]] bool reserve(std::size_t bytes);
  /// Returns bytes of reserve().
  void release(std::size_t bytes);

  /// Stores a table whose bytes are reserved; the table then owns them.
  void put(StoredTable table);

  [[nodiscard]] std::size_t tables() const { return tables_.size(); }
  [[nodiscard]] std::size_t bytes() const { return used_; }

 private:
  std::size_t limit_;
  std::size_t used_ = 0;
  std::list<StoredTable> tables_;  // the oldest first
};

}  // namespace jounce
