// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace jounce::optimize_detail {

/// Chebyshev's nodes of an interval, and Lagrange's polynomials at these nodes (barycentric:
/// Berrut, Trefethen, SIAM Review 46, 2004). They are for a function that grows like exp(size |x|)
/// away from the real axis.
class ChebyshevNodes {
 public:
  /// Uses enough nodes that the error is rounding, by (e rho / 2 n)^n with rho = size (high - low)
  /// / 2.
  ChebyshevNodes(double low, double high, double size);

  /// The nodes.
  [[nodiscard]] const std::vector<double>& at() const { return at_; }
  /// True if an error at the level of rounding would need more nodes than the maximum.
  [[nodiscard]] bool too_few() const;

  /// Returns the values of the polynomials at x, one for each node: f(x) = sum of share * f(node).
  [[nodiscard]] std::vector<double> shares(double x) const;

 private:
  std::vector<double> at_, weight_;
};

}  // namespace jounce::optimize_detail
