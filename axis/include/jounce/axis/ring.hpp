// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace jounce {

/// A queue from one thread to another. One thread pushes, the other pops, and neither waits.
///
///     Ring<Tick, 1024> ticks;
///     if (!ticks.push(tick)) ++lost;                   // the producer's thread
///     for (Tick next; ticks.pop(next);) log(next);     // the consumer's thread
///
/// The indices increase without end and are reduced modulo the capacity, which is a power of two.
/// Each index has its own cache line, together with a copy of the other index for its thread. So
/// the threads use the same cache line only when one of them refreshes its copy.
template <class T, std::size_t Capacity>
class Ring {
  static_assert(Capacity > 0 && (Capacity & (Capacity - 1)) == 0, "a power of two");
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Adds an item; called by the producer's thread. Returns false if the ring is full.
  bool push(const T& item) {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - seen_head_ == Capacity) seen_head_ = head_.load(std::memory_order_acquire);
    if (tail - seen_head_ == Capacity) return false;
    items_[tail % Capacity] = item;
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  /// Removes the oldest item; called by the consumer's thread. Returns false if the ring is empty.
  bool pop(T& item) {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == seen_tail_) seen_tail_ = tail_.load(std::memory_order_acquire);
    if (head == seen_tail_) return false;
    item = items_[head % Capacity];
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

 private:
  static constexpr std::size_t line = 64;  // bytes of a cache line

  alignas(line) std::atomic<std::size_t> tail_{0};  // written by the producer
  std::size_t seen_head_ = 0;
  alignas(line) std::atomic<std::size_t> head_{0};  // written by the consumer
  std::size_t seen_tail_ = 0;
  alignas(line) std::array<T, Capacity> items_{};
};

}  // namespace jounce
