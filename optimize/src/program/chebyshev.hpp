// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace jounce::optimizer {

/// Chebyshev's nodes of an interval, and Lagrange's polynomials there (barycentric: Berrut, Trefethen, SIAM
/// Review 46, 2004), for a function that grows like exp(size |x|) off the real axis.
class ChebyshevNodes {
 public:
  /// Uses enough nodes for an error at rounding, by (e rho / 2 n)^n with rho = size (high - low) / 2.
  ChebyshevNodes(double low, double high, double size);

  [[nodiscard]] const std::vector<double>& at() const { return at_; }
  /// True if that needs more nodes than the maximum.
  [[nodiscard]] bool too_few() const;

  /// The polynomials at x within the interval, one a node: f(x) = sum of share * f(node).
  [[nodiscard]] std::vector<double> shares(double x) const;

 private:
  std::vector<double> at_, weight_;
};

}  // namespace jounce::optimizer
