// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace jounce {

/// The position of a rotary axis that shows `to`, nearest to `from`: at most half of `modulo` away. Half a turn goes
/// upwards. `modulo` = 0: a linear axis, which goes to `to`.
inline double shortest_way(double from, double to, double modulo) {
  if (!(modulo > 0)) return to;
  const double turns = std::floor((from - to) / modulo + 0.5);
  const double at = to + turns * modulo;
  return from - at >= modulo / 2 ? at + modulo : at;
}

}  // namespace jounce
