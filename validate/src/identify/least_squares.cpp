// SPDX-License-Identifier: Apache-2.0
// The method of Levenberg and Marquardt. The residual near x is r + J dx; the step solves
//
//     (1)  min |r + J dx|^2 + mu D^2 |dx|^2,     D = the norm of the greatest column of J so far
//
// as one linear least-squares problem by QR. (J^T J would square the condition number, which is
// large if two parameters can hardly be separated.) mu starts small. It is divided by ten at each
// step that reduces the residual. It is multiplied by ten at each step that does not (D. W.
// Marquardt, J. SIAM 11, 1963), and as long as the step is longer than the limit. All variables
// have the same D because they are of one kind.

#include "validate/src/identify/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "jounce/cam/detail/pivoted_qr.hpp"

namespace jounce::validate_detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double cost_rounding = 1e-14;  ///< share of the cost
constexpr double least_damping_factor = 1e-15;
constexpr double flat_cost = 1e-9;        ///< share of the cost: the accuracy of the residuals
constexpr double least_column = 1e-10;    ///< share of the longest column
constexpr double least_singular = 1e-10;  ///< share of the greatest singular value

/// J and r by the triangle R and Q^T r, which have the same normal equations in n rows.
Linearized condensed(const Linearized& at) {
  const Index n = at.jacobian.cols();
  if (at.jacobian.rows() <= n) return at;
  const Eigen::HouseholderQR<MatrixXd> qr(at.jacobian);
  const VectorXd rotated = qr.householderQ().adjoint() * at.residual;
  return {rotated.head(n), qr.matrixQR().topRows(n).triangularView<Eigen::Upper>()};
}

VectorXd damped_step(const Linearized& at, double damping) {
  const Index m = at.jacobian.rows();
  const Index n = at.jacobian.cols();
  MatrixXd a(m + n, n);
  a << at.jacobian, MatrixXd::Identity(n, n) * damping;
  VectorXd b = VectorXd::Zero(m + n);
  b.head(m) = -at.residual;
  return cam_detail::PivotedQr(a).solve(b);  // (1)
}

/// Increases the damping until the step is no longer than the limit: a number with little effect must not
/// diverge, nor slow the others. None where the numbers overflow, which no damping can prevent.
std::optional<VectorXd> step_within(const Linearized& at, double scale, double longest,
                                    double& mu) {
  for (double damping = mu; std::isfinite(damping); damping *= 10) {
    VectorXd step = damped_step(at, std::sqrt(damping) * scale);
    if (!step.allFinite()) break;
    mu = damping;
    if (step.cwiseAbs().maxCoeff() <= longest) return step;
  }
  return std::nullopt;
}

}  // namespace

LeastSquares least_squares(const ResidualFunction& f, const VectorXd& x,
                           const LeastSquaresOptions& options) {
  LeastSquares best{LeastSquares::Status::not_computable, x, {}, 0, options.damping};
  auto here = f(x);
  if (!here) return best;
  best.at = std::move(*here);
  best.status = LeastSquares::Status::stalled;
  Linearized small = condensed(best.at);
  double scale = 0;
  double mu = options.damping;
  for (; best.iterations < options.max_iterations; ++best.iterations) {
    scale = std::max({scale, small.jacobian.colwise().norm().maxCoeff(), least_divisor});
    const auto within = step_within(small, scale, options.longest_step, mu);
    if (!within) break;
    const VectorXd& step = *within;
    best.damping = mu;
    const double promised =
        small.residual.squaredNorm() - (small.residual + small.jacobian * step).squaredNorm();
    const double cost = best.at.residual.squaredNorm();
    if (step.cwiseAbs().maxCoeff() <= options.tolerance ||
        promised <= std::max(options.flat, cost_rounding * cost)) {
      best.status = LeastSquares::Status::converged;
      break;
    }
    const VectorXd next = options.advance ? options.advance(best.x, step) : best.x + step;
    auto there = f(next);
    const double gain = there ? cost - there->residual.squaredNorm() : -1;
    if (gain > 0) {
      best.x = next;
      best.at = std::move(*there);
      small = condensed(best.at);
      mu = std::max(mu / 10, least_damping_factor);
    } else {
      if (promised <= flat_cost * cost) {  // flat within the accuracy of the residuals
        best.status = LeastSquares::Status::converged;
        break;
      }
      mu *= 10;
    }
  }
  return best;
}

Covariance covariance(const MatrixXd& jacobian) {
  const Index n = jacobian.cols();
  // Scales the columns to equal length first, so that units do not decide which numbers count as unknown.
  VectorXd length = jacobian.colwise().norm();
  const double longest = length.maxCoeff();
  for (double& l : length) l = std::max(l, least_column * (longest > 0 ? longest : 1));
  const MatrixXd scaled = jacobian * length.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner> svd(
      Linearized(condensed({VectorXd::Zero(jacobian.rows()), scaled})).jacobian,
      Eigen::ComputeFullV);
  VectorXd singular = VectorXd::Zero(n);
  singular.head(svd.singularValues().size()) = svd.singularValues();
  const double least = least_singular * std::max(singular.maxCoeff(), least_divisor);
  const MatrixXd half = length.cwiseInverse().asDiagonal() * svd.matrixV() *
                        singular.cwiseMax(least).cwiseInverse().asDiagonal();
  const MatrixXd whole = half * half.transpose();
  Covariance answer;
  answer.deviation = whole.diagonal().cwiseSqrt();
  answer.correlation = answer.deviation.cwiseInverse().asDiagonal() * whole *
                       answer.deviation.cwiseInverse().asDiagonal();
  return answer;
}

double student_95(double degrees_of_freedom) {
  const double v = std::max(degrees_of_freedom, 1.0);
  constexpr double z = 1.959963984540054;
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * v) + (5 * z5 + 16 * z3 + 3 * z) / (96 * v * v) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * v * v * v);
}

}  // namespace jounce::validate_detail
