// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "jounce/axis/inputs.hpp"
#include "jounce/axis/movement.hpp"

/// Base of the movements with a live master.
namespace jounce::axis_detail {

/// True if the values of a master are usable: finite, and at most 1e50 (most_magnitude), so that
/// their squares and quotients are finite.
inline bool usable(const Jet& x) {
  return std::all_of(x.begin(), x.end(), [](double v) { return std::abs(v) <= most_magnitude; });
}

/// Returns the setpoint for a master and a slave, each with its derivatives.
inline Setpoint setpoint(const Jet& master, const Jet& slave) {
  return {master[0], master[1], slave};
}

}  // namespace jounce::axis_detail
