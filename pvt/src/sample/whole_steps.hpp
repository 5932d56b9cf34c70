// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace jounce::pvt_detail {

/// k steps. If 1 is a whole number of steps, such as 1 s of 0.001 s, it divides: 9 / 1000 is the
/// double nearest to 0.009, but 9 * 0.001 is not.
inline double steps(double k, double step) {
  const double per_unit = std::round(1 / step);
  const bool divides = step < 1 && std::abs(per_unit * step - 1) <= 1e-12;
  return divides ? k / per_unit : k * step;
}

/// The multiple of `step` nearest to x; x itself if the step is 0.
inline double rounded_to(double x, double step) {
  return step > 0 ? steps(std::round(x / step), step) : x;
}

/// True if x is a whole number of steps, to 1e-9 of a step and to rounding.
inline bool is_whole(double x, double step) {
  const double k = x / step;
  return std::abs(k - std::round(k)) <= 1e-9 + 4e-16 * std::abs(k);
}

}  // namespace jounce::pvt_detail
