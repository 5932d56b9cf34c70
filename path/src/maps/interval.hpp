// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

// Intervals that contain every value of an expression. Each operation widens its result by more
// than its rounding error, so no rounding mode is set. Division by an interval that contains 0, and
// the root of one that is not positive, give the whole line.
namespace jounce::path_detail {

struct Interval {
  double low = 0, high = 0;

  Interval() = default;
  Interval(double x) : low(x), high(x) {}  // NOLINT: a number is an interval
  Interval(double a, double b) : low(a), high(b) {}

  static Interval whole() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  [[nodiscard]] double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
};

/// [a, b] widened by two units in the last place; the whole line if a bound is not a number.
inline Interval outward(double a, double b, double share = 4.5e-16) {
  if (std::isnan(a) || std::isnan(b)) return Interval::whole();
  constexpr double tiny = 1e-300;
  return {a - std::abs(a) * share - tiny, b + std::abs(b) * share + tiny};
}

inline Interval operator+(const Interval& a, const Interval& b) {
  return outward(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) {
  return outward(a.low - b.high, a.high - b.low);
}
inline Interval operator*(const Interval& a, const Interval& b) {
  if (a.low == 0 && a.high == 0) return a;
  if (b.low == 0 && b.high == 0) return b;
  const double p = a.low * b.low;
  const double q = a.low * b.high;
  const double r = a.high * b.low;
  const double s = a.high * b.high;
  if (std::isnan(p + q + r + s)) return Interval::whole();
  return outward(std::min({p, q, r, s}), std::max({p, q, r, s}));
}
inline Interval operator/(const Interval& a, const Interval& b) {
  if (!(b.low > 0) && !(b.high < 0)) return Interval::whole();
  return a * outward(1 / b.high, 1 / b.low);
}
inline Interval root(const Interval& a) {
  if (!(a.low > 0)) return Interval::whole();
  return outward(std::sqrt(a.low), std::sqrt(a.high));
}
inline Interval square(const Interval& a) {
  const Interval p = a * a;
  const bool zero = a.low <= 0 && a.high >= 0;
  return {zero ? 0.0 : std::max(0.0, p.low), p.high};
}
/// Uses sin(m + d) = sin m cos d + cos m sin d for |d| <= r.
inline Interval sine(const Interval& a) {
  const double m = (a.low + a.high) / 2;
  const double r = (a.high - a.low) / 2 * (1 + profiles_detail::rounded_digit) +
                   profiles_detail::rounded_digit * std::abs(m);
  if (!(r < 1.5)) return {-1, 1};
  const Interval sn = outward(std::sin(m), std::sin(m), profiles_detail::rounded_digit) *
                      Interval(std::cos(r) * (1 - profiles_detail::rounded_digit), 1);
  const double spread = (std::abs(std::cos(m)) + profiles_detail::rounded_digit) * r;  // sin r <= r
  const Interval sum = sn + Interval(-spread, spread);
  return {std::max(-1.0, sum.low), std::min(1.0, sum.high)};
}
inline Interval cosine(const Interval& a) {
  return sine(a + outward(profiles_detail::two_pi / 4, profiles_detail::two_pi / 4));
}
/// The whole line: bounds of derivatives do not need the value of the angle.
inline Interval angle_of(const Interval& c, const Interval& s) {
  static_cast<void>(c);
  static_cast<void>(s);
  return {-4, 4};
}

inline double root(double a) {
  return std::sqrt(a);
}
inline double square(double a) {
  return a * a;
}
inline double sine(double a) {
  return std::sin(a);
}
inline double cosine(double a) {
  return std::cos(a);
}
inline double angle_of(double c, double s) {
  return std::atan2(s, c);
}

}  // namespace jounce::path_detail
