// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "cam/src/design/interval.hpp"

// Truncated Taylor series whose coefficients are intervals. If each c[k] contains f^(k)(x)/k! for
// all x of an interval, so do the coefficients of computed results. At a single x they are the
// value and its derivatives, to rounding. So the same formula serves for evaluation and for
// enclosure (R. Moore, "Methods and Applications of Interval Analysis", 1979, ch. 3; automatic
// differentiation uses the same recurrences).
namespace jounce::cam_detail {

/// The value and N derivatives, each divided by its factorial.
template <std::size_t N>
struct Taylor {
  std::array<Interval, N + 1> c{};

  Taylor() = default;
  Taylor(Interval constant) { c[0] = constant; }  // NOLINT: a constant is a series
  Taylor(double constant) { c[0] = constant; }    // NOLINT

  /// The same to a lower order.
  template <std::size_t M>
  [[nodiscard]] Taylor<M> to() const {
    static_assert(M <= N);
    Taylor<M> f;
    for (std::size_t k = 0; k <= M; ++k) f.c[k] = c[k];
    return f;
  }
};

template <std::size_t N>
Taylor<N - 1> derivative(const Taylor<N>& f) {
  Taylor<N - 1> d;
  for (std::size_t k = 0; k < N; ++k) d.c[k] = Interval(static_cast<double>(k + 1)) * f.c[k + 1];
  return d;
}

template <std::size_t N>
Taylor<N> operator+(Taylor<N> a, const Taylor<N>& b) {
  for (std::size_t k = 0; k <= N; ++k) a.c[k] = a.c[k] + b.c[k];
  return a;
}
template <std::size_t N>
Taylor<N> operator-(Taylor<N> a, const Taylor<N>& b) {
  for (std::size_t k = 0; k <= N; ++k) a.c[k] = a.c[k] - b.c[k];
  return a;
}
template <std::size_t N>
Taylor<N> operator*(double factor, Taylor<N> a) {
  for (Interval& c : a.c) c = Interval(factor) * c;
  return a;
}

template <std::size_t N>
Taylor<N> operator*(const Taylor<N>& a, const Taylor<N>& b) {
  Taylor<N> p;
  for (std::size_t k = 0; k <= N; ++k)
    for (std::size_t i = 0; i <= k; ++i) p.c[k] = p.c[k] + a.c[i] * b.c[k - i];
  return p;
}

template <std::size_t N>
Taylor<N> square(const Taylor<N>& a) {
  Taylor<N> p = a * a;
  p.c[0] = square(a.c[0]);
  return p;
}

template <std::size_t N>
Taylor<N> operator/(const Taylor<N>& a, const Taylor<N>& b) {
  Taylor<N> q;
  for (std::size_t k = 0; k <= N; ++k) {
    Interval rest = a.c[k];
    for (std::size_t i = 1; i <= k; ++i) rest = rest - b.c[i] * q.c[k - i];
    q.c[k] = rest / b.c[0];
  }
  return q;
}

template <std::size_t N>
Taylor<N> sqrt(const Taylor<N>& a) {
  Taylor<N> r;
  r.c[0] = sqrt(a.c[0]);
  for (std::size_t k = 1; k <= N; ++k) {
    Interval rest = a.c[k];
    for (std::size_t i = 1; i < k; ++i) rest = rest - r.c[i] * r.c[k - i];
    r.c[k] = rest / (Interval(2) * r.c[0]);
  }
  return r;
}

template <std::size_t N>
struct SinCos {
  Taylor<N> sin, cos;
};

template <std::size_t N>
SinCos<N> sincos(const Taylor<N>& a) {
  SinCos<N> r;
  r.sin.c[0] = sin(a.c[0]);
  r.cos.c[0] = cos(a.c[0]);
  for (std::size_t k = 1; k <= N; ++k) {
    Interval s;
    Interval c;
    for (std::size_t i = 1; i <= k; ++i) {
      const Interval slope = Interval(static_cast<double>(i)) * a.c[i];
      s = s + slope * r.cos.c[k - i];
      c = c + slope * r.sin.c[k - i];
    }
    const Interval share(1 / static_cast<double>(k));
    r.sin.c[k] = share * s;
    r.cos.c[k] = share * -c;
  }
  return r;
}

}  // namespace jounce::cam_detail
