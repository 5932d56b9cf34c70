// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace jounce::pvt_detail {

/// Velocity and acceleration at a knot, and which of them are fixed.
struct JerkKnot {
  std::array<double, 2> state{};  ///< u/x, u/x^2; an output if not fixed
  std::array<bool, 2> fixed{};
};

/// Sets the free states so that the integral of jerk^2 of the quintic pieces through (x, p) is
/// least. Periodic: the last knot is the first one, a period later; both have the same fixed
/// states. Spans of equal size >= 2. Two knots without fixed states get the straight line.
void least_jerk(std::span<const double> x, std::span<const double> p, bool periodic,
                std::span<JerkKnot> knots);

}  // namespace jounce::pvt_detail
