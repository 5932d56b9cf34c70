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

/// Complete tables by their hash, within a bound of memory that they share with tables under way.
///
/// New tables replace the oldest ones without another owner. So a table's memory is given
/// back by the thread that owns the store, never by the one that plays the table and lets go of it.
class TableStore {
 public:
  /// `bytes`: of knots, at most.
  explicit TableStore(std::size_t bytes) : limit_(bytes) {}

  [[nodiscard]] std::optional<StoredTable> find(const Sha256& hash) const;

  /// Sets bytes aside for a table under way; false if they do not fit even after old tables have
  /// gone.
  [[nodiscard]] bool reserve(std::size_t bytes);
  /// Gives back what reserve() set aside.
  void release(std::size_t bytes);

  /// Takes in a table whose bytes are reserved: they are its own from now on.
  void put(StoredTable table);

  [[nodiscard]] std::size_t tables() const { return tables_.size(); }
  [[nodiscard]] std::size_t bytes() const { return used_; }

 private:
  std::size_t limit_;
  std::size_t used_ = 0;
  std::list<StoredTable> tables_;  // the oldest first
};

}  // namespace jounce
