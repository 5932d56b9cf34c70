// SPDX-License-Identifier: Apache-2.0
#include "validate/src/drive/dense.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "jounce/profiles/detail/elimination.hpp"

namespace jounce::validate_detail {

Eigenpairs eigenpairs(const Eigen::MatrixXd& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& a) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(a, false).eigenvalues();
}

Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return profiles_detail::eliminated(a, b);
}

Eigen::VectorXcd solve(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b) {
  return profiles_detail::eliminated(a, b);
}

Eigen::VectorXd solve_full(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.fullPivLu().solve(b);
}

ConditionedSolution solve_with_condition(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b) {
  const Eigen::Index n = a.rows();
  double inverse = 0;  // |A^-1|, by its columns
  for (Eigen::Index k = 0; k < n; ++k) {
    const double column = solve(a, Eigen::VectorXcd::Unit(n, k)).lpNorm<1>();
    if (!std::isfinite(column)) return {solve(a, b), 0};
    inverse = std::max(inverse, column);
  }
  return {solve(a, b), 1 / (a.cwiseAbs().colwise().sum().maxCoeff() * inverse)};
}

}  // namespace jounce::validate_detail
