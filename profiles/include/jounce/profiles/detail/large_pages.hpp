// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace jounce::profiles_detail {

/// Requests large pages (2 MiB under Linux) if a block is large enough: a table of a million knots
/// then takes a dozen pages instead of thousands, one page fault each. A hint, before the block is
/// first written; its content does not change.
void prefer_large_pages(void* block, std::size_t bytes) noexcept;

/// Memory for so many elements, asked for at once.
template <class T>
void reserve_large(std::vector<T>& column, std::size_t count) {
  column.reserve(count);
  prefer_large_pages(column.data(), column.capacity() * sizeof(T));
}

}  // namespace jounce::profiles_detail
