// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace jounce::detail {

/// Asks for large pages (2 MiB under Linux) where a block has room for some: a table of a million
/// knots is then given in a dozen pages rather than in thousands, one fault each. A hint, before the
/// block is first written; what is in it does not change.
void prefer_large_pages(void* block, std::size_t bytes) noexcept;

/// Memory for so many elements, asked for at once.
template <class T>
void reserve_large(std::vector<T>& column, std::size_t count) {
  column.reserve(count);
  prefer_large_pages(column.data(), column.capacity() * sizeof(T));
}

}  // namespace jounce::detail
