// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/convert.hpp"

namespace jounce::design_detail {

/// Returns the table in the requested units, periodic if requested.
TableFile in_units(TableFile file, const Conversion& wanted);
/// Returns a table of the input with the requested knots: the knots that the target determines,
/// equal intervals, or the knots of the input.
Sampled with_knots(const Input& input, const Conversion& wanted);

/// Returns the default tolerance of a conversion, in the unit of the position: a ten-thousandth of
/// the stroke, but at least the rounding of the numbers.
double default_tolerance(const Input& input);

/// Returns the table that a controller plays from a file in wanted.format: with its units, its
/// counts and its interpolation. If no knots are requested, the knots of the input are kept when
/// their error is within the tolerance; otherwise the fewest knots within the tolerance replace
/// them.
Converted for_controller(const Input& input, const Conversion& wanted);

}  // namespace jounce::design_detail
