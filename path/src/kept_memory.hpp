// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "jounce/profiles/detail/large_pages.hpp"

// Intermediate results of plan() take half of its memory. For every new page, the operating system takes more time
// than the plan needs to fill it. A thread therefore keeps this memory for its next plan: about 400 bytes for each line.
namespace jounce::path_detail {

constexpr std::size_t most_kept = std::size_t{16} << 20U;  ///< bytes of a block that a thread keeps
constexpr std::size_t most_blocks = 3;  ///< blocks of one type that a thread keeps

/// In descending order of their sizes.
template <class T>
std::array<std::vector<T>, most_blocks>& kept_memory() {
  thread_local std::array<std::vector<T>, most_blocks> memory;
  return memory;
}

/// An empty vector with memory for `count` elements, if possible the smallest of keep_memory() that suffices.
template <class T>
std::vector<T> with_kept_memory(std::size_t count) {
  auto& kept = kept_memory<T>();
  std::vector<T> memory;
  for (std::size_t i = most_blocks; i-- > 0;)
    if (kept[i].capacity() >= count) {
      memory = std::move(kept[i]);
      std::move(kept.begin() + i + 1, kept.end(), kept.begin() + i);
      return memory;
    }
  kept.back() = {};
  profiles_detail::reserve_large(memory, count);
  return memory;
}

/// Keeps the memory of a vector, at most `most_kept`, for the next call of with_kept_memory() in this thread.
template <class T>
void keep_memory(std::vector<T>&& used) {
  std::vector<T> memory = std::move(used);
  memory.clear();
  if (memory.capacity() * sizeof(T) > most_kept) return;
  for (std::vector<T>& kept : kept_memory<T>())
    if (memory.capacity() > kept.capacity()) std::swap(memory, kept);
}

/// Appends an element with its default values, whose members are then written in place. A copy of a local element would
/// load several of its members at once, and wait until the processor has stored them.
template <class T>
T& append_blank(std::vector<T>& to) {
  static constexpr T blank;
  to.push_back(blank);
  return to.back();
}

}  // namespace jounce::path_detail
