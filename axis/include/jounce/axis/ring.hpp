// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace jounce {

/// A queue from one thread to another: one pushes, one pops; neither waits.
///
///     Ring<Tick, 1024> ticks;
///     if (!ticks.push(tick)) ++lost;                   // the producer's thread
///     for (Tick tick; ticks.pop(tick);) log(tick);     // the consumer's thread
///
/// Indices count up without end and are taken modulo the capacity; each is in its own cache line,
/// next to its thread's copy of the other index. The threads therefore share a line only when a
/// thread refreshes its copy.
template <class T, std::size_t Capacity>
class Ring {
  static_assert(Capacity > 0 && (Capacity & (Capacity - 1)) == 0, "a power of two");
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// False if the ring is full.
  bool push(const T& item) {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - seen_head_ == Capacity) seen_head_ = head_.load(std::memory_order_acquire);
    if (tail - seen_head_ == Capacity) return false;
    items_[tail % Capacity] = item;
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  /// False if the ring is empty.
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
