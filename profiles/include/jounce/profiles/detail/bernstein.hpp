// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::profiles_detail {

/// The Bernstein coefficients of a polynomial of degree n over an interval. The polynomial lies
/// within their hull, its derivative within n times the hull of their differences.
template <std::size_t n>
using Bernstein = std::array<double, n + 1>;

/// Returns the coefficients of the polynomial of f over the whole segment; f.degree <= n:
///
///     beta_i = sum over k <= i of C(i, k) / C(n, k) c_k
///
/// They are computed by repeated addition from the scaled c_k.
template <std::size_t n>
Bernstein<n> to_bernstein(const std::array<double, Segment::max_degree + 1>& c) {
  Bernstein<n> beta{};
  double binomial = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    beta[k] = c[k] / binomial;
    binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
  }
  for (std::size_t k = 1; k <= n; ++k)
    for (std::size_t i = n; i >= k; --i) beta[i] += beta[i - 1];
  return beta;
}

template <std::size_t n>
Bernstein<n> to_bernstein(const Segment& f) {
  return to_bernstein<n>(f.c);
}

/// Divides the interval at its middle (de Casteljau): the coefficients over both halves.
template <std::size_t n>
void halve(const Bernstein<n>& whole, Bernstein<n>& left, Bernstein<n>& right) {
  right = whole;
  for (std::size_t k = 0; k <= n; ++k) {
    left[k] = right[0];
    for (std::size_t i = 0; i + k < n; ++i) right[i] = (right[i] + right[i + 1]) / 2;
  }
}

/// Returns the least and the greatest coefficient.
template <std::size_t n>
std::pair<double, double> hull(const Bernstein<n>& beta) {
  double lo = beta[0];
  double hi = beta[0];
  for (std::size_t i = 1; i <= n; ++i) {
    lo = std::min(lo, beta[i]);
    hi = std::max(hi, beta[i]);
  }
  return {lo, hi};
}

/// Calls body(std::integral_constant<std::size_t, degree>); degree <= Segment::max_degree.
template <class Body>
void with_degree(std::size_t degree, Body body) {
  [&]<std::size_t... n>(std::index_sequence<n...>) {
    (void)((degree == n && (body(std::integral_constant<std::size_t, n>{}), true)) || ...);
  }
  (std::make_index_sequence<Segment::max_degree + 1>{});
}

}  // namespace jounce::profiles_detail
