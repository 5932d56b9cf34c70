// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

// The functions of extrema.hpp and limits.hpp for a table. The results equal the results for the
// table's curve, except for rounding. (A table stores the positions of its knots, while a curve
// sums lengths.) The functions are ten to a hundred times as fast as the functions for a curve,
// because they search only the intervals that can affect the result. A bound from the Bernstein
// coefficients selects these intervals.
//
//     Report report = check(table, {.velocity = 2, .acceleration = 50});
//     Ranges all = extrema(table);          // position to third derivative: least, greatest, where
//
// All functions throw InputError if a derivative is too large for a double, like Table::curve().
// check() also throws for invalid limits, like check() for a curve.

/// Returns the exact range of the position and its three derivatives.
Ranges extrema(const Table& table);

/// Returns the exact ranges over the intervals `first` to `last`, both included, counted from 0.
/// Requires first <= last < table.size() - 1 (asserted).
Ranges segment_extrema(const Table& table, std::size_t first, std::size_t last);

/// Compares the exact extrema with the limits, like check(table.curve<...>(), limits).
Report check(const Table& table, const Limits& limits);

/// Checks the continuity up to this order, like check_continuity(table.curve<...>(), order,
/// tolerance).
Report check_continuity(const Table& table, int order, double tolerance = 1e-9);

}  // namespace jounce
