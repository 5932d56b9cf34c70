// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace jounce::validate_detail {

/// Greatest norm (largest row sum) for which exponential_series() is exact to rounding.
constexpr double exponential_reach = 0.5;
constexpr int exponential_terms = 16;  // 0.5^16 / 16! = 7e-19

/// Returns exp(M) by Taylor's series, for a norm up to exponential_reach.
Eigen::MatrixXd exponential_series(const Eigen::MatrixXd& m);

/// Returns exp(M): M is halved until the series is exact, and the result is squared as often.
Eigen::MatrixXd exponential(const Eigen::MatrixXd& m);

}  // namespace jounce::validate_detail
