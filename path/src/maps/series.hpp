// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "path/src/maps/interval.hpp"

// Taylor arithmetic: computes the coefficients f^(k) / k! of an expression from the coefficients of
// its parts. With intervals for a whole part of a path, the results enclose the coefficients
// everywhere on this part.
namespace jounce::path_detail {

template <class T, std::size_t n>
struct Series {
  std::array<T, n> c{};

  Series() = default;
  Series(double x) { c[0] = T(x); }  // NOLINT: a number is a series

  T& operator[](std::size_t k) { return c[k]; }
  const T& operator[](std::size_t k) const { return c[k]; }
};

template <class T, std::size_t n>
Series<T, n> operator+(const Series<T, n>& f, const Series<T, n>& g) {
  Series<T, n> h;
  for (std::size_t k = 0; k < n; ++k) h[k] = f[k] + g[k];
  return h;
}
template <class T, std::size_t n>
Series<T, n> operator-(const Series<T, n>& f, const Series<T, n>& g) {
  Series<T, n> h;
  for (std::size_t k = 0; k < n; ++k) h[k] = f[k] - g[k];
  return h;
}
template <class T, std::size_t n>
Series<T, n> operator*(double a, const Series<T, n>& f) {
  Series<T, n> h;
  for (std::size_t k = 0; k < n; ++k) h[k] = T(a) * f[k];
  return h;
}
template <class T, std::size_t n>
Series<T, n> operator*(const Series<T, n>& f, const Series<T, n>& g) {
  Series<T, n> h;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; i + k < n; ++k) h[i + k] = h[i + k] + f[i] * g[k];
  return h;
}
template <class T, std::size_t n>
Series<T, n> squared(const Series<T, n>& f) {
  Series<T, n> h = f * f;
  h[0] = square(f[0]);
  return h;
}
template <class T, std::size_t n>
Series<T, n> operator/(const Series<T, n>& f, const Series<T, n>& g) {
  Series<T, n> h;
  for (std::size_t k = 0; k < n; ++k) {
    T rest = f[k];
    for (std::size_t i = 1; i <= k; ++i) rest = rest - g[i] * h[k - i];
    h[k] = rest / g[0];
  }
  return h;
}
template <class T, std::size_t n>
Series<T, n> root(const Series<T, n>& f) {
  Series<T, n> h;
  h[0] = root(f[0]);
  for (std::size_t k = 1; k < n; ++k) {
    T rest = f[k];
    for (std::size_t i = 1; i < k; ++i) rest = rest - h[i] * h[k - i];
    h[k] = rest / (T(2) * h[0]);
  }
  return h;
}

/// The angle of (c, s) in rad, by (c^2 + s^2) angle' = c s' - s c'.
template <class T, std::size_t n>
Series<T, n> angle(const Series<T, n>& c, const Series<T, n>& s) {
  const auto slope = [](const Series<T, n>& f) {
    Series<T, n> h;
    for (std::size_t k = 0; k + 1 < n; ++k) h[k] = T(static_cast<double>(k + 1)) * f[k + 1];
    return h;
  };
  const Series<T, n> rate = (c * slope(s) - s * slope(c)) / (squared(c) + squared(s));
  Series<T, n> h;
  h[0] = angle_of(c[0], s[0]);
  for (std::size_t k = 0; k + 1 < n; ++k) h[k + 1] = rate[k] / T(static_cast<double>(k + 1));
  return h;
}

/// Cosine and sine of an angle in rad.
template <class T, std::size_t n>
void cosine_and_sine(const Series<T, n>& f, Series<T, n>& c, Series<T, n>& s) {
  c[0] = cosine(f[0]);
  s[0] = sine(f[0]);
  for (std::size_t k = 1; k < n; ++k) {
    T dc{};
    T ds{};
    for (std::size_t i = 1; i <= k; ++i) {
      const T weight = T(static_cast<double>(i)) * f[i];
      dc = dc - weight * s[k - i];
      ds = ds + weight * c[k - i];
    }
    c[k] = dc / T(static_cast<double>(k));
    s[k] = ds / T(static_cast<double>(k));
  }
}

}  // namespace jounce::path_detail
