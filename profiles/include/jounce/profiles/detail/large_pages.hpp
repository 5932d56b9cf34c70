// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace jounce::profiles_detail {

/// Requests large pages (2 MiB on Linux) for a block that is large enough. A table of a million
/// knots then needs about a dozen page faults instead of thousands. This is a hint; call it before
/// the first write to the block. The content does not change.
void prefer_large_pages(void* block, std::size_t bytes) noexcept;

/// Reserves memory for `count` elements, with large pages.
template <class T>
void reserve_large(std::vector<T>& column, std::size_t count) {
  column.reserve(count);
  prefer_large_pages(column.data(), column.capacity() * sizeof(T));
}

}  // namespace jounce::profiles_detail
