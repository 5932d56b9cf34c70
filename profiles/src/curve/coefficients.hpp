// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace jounce::profiles_detail {

/// The coefficients with respect to s in [0, 1] of the segments that jounce::line, cubic and
/// quintic make.
inline std::array<double, 2> line_coefficients(double p0, double p1) {
  return {p0, p1 - p0};
}

inline std::array<double, 4> cubic_coefficients(double length, double p0, double v0, double p1,
                                                double v1) {
  const double h = p1 - p0;
  const double m0 = v0 * length;
  const double m1 = v1 * length;
  return {p0, m0, 3 * h - 2 * m0 - m1, -2 * h + m0 + m1};
}

/// The general polynomial of degree 5 (VDI 2143), as a function of the values at the ends of the
/// segment.
inline std::array<double, 6> quintic_coefficients(double length, double p0, double v0, double a0,
                                                  double p1, double v1, double a1) {
  const double h = p1 - p0;
  const double m0 = v0 * length;
  const double m1 = v1 * length;
  const double k0 = a0 * length * length;
  const double k1 = a1 * length * length;
  return {p0,
          m0,
          k0 / 2,
          10 * h - 6 * m0 - 4 * m1 - (3 * k0 - k1) / 2,
          -15 * h + 8 * m0 + 7 * m1 + (3 * k0 - 2 * k1) / 2,
          6 * h - 3 * (m0 + m1) - (k0 - k1) / 2};
}

}  // namespace jounce::profiles_detail
