// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Relative tolerances that several optimizers share.
namespace jounce::optimize_detail {

/// Excess over a limit that counts as rounding: the same as in check().
constexpr double rounding_tolerance = 1e-12;

/// Distance from a limit or a peak below which it counts as active.
constexpr double active_tolerance = 1e-6;

/// The share of the natural size of a figure below which the figure counts as zero.
constexpr double natural_zero = 1e-9;

/// The least tolerance of an objective that a caller may choose.
constexpr double finest_optimum = 1e-9;

}  // namespace jounce::optimize_detail
