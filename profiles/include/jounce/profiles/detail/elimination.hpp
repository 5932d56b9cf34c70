// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <utility>

namespace jounce::profiles_detail {

/// Returns the x of A x = b by Gaussian elimination with row pivoting. For matrices of some ten
/// rows, without blocks, so that it compiles fast. The elements are a(i, j) and b(i), real or
/// complex. If A is singular, x is not finite.
template <class Matrix, class Vector>
Vector eliminated(Matrix a, Vector b) {
  using std::abs;
  using Index = decltype(a.rows());
  const Index n = a.rows();
  for (Index k = 0; k < n; ++k) {
    Index pivot = k;
    for (Index i = k + 1; i < n; ++i)
      if (abs(a(i, k)) > abs(a(pivot, k))) pivot = i;
    for (Index j = k; pivot != k && j < n; ++j) std::swap(a(k, j), a(pivot, j));
    std::swap(b(k), b(pivot));
    for (Index i = k + 1; i < n; ++i) a(i, k) /= a(k, k);
    for (Index i = k + 1; i < n; ++i) b(i) -= a(i, k) * b(k);
    for (Index j = k + 1; j < n; ++j)
      for (Index i = k + 1; i < n; ++i) a(i, j) -= a(i, k) * a(k, j);
  }
  for (Index k = n; k-- > 0;) {
    b(k) /= a(k, k);
    for (Index i = 0; i < k; ++i) b(i) -= a(i, k) * b(k);
  }
  return b;
}

}  // namespace jounce::profiles_detail
