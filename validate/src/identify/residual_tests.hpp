// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/validate/identify.hpp"

namespace jounce::validate_detail {

/// Tests whether residuals are white: Q of Ljung and Box over the first 10 autocorrelations (at
/// most a fifth of the samples), against the chi-square quantile. Fewer than 20 samples are not
/// tested.
ResidualTest whiteness(std::span<const double> residuals);

/// Tests whether residuals grow along the recording: F of Goldfeld and Quandt, the squares of the
/// last third over the squares of the first third, against the F quantile. Fewer than 20 samples
/// are not tested.
ResidualTest growth(std::span<const double> residuals);

/// Tests whether residuals are larger after a fit than before: the same F, of the squares after the
/// fit over the squares before it.
ResidualTest worsening(std::span<const double> before, std::span<const double> after);

/// Returns the least step between two recorded values: a count of an encoder, or the last digit. 0:
/// the values are constant.
double resolution(std::span<const double> recorded);

}  // namespace jounce::validate_detail
