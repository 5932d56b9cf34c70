// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/detail/lanes.hpp"
#include "jounce/pvt/table.hpp"

// One interval of a table as polynomials in s, for many instants. The operations and their order
// are the same for a double and for a vector of doubles. With s = (x - x0) / L in [0, 1], h = p1 -
// p0, m = v L and k = a L^2 (VDI 2143, the general polynomial of degree 5; a cubic has c4 = c5 =
// 0):
//
//   (1)  p = c0 + c1 s + ... + cn s^n
//   (2)  cubic:    c = {p0, m0, 3h - 2m0 - m1, -2h + m0 + m1}
//   (3)  quintic:  c = {p0, m0, k0/2, 10h - 6m0 - 4m1 - (3k0 - k1)/2,
//                       -15h + 8m0 + 7m1 + (3k0 - 2k1)/2, 6h - 3(m0 + m1) - (k0 - k1)/2}
//   (4)  v = dp/dx has the coefficients i ci / L, a the coefficients of v times i / L, the third
//        derivative the coefficients of a times i / L. The first coefficient of v and of a is the
//        number in the table, if the table has it.
//
// No operation is contracted (the module is compiled with -ffp-contract=off). s is (x - x0) times
// 1/L, so a sample needs no division. There are only plain arrays and inlined functions: kernels
// for wide vectors include this file, and a linker must find no code to share between them.
namespace jounce::pvt_detail {

/// The columns that a kernel reads, `size` knots; v and a only if the rule uses them.
struct KnotColumns {
  const double* x;
  const double* p;
  const double* v;
  const double* a;
  std::size_t size;
};

JOUNCE_INLINE KnotColumns knots_of(const Columns& c) {
  return {c.x.data(), c.p.data(), c.v.data(), c.a.data(), c.x.size()};
}

/// The degree of a rule's polynomials.
JOUNCE_INLINE constexpr int degree_of(Interpolation rule) {
  return rule == Interpolation::linear ? 1 : (rule == Interpolation::cubic_hermite ? 3 : 5);
}

/// Coefficients in s of one interval, and of its derivatives with respect to x.
template <int degree>
struct Piece {
  double x0, per_length;
  double p[degree + 1];
  double v[degree];
  double a[degree > 1 ? degree - 1 : 1];
  double j[degree > 2 ? degree - 2 : 1];
};

template <int n, class Real>
JOUNCE_INLINE Real horner(const double* c, Real s) {
  Real f = profiles_detail::every<Real>(c[n]);
  for (int k = n - 1; k >= 0; --k) f = f * s + c[k];
  return f;
}

/// Evaluates (4) from coefficient `first` on.
template <int n>
JOUNCE_INLINE void differentiate(const double* c, double per_length, int first, double* slope) {
  for (int k = first; k < n; ++k) slope[k] = static_cast<double>(k + 1) * c[k + 1] * per_length;
}

/// (2) and (3), with h = p1 - p0.
template <class Real>
JOUNCE_INLINE void cubic_coefficients(Real length, Real p0, Real h, Real v0, Real v1, Real* c) {
  const Real m0 = v0 * length;
  const Real m1 = v1 * length;
  c[0] = p0;
  c[1] = m0;
  c[2] = 3 * h - 2 * m0 - m1;
  c[3] = -2 * h + m0 + m1;
}
template <class Real>
JOUNCE_INLINE void quintic_coefficients(Real length, Real p0, Real h, Real v0, Real a0, Real v1,
                                        Real a1, Real* c) {
  const Real m0 = v0 * length;
  const Real m1 = v1 * length;
  const Real k0 = a0 * length * length;
  const Real k1 = a1 * length * length;
  c[0] = p0;
  c[1] = m0;
  c[2] = k0 / 2;
  c[3] = 10 * h - 6 * m0 - 4 * m1 - (3 * k0 - k1) / 2;
  c[4] = -15 * h + 8 * m0 + 7 * m1 + (3 * k0 - 2 * k1) / 2;
  c[5] = 6 * h - 3 * (m0 + m1) - (k0 - k1) / 2;
}

/// (1) to (4) for the interval between knots i and i + 1.
template <int degree>
JOUNCE_INLINE Piece<degree> piece(const KnotColumns& t, std::size_t i) {
  Piece<degree> f;
  const double length = t.x[i + 1] - t.x[i];
  const double h = t.p[i + 1] - t.p[i];
  f.x0 = t.x[i];
  f.per_length = 1 / length;
  if constexpr (degree == 1) {
    f.p[0] = t.p[i];
    f.p[1] = h;
    f.v[0] = h * f.per_length;
    f.a[0] = f.j[0] = 0;
  } else {
    if constexpr (degree == 3)
      cubic_coefficients(length, t.p[i], h, t.v[i], t.v[i + 1], f.p);
    else
      quintic_coefficients(length, t.p[i], h, t.v[i], t.a[i], t.v[i + 1], t.a[i + 1], f.p);
    f.v[0] = t.v[i];
    if constexpr (degree == 5) f.a[0] = t.a[i];
    differentiate<degree>(f.p, f.per_length, 1, f.v);
    differentiate<degree - 1>(f.v, f.per_length, degree == 5 ? 1 : 0, f.a);
    differentiate<degree - 2>(f.a, f.per_length, 0, f.j);
  }
  return f;
}

/// s of a position x in an interval that ends at x1. Positions outside are moved to the ends, and
/// both ends are exact.
template <int degree>
JOUNCE_INLINE double place(const Piece<degree>& f, double x, double x1) {
  if (!(x < x1)) return x >= x1 ? 1 : x;
  return x > f.x0 ? (x - f.x0) * f.per_length : 0;
}

template <int degree, class Real>
JOUNCE_INLINE Real position(const Piece<degree>& f, Real s) {
  return horner<degree>(f.p, s);
}
template <int degree, class Real>
JOUNCE_INLINE Real velocity(const Piece<degree>& f, Real s) {
  return horner<degree - 1>(f.v, s);
}
template <int degree, class Real>
JOUNCE_INLINE Real acceleration(const Piece<degree>& f, Real s) {
  return horner<(degree > 1 ? degree - 2 : 0)>(f.a, s);
}
template <int degree, class Real>
JOUNCE_INLINE Real jerk(const Piece<degree>& f, Real s) {
  return horner<(degree > 2 ? degree - 3 : 0)>(f.j, s);
}

}  // namespace jounce::pvt_detail
