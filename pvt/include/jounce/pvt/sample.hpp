// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// Greatest error of a table against its curve, and the place of it.
struct SampleError {
  double position = 0;  ///< max |table - curve| over the whole interval, in its unit, to rounding
  double where = 0;     ///< on the curve's axis
  double velocity = 0;  ///< max |table' - curve'|, unit of the first derivative
};

/// Why a table has as many knots as it has.
enum class Binding {
  none,                ///< two knots do
  tolerance,           ///< tolerance of the position
  velocity_tolerance,  ///< tolerance of the velocity
  most,                ///< the number of knots determines the error
};

/// "none", "tolerance", "velocity_tolerance", "most".
const char* name(Binding binding);

struct Sampled {
  Table table;
  SampleError error;  ///< certified: the exact maximum of the difference, not a sampled one
  std::optional<Binding> binding = {};  ///< binding of a table of fewest knots: reduce.hpp
};

/// The table through the curve at the given knots (strictly ascending, first and last at the ends
/// of the curve). At a knot where a derivative jumps the right limit is taken (the left one at the
/// end).
template <class Over>
Sampled sample(const Curve<Over>& f, Interpolation rule, const std::vector<double>& knots);

/// The table of these columns, which span the curve, and its error. For a curve that repeats, a
/// column whose end equals its begin to rounding gets exactly that value at its end.
template <class Over>
Sampled certified(const Curve<Over>& f, Interpolation rule, Columns columns);

/// `intervals` >= 1 equal ones.
template <class Over>
Sampled sample(const Curve<Over>& f, Interpolation rule, std::size_t intervals);

/// Each segment of the curve in as few equal intervals as keep the position error within
/// `tolerance` > 0 (unit of the position). A segment that the rule holds exactly gets one. Breaks
/// of the curve are knots. An interval that exceeds one of the `limits` is halved until it keeps the limit, or
/// the curve's own greatest value if the curve exceeds the limit. So the table keeps the limits that the curve keeps,
/// unless a derivative steps that the rule cannot step in. Throws InputError if more than `most` knots are necessary
/// for the tolerance.
template <class Over>
Sampled sample_within(const Curve<Over>& f, Interpolation rule, double tolerance,
                      const Limits& limits = {}, std::size_t most = 1'000'000);

/// Throws InputError, under `key`, for a tolerance that doubles cannot certify for this curve:
/// below 1e-14 of its greatest position, or 1e-15 of the sum of a segment's terms if that is more.
template <class Over>
void require_certifiable(const Curve<Over>& f, const char* key, double tolerance);

}  // namespace jounce
