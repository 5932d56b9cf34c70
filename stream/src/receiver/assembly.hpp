// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/stream/detail/table_store.hpp"
#include "jounce/stream/message/message.hpp"

#include "stream/src/message/refusal.hpp"

namespace jounce {

/// Returns the number of bytes of the knots that a consistent header announces.
std::size_t bytes_of(const wire::Header& header);

/// A table in transit. Chunks may arrive in any order; they fill the columns of the table. The
/// leading part without gaps is hashed.
class Assembly {
 public:
  /// Allocates the memory for all knots, so check their number first. Requires a consistent header.
  explicit Assembly(const wire::Header& header);

  /// Adds a chunk; a repeated chunk has no effect. Returns false if the chunk does not match the
  /// header.
  bool add(const wire::Chunk& chunk);

  /// All chunks below this number have arrived.
  [[nodiscard]] std::uint32_t next() const { return next_; }
  /// Bit i: chunk next() + 1 + i has arrived.
  [[nodiscard]] std::uint64_t mask() const;
  /// True if all chunks have arrived.
  [[nodiscard]] bool complete() const { return next_ == cut_.chunks; }

  /// Returns the table if it is valid and the hash of the received data equals the announced hash;
  /// otherwise a refusal. Requires a complete assembly. Call once.
  [[nodiscard]] std::variant<StoredTable, Refused> finish(const Sha256& announced);

 private:
  void put(const wire::Chunk& chunk);
  void advance();

  wire::Header header_;
  wire::Cut cut_;
  Columns columns_;
  ContentHasher hasher_;
  std::vector<bool> arrived_;
  std::uint32_t next_ = 0;
};

}  // namespace jounce
