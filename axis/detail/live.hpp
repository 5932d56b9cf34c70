#pragma once

#include <algorithm>
#include <cmath>

#include "jounce/axis/movement.hpp"

/// What movements behind a live master share.
namespace jounce::detail {

inline bool finite(const Jet& x) {
  return std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
}

inline Setpoint setpoint(const Jet& master, const Jet& slave) {
  return {master[0], master[1], slave};
}

}  // namespace jounce::detail
