// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/cycle_motion.hpp"

#include <algorithm>
#include <cmath>

namespace jounce {
namespace {

bool is_plausible(double d, double v0, double v1, double dt) {
  if ((v0 > 0 && v1 < 0) || (v0 < 0 && v1 > 0))
    return d >= std::min(v0, v1) * dt && d <= std::max(v0, v1) * dt;
  const auto fits = [&](double v) { return v * d >= 0 && std::abs(v) * dt <= 3 * std::abs(d); };
  return fits(v0) && fits(v1);
}

}  // namespace

Segment cycle_motion(double x0, double v0, double x1, double v1, double dt) {
  return is_plausible(x1 - x0, v0, v1, dt) ? cubic(dt, x0, v0, x1, v1) : line(dt, x0, x1);
}

}  // namespace jounce
