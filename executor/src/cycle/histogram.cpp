// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/histogram.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace jounce {

void Histogram::add(std::int64_t ns) noexcept {
  const auto us = static_cast<std::uint64_t>(std::max<std::int64_t>(ns, 0)) / 1000;
  const auto bin = std::min(static_cast<std::size_t>(std::bit_width(us)), bins - 1);
  auto& count = counts_[bin];
  const std::int32_t before = count.load(std::memory_order_relaxed);
  if (before < std::numeric_limits<std::int32_t>::max())
    count.store(before + 1, std::memory_order_relaxed);
}

Histogram::Counts Histogram::counts() const noexcept {
  Counts counts{};
  for (std::size_t i = 0; i < bins; ++i) counts[i] = counts_[i].load(std::memory_order_relaxed);
  return counts;
}

double upper_bound(const Histogram::Counts& counts, double share) {
  const auto all = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  if (all == 0) return 0;
  std::int64_t seen = 0;
  for (std::size_t i = 0; i + 1 < Histogram::bins; ++i) {
    seen += counts[i];
    if (static_cast<double>(seen) >= share * static_cast<double>(all))
      return static_cast<double>(std::int64_t{1} << i);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace jounce
