// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/detail/local_velocities.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

// Fritsch and Carlson (SIAM J. Numer. Anal. 17, 1980): with alpha = v0 / d, beta = v1 / d, the
// cubic piece of chord d is monotone if and only if alpha, beta >= 0 and
//
//   (1)  2 alpha + beta <= 3   or   alpha + 2 beta <= 3
//        or   alpha^2 + alpha beta + beta^2 - 6 alpha - 6 beta + 9 <= 0
//
// This region contains the square [0, 3] x [0, 3]. If the chords d0 and d1 beside a knot have the
// same sign, Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5, 1984) use
//
//   (2)  v = (w0 + w1) / (w0 / d0 + w1 / d1),   w0 = 2 h1 + h0,  w1 = h1 + 2 h0
//
// and otherwise 0. v <= (w0 + w1) / w0 |d0| < 3 |d0|, and the same holds for d1: the result is
// inside the square.

namespace jounce::pvt_detail {
namespace {

/// The velocity at the end of the parabola through three points, limited to the square.
double open_end(double h0, double d0, double h1, double d1) {
  const double v = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (!(v > 0 && d0 > 0) && !(v < 0 && d0 < 0)) return 0;
  return std::abs(v) < 3 * std::abs(d0) ? v : 3 * d0;
}

}  // namespace

double between_chords(double h0, double d0, double h1, double d1) {
  if (!(d0 > 0 && d1 > 0) && !(d0 < 0 && d1 < 0)) return 0;
  const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
  const double smaller = std::abs(d0) < std::abs(d1) ? d0 : d1;
  // (2) divided by the smaller chord, because its reciprocal may overflow.
  const double mean = smaller * (w0 + w1) / (w0 * (smaller / d0) + w1 * (smaller / d1));
  return std::abs(mean) < 3 * std::abs(smaller) ? mean : 3 * smaller;
}

void monotone_velocities(const Chords& chords, bool periodic, std::span<double> v) {
  const auto& [h, d] = chords;
  const std::size_t last = d.size();
  for (std::size_t i = 1; i < last; ++i) v[i] = between_chords(h[i - 1], d[i - 1], h[i], d[i]);
  if (periodic) {
    v[0] = v[last] = between_chords(h[last - 1], d[last - 1], h[0], d[0]);
  } else if (last == 1) {
    v[0] = v[1] = d[0];
  } else {
    v[0] = open_end(h[0], d[0], h[1], d[1]);
    v[last] = open_end(h[last - 1], d[last - 1], h[last - 2], d[last - 2]);
  }
}

bool is_monotone(double chord, double v0, double v1) {
  if (chord == 0) return v0 == 0 && v1 == 0;
  const double a = v0 / chord, b = v1 / chord;
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  if (!(a >= 0 && b >= 0)) return false;
  if (2 * a + b <= 3 || a + 2 * b <= 3) return true;
  return a * a + a * b + b * b - 6 * a - 6 * b + 9 <= rounding;  // (1)
}

}  // namespace jounce::pvt_detail
