// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <Eigen/Core>

namespace jounce::validate_detail {

/// In place of a sum of squares that may be 0.
inline constexpr double least_divisor = 1e-300;

/// Residuals and their derivatives at one point.
struct Linearized {
  Eigen::VectorXd residual;  ///< m
  Eigen::MatrixXd jacobian;  ///< m x n
};

/// None where the residuals cannot be computed: the step to that point is not taken.
using ResidualFunction = std::function<std::optional<Linearized>(const Eigen::VectorXd& x)>;

struct LeastSquaresOptions {
  int max_iterations = 50;
  double damping = 1e-3;    ///< mu to begin with
  double longest_step = 1;  ///< in any entry of x
  /// The point after a step; left out: x + step. Must agree with that to first order.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& x, const Eigen::VectorXd& step)> advance =
      {};
  double tolerance =
      1e-8;         ///< tolerance of x: a step shorter than this in every entry ends the search
  double flat = 0;  ///< or a predicted gain of no more than this share of |residual|^2
};

struct LeastSquares {
  enum class Status { converged, stalled, not_computable };
  Status status = Status::stalled;
  Eigen::VectorXd x;
  Linearized at;  ///< there
  int iterations = 0;
  double damping = 0;  ///< mu of the last step: a start for a similar search
};

/// Minimizes |residual(x)|^2 from x on (Levenberg, Marquardt). `not_computable`: the residuals cannot be
/// computed at the start. `stalled` includes a point without a finite step: residuals or derivatives that
/// overflow.
LeastSquares least_squares(const ResidualFunction& f, const Eigen::VectorXd& x,
                           const LeastSquaresOptions& options = {});

/// Standard deviations and correlations of x, for residuals of standard deviation 1. Directions without effect
/// on the residuals count as if they had 1e-10 of the effect of the best known direction.
struct Covariance {
  Eigen::VectorXd deviation;    ///< n
  Eigen::MatrixXd correlation;  ///< n x n, 1 on the diagonal
};
Covariance covariance(const Eigen::MatrixXd& jacobian);

/// The factor of a standard deviation within which Student's distribution has 95 %: 1.96 for many
/// degrees of freedom. Within 1 % from 3 on (Cornish and Fisher's expansion, Abramowitz 26.7.5).
double student_95(double degrees_of_freedom);

}  // namespace jounce::validate_detail
