// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

#include "jounce/path/point.hpp"

// Vectors of a group, always with nine components; components without an axis are 0.
namespace jounce::vec {

inline Point sum(const Point& a, const Point& b, double factor = 1) {  // a + factor b
  Point c;
  for (std::size_t i = 0; i < max_axes; ++i) c[i] = a[i] + factor * b[i];
  return c;
}

inline Point difference(const Point& a, const Point& b) {
  return sum(a, b, -1);
}

inline Point scaled(const Point& a, double factor) {
  Point c;
  for (std::size_t i = 0; i < max_axes; ++i) c[i] = factor * a[i];
  return c;
}

/// The first n components; all others are 0.
inline Point first(const Point& a, std::size_t n) {
  Point c{};
  for (std::size_t i = 0; i < n; ++i) c[i] = a[i];
  return c;
}

/// Scalar product over the first n axes.
inline double dot(const Point& a, const Point& b, std::size_t n = max_axes) {
  double s = 0;
  for (std::size_t i = 0; i < n; ++i) s += a[i] * b[i];
  return s;
}

/// Length over the first n axes.
inline double norm(const Point& a, std::size_t n = max_axes) {
  return std::sqrt(dot(a, a, n));
}

inline double distance(const Point& a, const Point& b, std::size_t n = max_axes) {
  return norm(difference(a, b), n);
}

/// The part of a that is perpendicular to the unit vector e.
inline Point perpendicular(const Point& a, const Point& e) {
  return sum(a, e, -dot(a, e));
}

}  // namespace jounce::vec
