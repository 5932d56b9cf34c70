// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/message/refusal.hpp"
#include "jounce/stream/receiver/table_store.hpp"

namespace jounce {

/// Bytes of the knots that a header without contradiction announces.
std::size_t bytes_of(const wire::Header& header);

/// A table under way: its columns, filled chunk by chunk in any order, and hashed as far as they
/// are whole.
class Assembly {
 public:
  /// Takes the memory for all knots: bound them first. The header must not contradict itself.
  explicit Assembly(const wire::Header& header);

  /// A chunk seen before changes nothing. False if it contradicts the header.
  bool add(const wire::Chunk& chunk);

  /// Every chunk below has arrived.
  [[nodiscard]] std::uint32_t next() const { return next_; }
  /// Bit i: chunk next() + 1 + i has arrived.
  [[nodiscard]] std::uint64_t mask() const;
  [[nodiscard]] bool complete() const { return next_ == cut_.chunks; }

  /// The table of a complete assembly, once: constructed and hashed anew from what arrived, if its
  /// hash is the one that was announced.
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
