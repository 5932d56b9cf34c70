// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace jounce::optimize_detail {

/// One joint of a motion from rest to rest. T is double, or complex for derivatives with respect to
/// an interval.
template <class T>
struct JointSpline {
  std::vector<T> position, velocity, acceleration;  ///< at each knot
  std::vector<T> jerk;                              ///< jerk of each interval
};

// The C2 cubic spline with accelerations a_i at knots i = 0 ... n, a_0 = a_n = 0, intervals h_i.
// Knots 1 and n - 1 are virtual: rest at the adjacent end requires p_1 = p_0 + a_1 h_1^2 / 6, and
// similarly p_(n-1). Each position is therefore p_i = q_i + r_i a_i, with r_i = 0 except at these
// two. The velocity is continuous if
//
//   (1)  h_i a_(i-1) + 2 (h_i + h_(i+1)) a_i + h_(i+1) a_(i+1) = 6 (d_(i+1) - d_i),
//        d_i = (p_i - p_(i-1)) / h_i
//
// which is tridiagonal in a (Lin, Chang and Luh 1983). Then
//
//   (2)  v_i = d_i + h_i (a_(i-1) + 2 a_i) / 6,   jerk_i = (a_i - a_(i-1)) / h_i

/// Returns the spline through the points (at least two). `h`: intervals, one more than points.
template <class T>
JointSpline<T> joint_spline(std::span<const double> points, std::span<const T> h) {
  const std::size_t n = h.size();
  assert(points.size() >= 2 && n == points.size() + 1);
  std::vector<T> q(n + 1), r(n + 1, T(0));
  q[0] = q[1] = points.front();
  q[n] = q[n - 1] = points.back();
  for (std::size_t i = 2; i + 1 < n; ++i) q[i] = points[i - 1];
  r[1] = h[0] * h[0] / 6.0;
  r[n - 1] = h[n - 1] * h[n - 1] / 6.0;

  std::vector<T> upper(n, T(0)), a(n + 1, T(0));
  for (std::size_t i = 1; i < n; ++i) {  // (1), eliminated upwards; h[i - 1] is h_i
    const T left = h[i - 1], right = h[i];
    const T lower = left - 6.0 * r[i - 1] / left;
    const T diagonal = 2.0 * (left + right) + 6.0 * r[i] * (1.0 / left + 1.0 / right);
    const T value = 6.0 * ((q[i + 1] - q[i]) / right - (q[i] - q[i - 1]) / left);
    const T pivot = diagonal - (i > 1 ? lower * upper[i - 1] : T(0));
    upper[i] = i + 1 < n ? (right - 6.0 * r[i + 1] / right) / pivot : T(0);
    a[i] = (value - (i > 1 ? lower * a[i - 1] : T(0))) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) a[i] -= upper[i] * a[i + 1];

  JointSpline<T> s{std::vector<T>(n + 1), std::vector<T>(n + 1, T(0)), a, std::vector<T>(n)};
  for (std::size_t i = 0; i <= n; ++i) s.position[i] = q[i] + r[i] * a[i];
  for (std::size_t i = 1; i <= n; ++i) {  // (2)
    const T chord = (s.position[i] - s.position[i - 1]) / h[i - 1];
    if (i < n) s.velocity[i] = chord + h[i - 1] * (a[i - 1] + 2.0 * a[i]) / 6.0;
    s.jerk[i - 1] = (a[i] - a[i - 1]) / h[i - 1];
  }
  return s;
}

}  // namespace jounce::optimize_detail
