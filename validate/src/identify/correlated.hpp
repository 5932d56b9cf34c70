// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "validate/src/identify/least_squares.hpp"

namespace jounce::validate_detail {

/// Standard deviations and correlations like covariance(), for residuals that are correlated over
/// time and with each other. `at` has one block of `samples` rows for each quantity, with residuals
/// of the standard deviation 1. No deviation is less than that for white residuals.
Covariance correlated_covariance(const Linearized& at, Eigen::Index samples);

}  // namespace jounce::validate_detail
