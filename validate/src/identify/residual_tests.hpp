// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/validate/identify.hpp"

namespace jounce::validate_detail {

/// True if residuals are white: Ljung and Box's Q over the first 10 autocorrelations (a fifth of the samples, if
/// those are fewer), against the chi-square quantile. Not tested below 20 samples.
ResidualTest whiteness(std::span<const double> residuals);

/// True if residuals grow along the recording: Goldfeld and Quandt's F, the squares of the last third over those of
/// the first, against the F quantile. Not tested below 20 samples.
ResidualTest growth(std::span<const double> residuals);

/// The same F of residuals after a fit over those before it.
ResidualTest worsening(std::span<const double> before, std::span<const double> after);

/// The least step between two recorded values: counts of an encoder, or the last written digit. 0 for a
/// constant.
double resolution(std::span<const double> recorded);

}  // namespace jounce::validate_detail
