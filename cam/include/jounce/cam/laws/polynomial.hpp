// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// A condition of a polynomial at one position: the value (order 0) or a derivative by master
/// position.
struct Condition {
  double at = 0;  ///< distance from the segment's start, in [0, length]
  int order = 0;  ///< 0...3
  double value = 0;
};

/// The polynomial of least degree that meets all conditions, at most 12 (degree 11). They need not
/// be complete: an acceleration may be given without a position.
///
///     const Segment f = polynomial(90, std::vector<Condition>{
///         {0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {40, 0, 12}, {90, 0, 30}, {90, 1, 0}, {90, 2, 0}});
///
/// Solved in the Chebyshev basis with pivoted orthogonal transformations; residuals are about 1e-15
/// of the polynomial's magnitude.
///
/// Throws InputError for a length that is not positive, no condition or too many, a condition that
/// is outside, of another order or not finite, and if the conditions contradict each other or do
/// not determine the polynomial (two values at one position; derivatives without a position).
Segment polynomial(double length, std::span<const Condition> conditions);

}  // namespace jounce
