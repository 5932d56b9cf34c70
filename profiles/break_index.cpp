#include "jounce/profiles/break_index.hpp"

#include <cassert>
#include <cmath>

namespace jounce {

BreakIndex::BreakIndex(std::span<const double> breaks) {
  assert(breaks.size() >= 2);
  const std::size_t intervals = breaks.size() - 1;
  const std::size_t cells = per_interval * intervals;
  const double scale = static_cast<double>(cells) / (breaks.back() - breaks.front());
  // Few are searched at once; so are lengths whose reciprocal over- or underflows.
  if (intervals <= few || !std::isnormal(scale)) return;
  start_ = breaks.front();
  cells_per_unit_ = scale;
  last_cell_ = static_cast<double>(cells - 1);
  before_.assign(cells + 1, 0);
  for (const double at : breaks.subspan(1, intervals - 1)) ++before_[cell(at) + 1];
  for (std::size_t k = 0; k < cells; ++k) before_[k + 1] += before_[k];
}

}  // namespace jounce
