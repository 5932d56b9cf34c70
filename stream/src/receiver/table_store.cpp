// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/table_store.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace jounce {
namespace {

std::size_t bytes_of(const Table& table) {
  const auto& [x, p, v, a] = table.columns();
  return (x.size() + p.size() + v.size() + a.size()) * sizeof(double);
}

bool is_held_elsewhere(const StoredTable& stored) {
  return stored.table.use_count() > 1;
}

}  // namespace

std::optional<StoredTable> TableStore::find(const Sha256& hash) const {
  const auto it = std::find_if(tables_.begin(), tables_.end(),
                               [&](const StoredTable& stored) { return stored.hash == hash; });
  if (it == tables_.end()) return std::nullopt;
  return *it;
}

bool TableStore::reserve(std::size_t bytes) {
  if (bytes > limit_) return false;
  for (auto it = tables_.begin(); it != tables_.end() && used_ > limit_ - bytes;) {
    if (is_held_elsewhere(*it)) {
      ++it;
    } else {
      used_ -= bytes_of(*it->table);
      it = tables_.erase(it);
    }
  }
  if (used_ > limit_ - bytes) return false;
  used_ += bytes;
  return true;
}

void TableStore::release(std::size_t bytes) {
  assert(bytes <= used_);
  used_ -= bytes;
}

void TableStore::put(StoredTable table) {
  assert(!find(table.hash));
  tables_.push_back(std::move(table));
}

}  // namespace jounce
