// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jounce::profiles_detail {

/// Relative: after such a step of Newton's iteration the next is lost in rounding.
inline constexpr double last_newton_step = 1e-9;
/// The same for an iteration of third order.
inline constexpr double last_cubic_step = 1e-5;
/// A quotient too near to the least double for its cube root.
inline constexpr double least_cubed = 1e-290;
/// Durations that differ by less than this share count as equal.
inline constexpr double same_duration = 1e-12;

}  // namespace jounce::profiles_detail
