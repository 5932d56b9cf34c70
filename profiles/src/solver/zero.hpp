// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

namespace jounce::profiles_detail {

/// Newton's step; NaN if f does not have the direction that it has at the zero.
inline double newton(double f, double slope, bool rising) {
  return (slope > 0) == rising ? f / slope : std::numeric_limits<double>::quiet_NaN();
}

/// The zero of a monotone f in [lo, hi], or the nearer end if there is none. f returns a step and
/// sets the sign of its value. The iteration starts at a guess, and bisection keeps it inside.
template <class F>
double zero(F f, double lo, double hi, bool rising, double guess) {
  double x = guess > lo && guess < hi ? guess : lo + (hi - lo) / 2;
  for (int i = 0; i < 250; ++i) {
    double sign = 0;
    const double step = f(x, sign);
    if (sign == 0) break;
    ((sign < 0) == rising ? lo : hi) = x;
    double next = x - step;
    const bool inside = next > lo && next < hi;
    // The convergence is at least quadratic, so the step after such a step is within rounding.
    const bool done = std::abs(step) <= 1e-9 * std::abs(x);
    // If the range covers many decades, steps by a factor would take too long.
    if (!done && i > 8 && i % 2 == 0 && lo >= 0 && hi > 4 * lo)
      next = lo > 0 ? std::sqrt(lo * hi) : hi * 0x1p-20;
    else if (!inside || i > 160) {
      if (done) return next > lo ? hi : lo;
      next = lo + (hi - lo) / 2;
      if (!(next > lo && next < hi)) break;
    }
    x = next;
    if (done) break;
  }
  return x;
}

}  // namespace jounce::profiles_detail
