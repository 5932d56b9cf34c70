// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "controllers/src/exchange/exchange_parts.hpp"

/// Rows of numbers between commas, for motions over time.
namespace jounce::controllers_detail {

/// Knots of one axis in a file whose rows count from the row before.
struct Increments {
  double x = 0;  ///< time of the last knot
  double p = 0;  ///< position of the last knot

  /// Adds a knot after `dx` > 0, at `p` + `dp`, with the velocity `v`. Fails for another `dx`.
  void add(const Place& place, int line, double dx, double dp, double v, Exchanged& to);
};

/// Returns the number as text. If it is within rounding of a whole number, it is this number.
std::string tidy_number(double value);
/// Returns `target` - `sum`. If a number of at most nine digits leads from `sum` to `target` within the
/// rounding of a sum, returns this number: a step of 0.05, not 0.04999999999999999. If `sum` is the sum
/// of the numbers before, rounding does not add up.
double increment(double sum, double target);
/// Returns a whole number as text. `value` must be one, as in a table in counts.
std::string whole_number(double value);

}  // namespace jounce::controllers_detail
