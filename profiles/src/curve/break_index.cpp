// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/break_index.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "jounce/profiles/detail/large_pages.hpp"

namespace jounce {

BreakIndex::BreakIndex(std::span<const double> breaks) {
  assert(breaks.size() >= 2);
  const std::size_t intervals = breaks.size() - 1;
  const std::size_t cells = per_interval * intervals;
  const double scale = static_cast<double>(cells) / (breaks.back() - breaks.front());
  // For few breaks an index does not pay. If the reciprocal of the length over- or underflows,
  // there is no index.
  if (intervals <= few || !std::isnormal(scale)) return;
  start_ = breaks.front();
  cells_per_unit_ = scale;
  last_cell_ = static_cast<double>(cells - 1);
  profiles_detail::reserve_large(before_, cells + 2);
  before_.resize(cells + 2);
  // Breaks ascend, and so do their cells: up to that of break i, i - 1 interior ones lie before.
  // Two cells are always written, as many as each of equal intervals has. Surplus cells are
  // overwritten.
  std::uint32_t* next = before_.data();
  for (std::uint32_t i = 1; i < intervals; ++i) {
    std::uint32_t* const end = before_.data() + cell(breaks[i]) + 1;
    next[0] = next[1] = i - 1;
    if (end > next + 2) std::fill(next + 2, end, i - 1);
    next = end;
  }
  std::fill(next, before_.data() + cells + 1, static_cast<std::uint32_t>(intervals - 1));
}

}  // namespace jounce
