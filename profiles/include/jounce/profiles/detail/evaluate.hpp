// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::profiles_detail {

/// True if a curve with this policy has no value at x: at NaN, and if it is periodic at infinity.
inline bool is_nowhere(double x, Extrapolation outside) {
  return std::isnan(x) || (std::isinf(x) && repeats(outside));
}

/// The value and the derivatives at such a place.
inline constexpr Jet not_a_number{
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

/// c[0] + c[1] s + ... + c[n] s^n with its three derivatives with respect to s. Horner's rule for
/// the value and for the derivatives / k!, without the first steps, which would only add zeros.
template <std::size_t n, std::size_t capacity>
[[gnu::always_inline]] inline Jet horner(const std::array<double, capacity>& c, double s) {
  static_assert(n < capacity);
  double p = c[n];
  double d1 = 0;
  double d2 = 0;
  double d3 = 0;
  for (std::size_t step = 1; step <= n; ++step) {
    if (step > 3) d3 = d3 * s + d2;
    if (step == 3) d3 = d2;
    if (step > 2) d2 = d2 * s + d1;
    if (step == 2) d2 = d1;
    if (step > 1) d1 = d1 * s + p;
    if (step == 1) d1 = p + 0.0;  // never -0
    p = p * s + c[n - step];
  }
  return {p, d1, 2 * d2, 6 * d3};
}

/// Converts derivatives with respect to s to derivatives with respect to u = length * s.
inline Jet over_length(const Jet& by_s, double length) {
  const double r = 1 / length;
  return {by_s[0], by_s[1] * r, by_s[2] * r * r, by_s[3] * r * r * r};
}

/// The polynomial of f and its derivatives with respect to s.
[[gnu::always_inline]] inline Jet polynomial(const Segment& f, double s) {
  const auto& c = f.c;
  switch (f.degree) {
    case 0:
      return horner<0>(c, s);
    case 1:
      return horner<1>(c, s);
    case 2:
      return horner<2>(c, s);
    case 3:
      return horner<3>(c, s);
    case 4:
      return horner<4>(c, s);
    case 5:
      return horner<5>(c, s);
    case 6:
      return horner<6>(c, s);
    case 7:
      return horner<7>(c, s);
    case 8:
      return horner<8>(c, s);
    case 9:
      return horner<9>(c, s);
    case 10:
      return horner<10>(c, s);
    default:
      return horner<11>(c, s);
  }
}

/// evaluate() for a segment with sines; out of line, because most segments have none.
Jet evaluate_with_sines(const Segment& f, double s);

/// An inlined jounce::evaluate(), for evaluation loops.
[[gnu::always_inline]] inline Jet evaluate(const Segment& f, double s) {
  if (f.sines > 0) [[unlikely]]
    return evaluate_with_sines(f, s);
  return over_length(polynomial(f, s), f.length);
}

}  // namespace jounce::profiles_detail
