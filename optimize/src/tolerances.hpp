// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Tolerances that several optimizers share, all relative.
namespace jounce::optimizer {

/// The excess over a limit that counts as rounding: the same as in check().
constexpr double rounding_tolerance = 1e-12;

/// The distance from a limit or a peak below which it counts as active.
constexpr double active_tolerance = 1e-6;

}  // namespace jounce::optimizer
