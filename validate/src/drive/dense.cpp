// SPDX-License-Identifier: Apache-2.0
#include "validate/src/drive/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace jounce::validate_detail {

Eigenpairs eigenpairs(const Eigen::MatrixXd& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& a) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(a, false).eigenvalues();
}

Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.partialPivLu().solve(b);
}

Eigen::VectorXcd solve(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b) {
  return a.partialPivLu().solve(b);
}

Eigen::VectorXd solve_full(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.fullPivLu().solve(b);
}

FullSolution solve_full(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b) {
  const auto lu = a.fullPivLu();
  return {lu.solve(b), lu.rcond()};
}

}  // namespace jounce::validate_detail
