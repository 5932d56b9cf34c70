// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/pvt/reduce.hpp"

#include "pvt/src/sample/interval.hpp"

/// Intervals of quadratic pieces, for controllers whose segments have linear velocity without
/// steps. One piece has too few coefficients for an interval between two knots, so two pieces meet
/// at a knot between them.
namespace jounce::pvt_detail {

/// True if a single quadratic piece connects a and b with the velocities of both.
bool is_one_quadratic(const Knot& a, const Knot& b);

/// The knot at which the two pieces meet: in the middle, or at the nearest step of x. Nothing if
/// the target leaves no place for it. With P = p_b - p_a, and h_a and h_b the lengths of the
/// pieces:
///
///     (1)  v = (2 P - v_a h_a - v_b h_b) / (h_a + h_b),     p = p_a + (v_a + v) h_a / 2
std::optional<Knot> knot_between(const Target& target, const Knot& a, const Knot& b);

/// share() of the two pieces that the target's table has between two knots; infinite if there is no
/// place for the knot between them.
template <class Over>
double share(const Curve<Over>& f, const Target& target, const Knot& a, const Knot& b,
             const Tolerances& tolerances);

}  // namespace jounce::pvt_detail
