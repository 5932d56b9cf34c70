// SPDX-License-Identifier: Apache-2.0
#include "path/src/geometry/septic.hpp"

namespace jounce {

Segment septic(double length, const Jet& a, const Jet& b) {
  const double h = length;
  Segment f;
  f.length = h;
  f.degree = 7;
  f.c[0] = a[0];
  f.c[1] = a[1] * h;
  f.c[2] = a[2] * h * h / 2;
  f.c[3] = a[3] * h * h * h / 6;
  // The differences of the cubic from the required values at the other end.
  const double d0 = b[0] - a[0] - (f.c[1] + f.c[2] + f.c[3]);
  const double d1 = b[1] * h - (f.c[1] + 2 * f.c[2] + 3 * f.c[3]);
  const double d2 = b[2] * h * h - (2 * f.c[2] + 6 * f.c[3]);
  const double d3 = b[3] * h * h * h - 6 * f.c[3];
  f.c[4] = 35 * d0 - 15 * d1 + 2.5 * d2 - d3 / 6;
  f.c[5] = -84 * d0 + 39 * d1 - 7 * d2 + d3 / 2;
  f.c[6] = 70 * d0 - 34 * d1 + 6.5 * d2 - d3 / 2;
  f.c[7] = -20 * d0 + 10 * d1 - 2 * d2 + d3 / 6;
  return f;
}

}  // namespace jounce
