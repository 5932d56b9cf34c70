// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jounce::profiles_detail {

// Relative tolerances for rounding, one for each origin of a number. Two numbers that differ by
// less than this share of their magnitude count as equal.

inline constexpr double rounded_jerk = 1e-6;    ///< the jerk of a table whose knots are rounded
inline constexpr double rounded_input = 1e-9;   ///< given by a file or another program
inline constexpr double rounded_sum = 1e-12;    ///< the sum or the chain of many values
inline constexpr double rounded_root = 1e-13;   ///< a root, or the solution of a small system
inline constexpr double rounded_value = 1e-14;  ///< the value of a polynomial, or a few operations
inline constexpr double rounded_digit = 1e-15;  ///< the last decimal digit of a double
inline constexpr double two_roundings =
    4e-16;  ///< two operations, each with half a unit in the last place
inline constexpr double one_rounding = 2e-16;  ///< a unit in the last place of a number below 1

}  // namespace jounce::profiles_detail
