// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

// The functions of extrema.hpp and limits.hpp for a table itself: the same values at the same places
// (the places within rounding: a table keeps the positions of its knots, a curve sums lengths), some
// ten to a hundred times as fast and without making the curve. A bound of every interval, from its
// Bernstein coefficients, selects the few that can matter; those are searched like a curve's segments.
//
//     Report report = check(table, {.velocity = 2, .acceleration = 50});
//     Ranges all = extrema(table);          // position to third derivative: least, greatest, where
//
// Throws InputError for limits like check() of a curve, and, like Table::curve(), if a derivative
// is too large for a double.

/// The exact range of the position and its three derivatives.
Ranges extrema(const Table& table);

/// The same of the intervals from `first` up to `last`, counted from 0.
Ranges segment_extrema(const Table& table, std::size_t first, std::size_t last);

/// Exact extrema against limits: check(table.curve<...>(), limits).
Report check(const Table& table, const Limits& limits);

/// Continuity up to the `order`th derivative: check_continuity(table.curve<...>(), ...).
Report check_continuity(const Table& table, int order, double tolerance = 1e-9);

}  // namespace jounce
