// SPDX-License-Identifier: Apache-2.0
// The covariance of a fit whose residuals r are correlated. J_bi is row i of block b of the Jacobian, and
// the residuals of the blocks are stationary, with the covariances R_bc(l). Then
//
//     (1)  cov x = B Omega B,   B = (J^T J)^-1
//     (2)  Omega = sum_{b,c} sum_{|l| < 2L} w(l) R_bc(l) sum_i J_bi^T J_c,i+l
//     (3)  R_bc(l) = sum_i r_bi r_c,i+l / n,   w(l) = 1 up to L, then falling linearly to 0 at 2L
//     (4)  L: the least lag after which |rho_b| < 2 sqrt(log10 n / n) at K lags, in all blocks
//
// G. A. F. Seber, C. J. Wild, Nonlinear Regression, 1989, ch. 6; (3), (4): D. N. Politis, Adaptive bandwidth
// choice, J. Nonparametric Statistics 15 (2003), with its K = max(5, sqrt(log10 n)).

#include "validate/src/identify/correlated.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::validate_detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// R(l), l >= 0: the first argument is earlier.
double lagged(const VectorXd& a, const VectorXd& b, Index lag) {
  const Index n = a.size() - lag;
  return a.head(n).dot(b.tail(n)) / static_cast<double>(a.size());
}

/// (4)
Index correlated_lags(const VectorXd& r) {
  const auto n = static_cast<double>(r.size());
  const double digits = std::log10(n);
  const double small = 2 * std::sqrt(digits / n) * lagged(r, r, 0);
  const auto enough = static_cast<Index>(std::max(5.0, std::sqrt(digits)));
  const Index most = r.size() / 8;
  Index last = 0;
  for (Index lag = 1; lag <= most && lag - last <= enough; ++lag)
    if (std::abs(lagged(r, r, lag)) >= small) last = lag;
  return last;
}

}  // namespace

Covariance correlated_covariance(const Linearized& at, Index samples) {
  const Covariance white = covariance(at.jacobian);
  const Index blocks = at.residual.size() / samples;
  const Index n = at.jacobian.cols();
  const auto r = [&](Index b) { return at.residual.segment(b * samples, samples); };
  const auto rows = [&](Index b, Index from, Index count) {
    return at.jacobian.middleRows(b * samples + from, count);
  };
  Index lags = 0;
  for (Index b = 0; b < blocks; ++b) lags = std::max(lags, correlated_lags(r(b)));
  MatrixXd omega = MatrixXd::Zero(n, n);
  for (Index lag = 0; lag <= 2 * lags && lag < samples; ++lag) {
    const double weight =
        lag <= lags ? 1 : 2 - static_cast<double>(lag) / static_cast<double>(lags);  // (3)
    for (Index b = 0; b < blocks; ++b)
      for (Index c = 0; c < blocks; ++c) {
        const MatrixXd term =
            weight * lagged(r(b), r(c), lag) *
            (rows(b, 0, samples - lag).transpose() * rows(c, lag, samples - lag));  // (2)
        omega += term;
        if (lag > 0) omega += term.transpose();
      }
  }
  const MatrixXd inverse =
      white.deviation.asDiagonal() * white.correlation * white.deviation.asDiagonal();
  Covariance answer{VectorXd(n), MatrixXd::Identity(n, n)};
  const MatrixXd whole = inverse * omega * inverse;  // (1)
  if (!whole.allFinite()) return white;
  answer.deviation = whole.diagonal().cwiseMax(0).cwiseSqrt().cwiseMax(white.deviation);
  answer.correlation = white.correlation;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      if (const double size = std::sqrt(whole(i, i) * whole(j, j)); i != j && size > 0)
        answer.correlation(i, j) = std::clamp(whole(i, j) / size, -1.0, 1.0);
  return answer;
}

}  // namespace jounce::validate_detail
