// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// An extreme value of a curve, and its place.
struct Extremum {
  double value = 0;         ///< in the unit of the value or its derivative
  double where = 0;         ///< time or master position
  Side side = Side::right;  ///< side from which the curve approaches the value; matters only at a
                            ///< jump
};

/// The least and the greatest value.
struct Range {
  Extremum min = {};
  Extremum max = {};

  /// The extremum of larger magnitude.
  [[nodiscard]] const Extremum& peak() const;
};

/// The ranges of the value and of its first, second and third derivative.
using Ranges = std::array<Range, 4>;

/// Returns the exact range of the derivative of this order (0: the value, at most 3) over the whole
/// curve. At a jump, both one-sided limits count. Critical points are exact roots of the
/// derivative, not found by sampling (see roots.hpp). Of several equal extrema, the function
/// returns the first. The error is rounding: about 1e-15 of the curve's magnitude. All functions of
/// this header with an `order` throw InputError unless it is from 0 to 3.
template <class Over>
Range extrema(const Curve<Over>& f, int order);

/// Returns the exact ranges of the orders 0 to 3.
template <class Over>
Ranges extrema(const Curve<Over>& f);

/// Returns the range of one derivative on the segment with this index, counted from 0.
template <class Over>
Range segment_range(const Curve<Over>& f, std::size_t segment, int order);

/// Returns the range of one derivative on a segment that extends from `start` to `end`.
Range segment_range(const Segment& f, double start, double end, int order);

/// Returns the ranges of all four orders on one segment, or on the segments `first` to `last`, both
/// included. Segments are counted from 0.
template <class Over>
Ranges segment_extrema(const Curve<Over>& f, std::size_t segment);
template <class Over>
Ranges segment_extrema(const Curve<Over>& f, std::size_t first, std::size_t last);

/// Like segment_extrema() above, for a segment that extends from `start` to `end`.
Ranges segment_extrema(const Segment& f, double start, double end);

/// Widens `ranges` by the ranges of the next segment, which extends from `start` to `end`. The
/// result is the same as with segment_extrema(), but faster: the function skips a derivative if its
/// bounds on the segment lie within its present range.
void widen(Ranges& ranges, const Segment& f, double start, double end);

/// Widens `ranges` by the ranges `after` of a later part of the curve. Of equal extrema, the
/// earlier one stays.
void widen(Ranges& ranges, const Ranges& after);

/// A step of a derivative at a break.
struct Jump {
  double step = 0;   ///< right limit minus left limit
  double where = 0;  ///< time or master position
};

/// Returns the largest step (in magnitude) of the derivative of this order; 0 if the derivative has
/// no step. The function considers
/// - all interior breaks;
/// - for a curve with the policy `wrap`, the step from its end to its start (with the policy
///   `advance`, only from order 1);
/// - for a curve with the policy `hold`, from order 1, the steps from rest at its start and to rest
///   at its end.
template <class Over>
Jump largest_jump(const Curve<Over>& f, int order);

}  // namespace jounce
