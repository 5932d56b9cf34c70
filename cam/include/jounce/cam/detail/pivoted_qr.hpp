// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <Eigen/Core>

namespace jounce::cam_detail {

/// A P = Q R by Householder's reflections, columns pivoted so that the diagonal of R falls. A
/// separate source file instantiates Eigen's template, which takes seconds to compile.
class PivotedQr {
 public:
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic>;

  explicit PivotedQr(const Eigen::MatrixXd& a);
  /// The rank counts the pivots above `threshold` times the greatest.
  PivotedQr(const Eigen::MatrixXd& a, double threshold);
  ~PivotedQr();
  PivotedQr(const PivotedQr&) = delete;
  PivotedQr& operator=(const PivotedQr&) = delete;

  [[nodiscard]] Eigen::Index rank() const;
  /// The first columns of Q.
  [[nodiscard]] Eigen::MatrixXd q(Eigen::Index columns) const;
  /// The upper triangle of the first `rank` rows and columns of R.
  [[nodiscard]] Eigen::MatrixXd r() const;
  [[nodiscard]] const Permutation& permutation() const;
  /// The x of least |A x - b|; entries beyond the rank are 0.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace jounce::cam_detail
