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
  Eigen::VectorXd residual;  ///< m numbers
  Eigen::MatrixXd jacobian;  ///< m rows, n columns
};

/// Returns the residuals at x. nullopt: they cannot be computed, and the step to x is not made.
using ResidualFunction = std::function<std::optional<Linearized>(const Eigen::VectorXd& x)>;

/// Options of least_squares().
struct LeastSquaresOptions {
  int max_iterations = 50;  ///< greatest number of iterations
  double damping = 1e-3;    ///< initial mu
  double longest_step = 1;  ///< greatest change of an entry of x in a step
  /// Returns the point after a step; empty: x + step. The point must equal x + step to first order.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& x, const Eigen::VectorXd& step)> advance =
      {};
  double tolerance =
      1e-8;         ///< tolerance of x: a step shorter than this in every entry ends the search
  double flat = 0;  ///< or: a predicted gain of at most this share of |residual|^2 ends the search
};

/// Result of least_squares().
struct LeastSquares {
  enum class Status { converged, stalled, not_computable };
  Status status = Status::stalled;  ///< status at the end
  Eigen::VectorXd x;                ///< the point
  Linearized at;                    ///< residuals and derivatives there
  int iterations = 0;               ///< number of iterations
  double damping = 0;               ///< last mu, a start for a similar search
};

/// Minimizes |residual(x)|^2 from x on (Levenberg, Marquardt). The result is `not_computable` if
/// the residuals cannot be computed at the start, and `stalled` also if there is no finite step
/// because residuals or derivatives overflow.
LeastSquares least_squares(const ResidualFunction& f, const Eigen::VectorXd& x,
                           const LeastSquaresOptions& options = {});

/// Standard deviations and correlations of x, for residuals with the standard deviation 1. A
/// direction of x without effect on the residuals counts as if it had 1e-10 of the effect of the
/// best determined direction.
struct Covariance {
  Eigen::VectorXd deviation;    ///< n numbers
  Eigen::MatrixXd correlation;  ///< n x n, 1 on the diagonal
};
/// Returns them for the derivatives of the residuals.
Covariance covariance(const Eigen::MatrixXd& jacobian);

/// Returns the factor of a standard deviation within which Student's distribution has 95 %: 1.96
/// for many degrees of freedom. It is exact within 1 % for 3 and more (expansion of Cornish and
/// Fisher, Abramowitz 26.7.5).
double student_95(double degrees_of_freedom);

}  // namespace jounce::validate_detail
