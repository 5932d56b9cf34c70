// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {

/// Returns the largest sum of the magnitudes of steps within one tick, and its start. A single step
/// keeps its sign. `steps` ascend.
inline Jump largest_sum(std::span<const Jump> steps, double tick) {
  Jump largest;
  double sum = 0;  // sum of the magnitudes of steps [first, next)
  for (std::size_t first = 0, next = 0; first < steps.size(); ++first) {
    while (next < steps.size() &&
           steps[next].where < steps[first].where + tick * (1 - profiles_detail::rounded_input))
      sum += std::abs(steps[next++].step);
    const bool alone = next == first + 1;
    if (sum > std::abs(largest.step))
      largest = {alone ? steps[first].step : sum, steps[first].where};
    sum = alone ? 0 : sum - std::abs(steps[first].step);
  }
  return largest;
}

}  // namespace jounce
