// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pvt/src/table/piece.hpp"

// Bounds of every interval of a table, computed in vectors of intervals. Let c be the coefficients
// of a polynomial of degree n on s in [0, 1]. Except for the first, its Bernstein coefficients are
//
//   (1)  b_i - c_0 = sum over 1 <= k <= i of C(i, k) / C(n, k) c_k,
//
// The polynomial lies between the least and the greatest of them. The rounded results of an exact
// search lie there, too, if the hull is wider by
//
//   (2)  e = 64 eps sum over k >= 1 of |c_k|,   eps = 2^-53,
//
// which covers the rounding of Horner's rule, of (1), and of the coefficients. In both, the
// addition of c_0 comes last and rounds monotonically. So the bound of a constant is exactly this
// constant, and none of a million intervals at rest exceeds the first.
namespace jounce::pvt_detail {

/// Results for at most `size` intervals, for the value and three derivatives: the bounds of f [0]
/// and of -f [1]; and the greatest values that are certainly reached.
struct Hulls {
  static constexpr std::size_t size = 256;

  alignas(64) double bound[4][2][size];
  double greatest[4][2];  ///< greatest of the bounds; NaN or infinite if any bound is
  double taken[4][2];
};

/// Computes intervals [first, first + n), 1 <= n <= Hulls::size.
using HullKernel = void (*)(const KnotColumns&, Interpolation, std::size_t first, std::size_t n,
                            Hulls&);
void hulls_anywhere(const KnotColumns&, Interpolation, std::size_t, std::size_t, Hulls&);
void hulls_avx2(const KnotColumns&, Interpolation, std::size_t, std::size_t, Hulls&);
void hulls_avx512(const KnotColumns&, Interpolation, std::size_t, std::size_t, Hulls&);

/// The kernel with the widest vectors that this processor supports.
HullKernel hull_kernel();

JOUNCE_INLINE constexpr double binomial(int n, int k) {
  double b = 1;
  for (int i = 0; i < k; ++i) b = b * (n - i) / (i + 1);
  return b;
}

/// The running maxima of a chunk, separate for each lane; a NaN stays.
template <class Real>
struct Maxima {
  Real greatest[4][2];
  Real taken[4][2];
};

/// Computes (1) and (2) for the polynomial c[0..n]: stores the bounds of interval i, and updates
/// the maxima.
template <int n, class Real>
JOUNCE_INLINE void enclose(const Real* c, int order, std::size_t i, Hulls& out, Maxima<Real>& max) {
  Real b[n + 1];
  Real size = profiles_detail::every<Real>(0);
  b[0] = profiles_detail::every<Real>(0);
  for (int k = 1; k <= n; ++k) {
    b[k] = c[k] * (1 / binomial(n, k));
    size = size + profiles_detail::magnitude(c[k]);
  }
  for (int k = 1; k <= n; ++k)
    for (int m = n; m >= k; --m) b[m] = b[m] + b[m - 1];
  Real high = b[0];
  Real low = b[0];
  for (int k = 1; k <= n; ++k) {
    high = profiles_detail::greatest(b[k], high);
    low = profiles_detail::least(b[k], low);
  }
  const Real e = size * (64 * 0x1p-53);
  const Real bound[2]{c[0] + (high + e), -(c[0] + (low - e))};
  const Real taken[2]{profiles_detail::greatest(c[0], c[0] + (b[n] - e)),
                      -profiles_detail::least(c[0], c[0] + (b[n] + e))};
  for (int side = 0; side < 2; ++side) {
    profiles_detail::store(out.bound[order][side] + i, bound[side]);
    // Written as "not less", so that a NaN is kept.
    max.greatest[order][side] =
        bound[side] <= max.greatest[order][side] ? max.greatest[order][side] : bound[side];
    max.taken[order][side] = profiles_detail::greatest(taken[side], max.taken[order][side]);
  }
}

/// Computes the bounds of interval i of the table and of the intervals in the next lanes; `at` is
/// its index in the chunk. The first coefficients are divided repeatedly, as in jounce::derivative;
/// the others are multiplied by 1/L.
template <class Real, int degree>
JOUNCE_INLINE void enclose_interval(const KnotColumns& t, std::size_t i, std::size_t at, Hulls& out,
                                    Maxima<Real>& max) {
  const auto column = [&](const double* c, std::size_t k) __attribute__((always_inline)) {
    if constexpr (profiles_detail::lanes<Real> == 1)
      return c[k];
    else
      return profiles_detail::load<Real>(c + k);
  };
  const Real length = column(t.x, i + 1) - column(t.x, i);
  const Real p0 = column(t.p, i);
  const Real h = column(t.p, i + 1) - p0;
  const Real zero[1]{profiles_detail::every<Real>(0)};
  if constexpr (degree == 1) {
    const Real p[2]{p0, h};
    const Real v[1]{h / length};
    enclose<1>(p, 0, at, out, max);
    enclose<0>(v, 1, at, out, max);
    enclose<0>(zero, 2, at, out, max);
    enclose<0>(zero, 3, at, out, max);
  } else {
    Real c[degree + 1];
    if constexpr (degree == 3)
      cubic_coefficients(length, p0, h, column(t.v, i), column(t.v, i + 1), c);
    else
      quintic_coefficients(length, p0, h, column(t.v, i), column(t.a, i), column(t.v, i + 1),
                           column(t.a, i + 1), c);
    Real v[degree], a[degree - 1], j[degree - 2];
    v[0] = c[1] / length;
    v[1] = 2 * c[2] / length;
    v[2] = 3 * c[3] / length;
    a[0] = v[1] / length;
    a[1] = 2 * v[2] / length;
    j[0] = a[1] / length;
    if constexpr (degree == 5) {
      const Real r = 1 / length;
      v[3] = 4 * c[4] * r;
      v[4] = 5 * c[5] * r;
      a[2] = 3 * v[3] * r;
      a[3] = 4 * v[4] * r;
      j[1] = 2 * a[2] * r;
      j[2] = 3 * a[3] * r;
    }
    enclose<degree>(c, 0, at, out, max);
    enclose<degree - 1>(v, 1, at, out, max);
    enclose<degree - 2>(a, 2, at, out, max);
    enclose<degree - 3>(j, 3, at, out, max);
  }
}

template <class Real, int degree>
JOUNCE_INLINE void enclose_all(const KnotColumns& t, std::size_t first, std::size_t n, Hulls& out) {
  constexpr std::size_t width = profiles_detail::lanes<Real>;
  Maxima<Real> max;
  for (auto& order : max.greatest)
    for (Real& side : order) side = profiles_detail::every<Real>(-__builtin_inf());
  for (auto& order : max.taken)
    for (Real& side : order) side = profiles_detail::every<Real>(-__builtin_inf());
  for (std::size_t k = 0; k + width <= n; k += width)
    enclose_interval<Real, degree>(t, first + k, k, out, max);
  if (n % width != 0) enclose_interval<Real, degree>(t, first + n - width, n - width, out, max);
  for (int order = 0; order < 4; ++order)
    for (int side = 0; side < 2; ++side) {
      double g[width], s[width];
      profiles_detail::store(g, max.greatest[order][side]);
      profiles_detail::store(s, max.taken[order][side]);
      for (std::size_t k = 1; k < width; ++k) {
        g[0] = g[k] <= g[0] ? g[0] : g[k];
        s[0] = s[k] > s[0] ? s[k] : s[0];
      }
      out.greatest[order][side] = g[0];
      out.taken[order][side] = s[0];
    }
}

template <class Real>
JOUNCE_INLINE void hulls(const KnotColumns& t, Interpolation rule, std::size_t first, std::size_t n,
                         Hulls& out) {
  if (rule == Interpolation::linear)
    enclose_all<Real, 1>(t, first, n, out);
  else if (rule == Interpolation::cubic_hermite)
    enclose_all<Real, 3>(t, first, n, out);
  else
    enclose_all<Real, 5>(t, first, n, out);
}

/// A chunk with fewer intervals than lanes is computed interval by interval.
template <class Real>
JOUNCE_INLINE void hulls_in(const KnotColumns& t, Interpolation rule, std::size_t first,
                            std::size_t n, Hulls& out) {
  if (n < profiles_detail::lanes<Real>)
    hulls<double>(t, rule, first, n, out);
  else
    hulls<Real>(t, rule, first, n, out);
}

}  // namespace jounce::pvt_detail
