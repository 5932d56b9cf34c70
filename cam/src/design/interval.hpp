// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jounce::cam_detail {

/// All numbers from lo to hi. The result of an operation contains the results for all members of
/// its arguments, to rounding (a few 1e-16 of the magnitudes; rounding is not directed).
struct Interval {
  double lo = 0;
  double hi = 0;

  constexpr Interval() = default;
  constexpr Interval(double value) : lo(value), hi(value) {}  // NOLINT: a number is an interval
  constexpr Interval(double l, double h) : lo(l), hi(h) {}

  [[nodiscard]] double middle() const { return lo + (hi - lo) / 2; }
  [[nodiscard]] double magnitude() const { return std::max(std::abs(lo), std::abs(hi)); }
  [[nodiscard]] bool has_zero() const { return !(lo > 0 || hi < 0); }
};

/// An interval without bounds.
inline constexpr Interval everything{-std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity()};

inline Interval operator-(Interval a) {
  return {-a.hi, -a.lo};
}
inline Interval operator+(Interval a, Interval b) {
  return {a.lo + b.lo, a.hi + b.hi};
}
inline Interval operator-(Interval a, Interval b) {
  return {a.lo - b.hi, a.hi - b.lo};
}
inline Interval operator*(Interval a, Interval b) {
  const double p = a.lo * b.lo;
  const double q = a.lo * b.hi;
  const double r = a.hi * b.lo;
  const double s = a.hi * b.hi;
  if (std::isnan(p + q + r + s)) return everything;  // 0 times infinity, or opposite infinities
  return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}
inline Interval operator/(Interval a, Interval b) {
  if (b.has_zero()) return everything;
  return a * Interval{1 / b.hi, 1 / b.lo};
}

inline Interval square(Interval a) {
  const double greatest = a.magnitude() * a.magnitude();
  const double least = std::min(std::abs(a.lo), std::abs(a.hi));
  return {a.has_zero() ? 0 : least * least, greatest};
}

inline Interval sqrt(Interval a) {
  return {std::sqrt(std::max(0.0, a.lo)), std::sqrt(std::max(0.0, a.hi))};
}

inline Interval sin(Interval a) {
  constexpr double turn = 2 * std::numbers::pi;
  if (!(a.hi - a.lo < turn)) return {-1, 1};
  // True if a contains a point at which the sine is 1, or -1. `at` is one such point.
  const auto holds = [&](double at) { return std::ceil((a.lo - at) / turn) * turn + at <= a.hi; };
  const double l = std::sin(a.lo);
  const double h = std::sin(a.hi);
  return {holds(-turn / 4) ? -1 : std::min(l, h), holds(turn / 4) ? 1 : std::max(l, h)};
}

inline Interval cos(Interval a) {
  return sin(a + Interval{std::numbers::pi / 2});
}

}  // namespace jounce::cam_detail
