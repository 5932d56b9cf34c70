// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

/// Decompositions of dense matrices. One file instantiates Eigen's templates, which take seconds to compile.
namespace jounce::validate_detail {

struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;  ///< columns
};
Eigenpairs eigenpairs(const Eigen::MatrixXd& a);
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& a);

/// The x of A x = b, with rows exchanged.
Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::VectorXcd solve(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

/// The x of A x = b where A may be nearly singular: rows and columns exchanged.
Eigen::VectorXd solve_full(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
struct FullSolution {
  Eigen::VectorXcd x;
  double rcond = 0;  ///< estimate of 1 / (|A| |A^-1|): 0 where A is singular
};
FullSolution solve_full(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

}  // namespace jounce::validate_detail
