// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace jounce {

/// Durations counted in bins of powers of two: bin 0 below 1 us, bin k in [2^(k-1), 2^k) us, the
/// last one from 2^14 us (16.4 ms) on. One thread adds, any thread reads; neither waits.
///
///     Histogram lateness;
///     lateness.add(woken - due);                        // ns, the cyclic thread
///     send(lateness.counts());                          // communication thread
///     upper_bound(lateness.counts(), 0.999)             // us: 99.9 % were shorter
class Histogram {
 public:
  static constexpr std::size_t bins = 16;
  using Counts = std::array<std::int32_t, bins>;

  /// A negative duration counts as 0. A full bin stays full.
  void add(std::int64_t ns) noexcept;
  [[nodiscard]] Counts counts() const noexcept;

 private:
  std::array<std::atomic<std::int32_t>, bins> counts_{};
};

/// The upper end, us, of the bin in which the given share (0 to 1) of all durations is reached;
/// infinite for the last bin, 0 for an empty histogram.
double upper_bound(const Histogram::Counts& counts, double share);

}  // namespace jounce
