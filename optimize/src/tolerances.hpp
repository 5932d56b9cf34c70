// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Relative tolerances that several optimizers share.
namespace jounce::optimizer {

/// Excess over a limit that counts as rounding: the same as in check().
constexpr double rounding_tolerance = 1e-12;

/// Distance from a limit or a peak below which it counts as active.
constexpr double active_tolerance = 1e-6;

}  // namespace jounce::optimizer
