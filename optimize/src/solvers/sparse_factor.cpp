// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/sparse_factor.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace jounce::optimize_detail {

struct SparseFactor::Factors {
  Method method = Method::cholesky;
  Eigen::SimplicialLDLT<Matrix> cholesky;
  Eigen::SparseLU<Matrix> pivoting;
};

SparseFactor::SparseFactor(Method method) : factors_(std::make_unique<Factors>()) {
  factors_->method = method;
}

SparseFactor::~SparseFactor() = default;

void SparseFactor::find_pattern(const Matrix& lower) {
  if (factors_->method == Method::pivoting)
    factors_->pivoting.analyzePattern(Matrix(lower.selfadjointView<Eigen::Lower>()));
  else
    factors_->cholesky.analyzePattern(lower);
}

bool SparseFactor::factorize(const Matrix& lower) {
  if (factors_->method == Method::pivoting) {
    factors_->pivoting.factorize(Matrix(lower.selfadjointView<Eigen::Lower>()));
    return factors_->pivoting.info() == Eigen::Success;
  }
  factors_->cholesky.factorize(lower);
  return factors_->cholesky.info() == Eigen::Success;
}

Eigen::VectorXd SparseFactor::solve(const Eigen::VectorXd& right) const {
  if (factors_->method == Method::pivoting) return factors_->pivoting.solve(right);
  return factors_->cholesky.solve(right);
}

Eigen::MatrixXd SparseFactor::solve(const Eigen::MatrixXd& right) const {
  if (factors_->method == Method::pivoting) return factors_->pivoting.solve(right);
  return factors_->cholesky.solve(right);
}

}  // namespace jounce::optimize_detail
