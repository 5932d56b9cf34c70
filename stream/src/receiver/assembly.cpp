// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/assembly.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <new>
#include <span>
#include <utility>

#include "jounce/profiles/detail/large_pages.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// The columns in the order of the wire.
std::array<std::vector<double>*, 4> in_order(Columns& columns) {
  return {&columns.x, &columns.p, &columns.v, &columns.a};
}

}  // namespace

std::size_t bytes_of(const wire::Header& header) {
  return std::size_t{header.knots} * header.columns * sizeof(double);
}

Assembly::Assembly(const wire::Header& header)
    : header_(header), cut_(wire::cut(header)), arrived_(cut_.chunks) {
  assert(!contradiction(header));
  for (std::size_t i = 0; i < cut_.columns; ++i)
    profiles_detail::reserve_large(*in_order(columns_)[i], header.knots);
}

bool Assembly::add(const wire::Chunk& chunk) {
  if (chunk.seq >= cut_.chunks || chunk.columns != cut_.columns ||
      chunk.first_knot != chunk.seq * cut_.per_chunk ||
      chunk.knots != cut_.knots_of(chunk.seq, header_.knots) ||
      chunk.values.size() != std::size_t{chunk.knots} * chunk.columns)
    return false;
  if (arrived_[chunk.seq]) return true;
  put(chunk);
  arrived_[chunk.seq] = true;
  if (chunk.seq == next_) advance();
  return true;
}

/// The memory is allocated, but its pages are not: each is touched on first use, and only once if
/// chunks arrive in order.
void Assembly::put(const wire::Chunk& chunk) {
  const std::size_t end = std::size_t{chunk.first_knot} + chunk.knots;
  for (std::uint32_t i = 0; i < cut_.columns; ++i) {
    std::vector<double>& column = *in_order(columns_)[i];
    const double* const from = chunk.values.data() + std::size_t{i} * chunk.knots;
    if (column.size() == chunk.first_knot) {
      column.insert(column.end(), from, from + chunk.knots);
    } else {
      if (column.size() < end) column.resize(end);
      std::copy_n(from, chunk.knots, column.begin() + chunk.first_knot);
    }
  }
}

/// Hashes the newly completed part: from its final location in the table, so that the stored and
/// the hashed data are the same, and while it is still in the processor's caches.
void Assembly::advance() {
  const std::size_t from = std::size_t{next_} * cut_.per_chunk;
  while (next_ < cut_.chunks && arrived_[next_]) ++next_;
  const std::size_t to = std::min<std::size_t>(std::size_t{next_} * cut_.per_chunk, header_.knots);
  std::array<std::span<const double>, 4> whole;
  const auto columns = in_order(columns_);
  for (std::uint32_t i = 0; i < cut_.columns; ++i)
    whole[i] = std::span<const double>(*columns[i]).subspan(from, to - from);
  hasher_.add(whole);
}

std::uint64_t Assembly::mask() const {
  std::uint64_t mask = 0;
  for (std::uint32_t i = 0; i < 64 && next_ + 1 + i < cut_.chunks; ++i)
    if (arrived_[next_ + 1 + i]) mask |= std::uint64_t{1} << i;
  return mask;
}

std::variant<StoredTable, Refused> Assembly::finish(const Sha256& announced) {
  assert(complete());
  try {
    auto table = std::make_shared<const Table>(header_.axis, header_.rule, header_.outside,
                                               std::move(columns_));
    const Sha256 hash =
        hasher_.result(header_.axis, header_.rule, header_.outside, header_.units, header_.knots);
    if (hash != announced) {
      return Refused{wire::Refusal::hash_mismatch,
                     "announced " + hex(announced) + ", arrived " + hex(hash)};
    }
    return StoredTable{hash, header_.units, std::move(table)};
  } catch (const InputError& error) {
    return Refused{wire::Refusal::bad_table, error.what()};
  } catch (const std::bad_alloc&) {
    return Refused{wire::Refusal::out_of_memory, "no memory to hash the table"};
  }
}

}  // namespace jounce
