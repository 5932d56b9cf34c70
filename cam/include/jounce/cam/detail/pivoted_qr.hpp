// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <Eigen/Core>

namespace jounce::cam_detail {

/// The factorization A P = Q R by Householder reflections. The columns are pivoted so that the
/// diagonal of R does not increase. Eigen's template is instantiated in a source file of its own,
/// because its compilation takes seconds.
class PivotedQr {
 public:
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic>;

  /// Factorizes a; the rank follows from Eigen's default threshold.
  explicit PivotedQr(const Eigen::MatrixXd& a);
  /// The rank is the number of pivots above `threshold` times the greatest pivot.
  PivotedQr(const Eigen::MatrixXd& a, double threshold);
  ~PivotedQr();
  PivotedQr(const PivotedQr&) = delete;
  PivotedQr& operator=(const PivotedQr&) = delete;

  [[nodiscard]] Eigen::Index rank() const;
  /// Returns the first `columns` columns of Q.
  [[nodiscard]] Eigen::MatrixXd q(Eigen::Index columns) const;
  /// The upper triangle of R, first rank() rows and columns.
  [[nodiscard]] Eigen::MatrixXd r() const;
  [[nodiscard]] const Permutation& permutation() const;
  /// Returns the x with the least |A x - b|; entries beyond the rank are 0.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace jounce::cam_detail
