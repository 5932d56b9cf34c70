// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// A condition of a polynomial at one position: its value (order 0), or a derivative with respect
/// to the master. u is the slave's unit, m the master's.
struct Condition {
  double at = 0;     ///< m, distance from the start of the segment, in [0, length]
  int order = 0;     ///< 0 to 3
  double value = 0;  ///< u/m^order
};

/// Returns the polynomial of least degree that satisfies all conditions; at most 12 conditions
/// (degree 11). Any combination is permitted, such as an acceleration at a place without a
/// position.
///
///     const Segment f = polynomial(90, std::vector<Condition>{
///         {0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {40, 0, 12}, {90, 0, 30}, {90, 1, 0}, {90, 2, 0}});
///
/// Solved in the Chebyshev basis by pivoted orthogonal transformations. The residuals are about
/// 1e-15 of the polynomial's magnitude.
///
/// Throws InputError for a length that is not positive; for no or too many conditions; for a
/// condition outside [0, length], of another order or not finite; and if the conditions contradict
/// each other or do not determine the polynomial (two values at one position; derivatives without
/// any position).
Segment polynomial(double length, std::span<const Condition> conditions);

}  // namespace jounce
