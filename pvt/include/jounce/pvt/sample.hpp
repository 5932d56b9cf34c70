// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/ramped_limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// The greatest error of a table against its curve, and its place.
struct SampleError {
  /// Max |table - curve| over the whole interval, in the unit of the position, exact to rounding.
  double position = 0;
  double where = 0;     ///< time or master position of the greatest position error
  double velocity = 0;  ///< max |table' - curve'|, in the unit of the first derivative
};

/// The requirement that determines the number of knots of a table (see reduce.hpp).
enum class Binding {
  none,                ///< none: two knots are enough
  tolerance,           ///< tolerance of the position
  velocity_tolerance,  ///< tolerance of the first derivative
  most,                ///< the number of knots (Target::most); it determines the error
};

/// Returns the binding as a word: "none", "tolerance", "velocity_tolerance", "most".
const char* name(Binding binding);

/// A table and its error.
struct Sampled {
  Table table;
  SampleError error = {};  ///< certified: the exact maximum of the difference, not a sampled one
  std::optional<Binding> binding = {};  ///< for a table of reduced() only
};

/// Returns the table through the curve at the given knots. Throws InputError unless there are at
/// least two knots that ascend strictly, exactly from the start to the end of the curve. If a
/// derivative steps at a knot, the table gets its right limit (at the end: the left limit).
template <class Over>
Sampled sample(const Curve<Over>& f, Interpolation rule, const std::vector<double>& knots);

/// Returns the table with the given columns and its error. Requires columns that cover the interval
/// of the curve; throws InputError like Table. If the curve repeats and the first and last value of
/// a column are equal to rounding, the last value is replaced by the first (positions only if the
/// curve wraps).
template <class Over>
Sampled certified(const Curve<Over>& f, Interpolation rule, Columns columns);

/// Returns the table with `intervals` equal intervals. Throws InputError if `intervals` is 0.
template <class Over>
Sampled sample(const Curve<Over>& f, Interpolation rule, std::size_t intervals);

/// Returns a table with equal intervals in each segment of the curve, as few as bring the position
/// error within `tolerance` (unit of the position) or within rounding, whichever is greater. A
/// segment that the rule represents exactly gets one interval. The breaks of the curve are knots.
/// There are three exceptions. An additional knot precedes a step that the rule cannot represent.
/// An interval in which the table breaks one of the limits, although the curve satisfies it, is
/// halved. Knots so near to each other that rounding would be visible in the jerk are removed or
/// moved apart. Throws InputError unless the tolerance is positive, and if more than about `most`
/// knots would be necessary.
template <class Over>
Sampled sample_within(const Curve<Over>& f, Interpolation rule, double tolerance,
                      const Limits& limits = {}, std::size_t most = 1'000'000,
                      const RampedLimits& ramped = {});

/// Throws InputError with this key if the tolerance is too small for a certificate in double
/// precision. The least tolerance is the greater of 1e-14 of the curve's greatest position and
/// 1e-15 of the sum of a segment's terms.
template <class Over>
void require_certifiable(const Curve<Over>& f, const char* key, double tolerance);

}  // namespace jounce
