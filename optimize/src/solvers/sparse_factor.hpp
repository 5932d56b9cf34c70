// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <Eigen/SparseCore>

namespace jounce::optimize_detail {

/// Factors of a symmetric sparse matrix K, of which only the lower half is read. One source file
/// instantiates Eigen's templates, which take seconds to compile.
class SparseFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  enum class Method {
    cholesky,  ///< L D L', ordered for sparsity alone
    pivoting,  ///< L U, rows exchanged for stability
  };

  explicit SparseFactor(Method method);
  ~SparseFactor();
  SparseFactor(const SparseFactor&) = delete;
  SparseFactor& operator=(const SparseFactor&) = delete;

  /// Orders the pattern of K. Call it once for all K with the same pattern.
  void find_pattern(const Matrix& lower);
  /// Factorizes K. Returns false if K is singular.
  bool factorize(const Matrix& lower);
  /// Returns K^-1 times the right side.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace jounce::optimize_detail
