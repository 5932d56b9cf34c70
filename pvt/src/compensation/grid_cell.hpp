// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "jounce/pvt/compensation.hpp"

namespace jounce::pvt_detail {

/// Coefficients of a polynomial or a series, truncated after the n-th term; n = 1: a number.
template <std::size_t n>
using Terms = std::array<double, n>;

template <std::size_t n>
Terms<n> product(const Terms<n>& a, const Terms<n>& b) {
  Terms<n> c{};
  for (std::size_t i = 0; i < n; ++i)
    if (a[i] != 0)
      for (std::size_t k = 0; i + k < n; ++k) c[i + k] += a[i] * b[k];
  return c;
}

/// Evaluates a cell; its coordinates are numbers, polynomials or series. Horner's rule along
/// `along` references, one after another, from the coefficient `first` on.
template <std::size_t n>
Terms<n> evaluated(const Compensation::Cell& cell, const std::array<Terms<n>, 3>& s,
                   std::size_t along, std::size_t first = 0) {
  if (along == 0) return {cell.k[first]};
  std::size_t stride = 1;
  for (std::size_t j = 1; j < along; ++j) stride *= cell.order;
  Terms<n> sum{};
  for (std::size_t e = cell.order; e-- > 0;) {
    sum = product(sum, s[along - 1]);
    const Terms<n> inner = evaluated(cell, s, along - 1, first + e * stride);
    for (std::size_t k = 0; k < n; ++k) sum[k] += inner[k];
  }
  return sum;
}

}  // namespace jounce::pvt_detail
