// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>

namespace jounce {

/// Passes the newest value from one writer to readers; neither side waits for the other. The class
/// works in memory that two processes share. Memory that contains only zeros is a valid state, with
/// a value of zeros.
///
///     lock.write(outputs);                     // the writer
///     if (auto now = lock.read()) use(*now);   // nullopt: a write was in progress each time
///
/// Source: H.-J. Boehm, "Can seqlocks get along with programming language memory models?" (MSPC
/// 2012). The words of the value are atomics, and their memory order replaces fences: a reader that
/// has read a word of the next value also reads the odd sequence number of the write in progress.
template <class T>
class Seqlock {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  static constexpr int tries = 16;  ///< attempts of a read

  /// Stores the value. Call from one thread only.
  void write(const T& value) noexcept {
    Words words{};
    std::memcpy(words.data(), &value, sizeof value);
    const std::uint64_t sequence = sequence_.load(std::memory_order_relaxed);
    sequence_.store(sequence + 1, std::memory_order_relaxed);  // odd: incomplete
    for (std::size_t i = 0; i < words.size(); ++i)
      words_[i].store(words[i], std::memory_order_release);  // after the odd number
    sequence_.store(sequence + 2, std::memory_order_release);
  }

  /// Returns the newest value; nullopt if a write was in progress at each attempt.
  [[nodiscard]] std::optional<T> read() const noexcept {
    for (int i = 0; i < tries; ++i) {
      const std::uint64_t before = sequence_.load(std::memory_order_acquire);
      if (before % 2 != 0) continue;
      Words words;
      for (std::size_t k = 0; k < words.size(); ++k)
        words[k] = words_[k].load(std::memory_order_acquire);  // before the second sequence read
      if (sequence_.load(std::memory_order_relaxed) != before) continue;
      T value;
      std::memcpy(static_cast<void*>(&value), words.data(), sizeof value);
      return value;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t count = (sizeof(T) + 7) / 8;
  using Words = std::array<std::uint64_t, count>;

  std::atomic<std::uint64_t> sequence_{0};
  std::array<std::atomic<std::uint64_t>, count> words_{};
};

}  // namespace jounce
