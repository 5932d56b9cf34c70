// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace jounce {

/// Returns the position of a rotary axis that equals `to` modulo `modulo` and is nearest to `from`:
/// at most half a turn away. Of two positions half a turn away, it returns the greater one.
/// `modulo` = 0: a linear axis; returns `to`.
inline double shortest_way(double from, double to, double modulo) {
  if (!(modulo > 0)) return to;
  const double turns = std::floor((from - to) / modulo + 0.5);
  const double at = to + turns * modulo;
  return from - at >= modulo / 2 ? at + modulo : at;
}

}  // namespace jounce
