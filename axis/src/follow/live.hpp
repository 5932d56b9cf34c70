// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "jounce/axis/inputs.hpp"
#include "jounce/axis/movement.hpp"

/// Base of the movements with a live master.
namespace jounce::detail {

/// Numbers that a master may have: finite, and small enough for their squares and quotients to be.
inline bool usable(const Jet& x) {
  return std::all_of(x.begin(), x.end(), [](double v) { return std::abs(v) <= most_magnitude; });
}

inline Setpoint setpoint(const Jet& master, const Jet& slave) {
  return {master[0], master[1], slave};
}

}  // namespace jounce::detail
