// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce::profiles_detail {

inline constexpr double rounding = 0x1p-49;  ///< relative: eight units in the last place
inline constexpr double two_pi = 2 * std::numbers::pi;
inline constexpr double inf = std::numeric_limits<double>::infinity();

inline double square(double x) {
  return x * x;
}

inline double cube(double x) {
  return x * x * x;
}

/// Returns the square root; 0 if rounding made x negative.
inline double root(double x) {
  return std::sqrt(std::max(x, 0.0));
}

/// `which ? a : b` without a branch, for an unpredictable condition.
inline double either(bool which, double a, double b) {
  const double pair[] = {b, a};
  return pair[which];
}

}  // namespace jounce::profiles_detail
