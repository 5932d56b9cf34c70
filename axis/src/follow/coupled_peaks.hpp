// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "jounce/axis/movement.hpp"

namespace jounce {

/// Returns the greatest magnitudes that a slave needs anywhere on its coupling. `slopes`: the
/// greatest magnitudes k1, k2, k3 of its derivatives with respect to the master, u/m, u/m^2, u/m^3.
/// `master`: magnitudes v, a, j of the master: m/s, m/s^2, m/s^3. u is the unit of the slave, m the
/// unit of the master.
///
///     velocity k1 v      acceleration k1 a + k2 v^2      jerk k1 j + 3 k2 v a + k3 v^3
inline Peaks coupled_peaks(const std::array<double, 3>& slopes, const Peaks& master) noexcept {
  const auto [k1, k2, k3] = slopes;
  const double v = master.velocity;
  const double a = master.acceleration;
  return {.velocity = k1 * v,
          .acceleration = k1 * a + k2 * v * v,
          .jerk = k1 * master.jerk + 3 * k2 * v * a + k3 * v * v * v};
}

}  // namespace jounce
