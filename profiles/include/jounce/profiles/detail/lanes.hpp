// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <immintrin.h>
#endif

// Arithmetic for formulas that hold for a double and, lane by lane, for a vector of doubles
// (`__attribute__((vector_size))`). The comparison of two vectors is a mask, and `mask ? a : b`
// selects by lane.
namespace jounce::profiles_detail {

#define JOUNCE_INLINE inline __attribute__((always_inline))

using Vector2 = double __attribute__((vector_size(16)));
using Vector4 = double __attribute__((vector_size(32)));
using Vector8 = double __attribute__((vector_size(64)));
template <class Real>
using Mask = decltype(Real{} < Real{});

/// Number of doubles in a Real.
template <class Real>
constexpr std::size_t lanes = sizeof(Real) / sizeof(double);

/// Reads and writes a Real at an address without alignment.
template <class Real>
JOUNCE_INLINE Real load(const double* from) {
  Real x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}
template <class Real>
JOUNCE_INLINE void store(double* to, Real x) {
  __builtin_memcpy(to, &x, sizeof x);
}

/// Returns the value x in every lane.
template <class Real>
JOUNCE_INLINE Real every(double x) {
  return x - Real{};  // Real{} + x would change -0 to 0 and cost an addition
}
/// Minimum, maximum, magnitude and square root of each lane.
template <class Real>
JOUNCE_INLINE Real least(Real a, Real b) {
  return a < b ? a : b;
}
template <class Real>
JOUNCE_INLINE Real greatest(Real a, Real b) {
  return a > b ? a : b;
}
template <class Real>
JOUNCE_INLINE Real magnitude(Real x) {
  return greatest(x, -x);
}
JOUNCE_INLINE double root_of(double x) {
  return __builtin_sqrt(x);
}
template <class Real>
JOUNCE_INLINE Real root_of(Real x) {
#ifdef __AVX512F__
  if constexpr (sizeof(Real) == 64)
    return std::bit_cast<Real>(_mm512_maskz_sqrt_pd(0xff, std::bit_cast<__m512d>(x)));
#endif
#ifdef __AVX__
  if constexpr (sizeof(Real) == 32)
    return std::bit_cast<Real>(_mm256_sqrt_pd(std::bit_cast<__m256d>(x)));
#endif
#ifdef __SSE2__
  if constexpr (sizeof(Real) == 16)
    return std::bit_cast<Real>(_mm_sqrt_pd(std::bit_cast<__m128d>(x)));
#endif
  for (std::size_t i = 0; i < sizeof(Real) / sizeof(double); ++i) x[i] = __builtin_sqrt(x[i]);
  return x;
}
/// Returns the square root; 0 for an x that rounding made negative.
template <class Real>
JOUNCE_INLINE Real square_root(Real x) {
  return root_of(greatest(x, every<Real>(0)));
}

/// The unsigned integer type with the size and lanes of a Real.
template <class Real>
struct BitsOf;
template <>
struct BitsOf<double> {
  using Type = std::uint64_t;
};
template <>
struct BitsOf<Vector2> {
  using Type = std::uint64_t __attribute__((vector_size(16)));
};
template <>
struct BitsOf<Vector4> {
  using Type = std::uint64_t __attribute__((vector_size(32)));
};
template <>
struct BitsOf<Vector8> {
  using Type = std::uint64_t __attribute__((vector_size(64)));
};

/// {a, b}, or {b, a} if `swapped`, without a branch and without memory. (Two doubles that are
/// stored one by one are slow to load as a vector.)
JOUNCE_INLINE Vector2 pair(double a, double b, bool swapped) {
  using Bits = BitsOf<Vector2>::Type;
  const Bits mask = Bits{} - static_cast<std::uint64_t>(swapped);
  const Bits given = std::bit_cast<Bits>(Vector2{a, b});
  const Bits other = std::bit_cast<Bits>(Vector2{b, a});
  return std::bit_cast<Vector2>((other & mask) | (given & ~mask));
}

/// Returns the cube root within 4 %, for a normal x > 0: a third of the exponent, linear in
/// between. The division by 3 is a product of shifts, 1/3 = (1 + 1/4)(1 + 1/16)(1 + 1/256)... / 4,
/// because vectors have no 64-bit product.
template <class Real>
JOUNCE_INLINE Real rough_cube_root(Real x) {
  using Bits = typename BitsOf<Real>::Type;
  Bits third = std::bit_cast<Bits>(x);
  third += third >> 2;
  third += third >> 4;
  third += third >> 8;
  third += third >> 16;
  return std::bit_cast<Real>((third >> 2) + 0x2a9f789300000000U);
}

/// Returns the cube root of x within two ulps. r: a rough root; per_x: 1/x. A series in e = 1 -
/// r^3/x, accurate to 1e-8, is followed by one Newton step.
template <class Real>
JOUNCE_INLINE Real cube_root_near(Real r, Real per_x) {
  const Real e = 1 - r * r * r * per_x;
  const Real high = 35. / 243 + e * (91. / 729 + e * (728. / 6561));
  const Real y = r + r * e * (1. / 3 + e * (2. / 9 + e * (14. / 81 + e * high)));
  return y + y * (1. / 3) * (1 - y * y * y * per_x);
}

/// Returns the cube root of a normal x > 0; per_x is 1/x.
template <class Real>
JOUNCE_INLINE Real cube_root(Real x, Real per_x) {
  return cube_root_near(rough_cube_root(x), per_x);
}

/// Returns the cube root of one double. The root of 8 x is exactly twice the root of x, so units
/// that differ by powers of two give the same result.
JOUNCE_INLINE double cube_root_in_units(double x, double per_x) {
  const std::uint64_t third = std::bit_cast<std::uint64_t>(x) / 3;
  return cube_root_near(std::bit_cast<double>(third + 0x2a9f789300000000U), per_x);
}

}  // namespace jounce::profiles_detail
