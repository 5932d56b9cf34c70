// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// Raises a peak to a value whose magnitude is greater.
inline void raise(Peak& peak, double value, double where) {
  if (std::abs(value) > std::abs(peak.value)) peak = {value, where};
}

/// Calls see(value, where) with the three values at t, t + h, t + 2 h. If the vertex of the
/// parabola through them is between them, also calls it with the vertex.
template <class See>
void see_parabola(const std::array<double, 3>& f, double t, double h, See see) {
  for (std::size_t i = 0; i < f.size(); ++i) see(f[i], t + static_cast<double>(i) * h);
  const double slope = (f[2] - f[0]) / 2;
  const double bend = f[0] - 2 * f[1] + f[2];
  if (std::abs(slope) < std::abs(bend))
    see(f[1] - slope * slope / (2 * bend), t + h * (1 - slope / bend));
}

}  // namespace jounce::validate_detail
