// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "optimize/src/solvers/program.hpp"

namespace jounce::optimize_detail {

/// Solver coordinates: z = z0 + W y with W^-T W^-1 = H, so that
///
///     (1)  H = mean over the rows of g g^T + diag(1 / width^2)
///
/// becomes the unit matrix. The gradients g of the rows at z0 then have no preferred direction, and
/// no step of length one goes far beyond the bounds. Without this, SLSQP stops early and reports
/// success.
class Whitening {
 public:
  Whitening(const Program& program, const Point& z0);

  /// Returns z0 + W y, where W = L^-T and H = L L^T.
  [[nodiscard]] Point z(std::span<const double> y) const;

  /// Converts a gradient with respect to z to the gradient with respect to y, in place: W^T g =
  /// L^-1 g.
  void turn(std::span<double> g) const;

 private:
  [[nodiscard]] double at(std::size_t i, std::size_t j) const { return factor_[i * n_ + j]; }
  double& at(std::size_t i, std::size_t j) { return factor_[i * n_ + j]; }
  void cholesky();

  Point z0_;
  std::size_t n_;
  std::vector<double> factor_;  ///< L below and on the diagonal, row by row
};

}  // namespace jounce::optimize_detail
