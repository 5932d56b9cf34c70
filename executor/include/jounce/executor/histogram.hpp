// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace jounce {

/// A histogram of durations in bins of powers of two. Bin 0 counts durations below 1 us, bin k
/// counts durations in [2^(k-1), 2^k) us; the last bin begins at 2^14 us (16.4 ms). One thread adds
/// durations, any thread reads the counts, and neither waits.
///
///     Histogram lateness;
///     lateness.add(woken - due);                        // ns, the cyclic thread
///     use(upper_bound(lateness.counts(), 0.999));       // us: 99.9 % were shorter; any thread
class Histogram {
 public:
  static constexpr std::size_t bins = 16;  ///< number of bins
  using Counts = std::array<std::int32_t, bins>;

  /// Adds a duration, ns. A negative duration counts as 0. A count does not overflow: it stays at
  /// its maximum.
  void add(std::int64_t ns) noexcept;
  /// The counts of all bins.
  [[nodiscard]] Counts counts() const noexcept;

 private:
  std::array<std::atomic<std::int32_t>, bins> counts_{};
};

/// Returns a duration (us) below which at least the given share (0 to 1) of all durations lies: the
/// upper end of a bin. Returns infinity for the last bin, and 0 for an empty histogram.
double upper_bound(const Histogram::Counts& counts, double share);

}  // namespace jounce
