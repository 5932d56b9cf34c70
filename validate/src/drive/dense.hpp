// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

/// Decompositions of dense matrices. One source file instantiates Eigen's templates, which take
/// seconds to compile.
namespace jounce::validate_detail {

/// Eigenvalues and eigenvectors of a matrix.
struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;  ///< one column for each value
};
Eigenpairs eigenpairs(const Eigen::MatrixXd& a);
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& a);

/// Returns the x of A x = b, with row pivoting.
Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::VectorXcd solve(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

/// Returns the x of A x = b for an A that may be nearly singular, with row and column pivoting.
Eigen::VectorXd solve_full(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// A solution, and the condition of its matrix.
struct ConditionedSolution {
  Eigen::VectorXcd x;
  double rcond = 0;  ///< 1 / (|A| |A^-1|), in the 1-norm; 0: A is singular
};
ConditionedSolution solve_with_condition(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

}  // namespace jounce::validate_detail
