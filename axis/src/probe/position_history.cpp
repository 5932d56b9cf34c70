// SPDX-License-Identifier: Apache-2.0
#include "axis/src/probe/position_history.hpp"

#include <cmath>

#include "jounce/profiles/curve/cycle_motion.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {

void PositionHistory::add(double dt, double position, double velocity) noexcept {
  newest_ = (newest_ + 1) % length;
  places_[newest_] = {dt, position, velocity};
}

void PositionHistory::shift(double by) noexcept {
  for (Place& place : places_) place.position += by;
}

double PositionHistory::before(double age) const noexcept {
  if (age == 0) return place(0).position;
  for (std::size_t back = 0; back + 1 < length; ++back) {
    const Place& b = place(back);
    const Place& a = place(back + 1);
    // A sum of cycles is not exact: the first instant of the oldest cycle still counts.
    if (age > b.dt * (1 + profiles_detail::rounded_input)) {
      age -= b.dt;
      continue;
    }
    const double s = std::fmax(1 - age / b.dt, 0);
    if (!std::isfinite(a.velocity + b.velocity)) return a.position + s * (b.position - a.position);
    return value(cycle_motion(a.position, a.velocity, b.position, b.velocity, b.dt), s);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace jounce
