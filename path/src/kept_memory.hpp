// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "jounce/profiles/detail/large_pages.hpp"

// Intermediate results of plan() take a third of its memory. For every new page, the operating system takes more time
// than the plan needs to fill it. A thread therefore keeps this memory for its next plan.
namespace jounce::path_detail {

constexpr std::size_t most_kept = std::size_t{16}
                                  << 20U;  ///< bytes of one type that a thread keeps

template <class T>
std::vector<T>& kept_memory() {
  thread_local std::vector<T> memory;
  return memory;
}

/// An empty vector with memory for `count` elements, if possible that of keep_memory().
template <class T>
std::vector<T> with_kept_memory(std::size_t count) {
  std::vector<T> memory = std::exchange(kept_memory<T>(), {});
  if (memory.capacity() < count) {
    memory = {};
    profiles_detail::reserve_large(memory, count);
  }
  return memory;
}

/// Keeps the memory of a vector, at most `most_kept`, for the next call of with_kept_memory() in this thread.
template <class T>
void keep_memory(std::vector<T>&& used) {
  std::vector<T> memory = std::move(used);
  memory.clear();
  if (memory.capacity() * sizeof(T) > most_kept) return;
  if (memory.capacity() > kept_memory<T>().capacity()) kept_memory<T>() = std::move(memory);
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
