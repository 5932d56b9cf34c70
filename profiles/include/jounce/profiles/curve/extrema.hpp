// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A value that a curve takes (or approaches, from `side`), and its place.
struct Extremum {
  double value = 0;
  double where = 0;
  Side side = Side::right;
};

/// The least and the greatest value.
struct Range {
  Extremum min;
  Extremum max;

  /// Whichever of the two is larger in magnitude.
  [[nodiscard]] const Extremum& peak() const;
};

/// Value, first, second and third derivative of one stretch of the curve.
using Ranges = std::array<Range, 4>;

/// The exact range of the `order`th derivative (0: the value) over the closed curve, both one-sided
/// limits at every jump included. Critical points are isolated, not sampled (see roots.hpp); the
/// first of equal extrema is reported. Accurate to rounding: about 1e-15 of the curve's magnitude.
template <class Over>
Range extrema(const Curve<Over>& f, int order);

/// The same for all four orders at once.
template <class Over>
Ranges extrema(const Curve<Over>& f);

/// The range of one derivative on one segment of the curve, by index.
template <class Over>
Range segment_range(const Curve<Over>& f, std::size_t segment, int order);

/// The same of a segment that lies between `start` and `end` on its axis.
Range segment_range(const Segment& f, double start, double end, int order);

/// All four orders for one segment of the curve, by index, and for several from `first` up to `last`.
template <class Over>
Ranges segment_extrema(const Curve<Over>& f, std::size_t segment);
template <class Over>
Ranges segment_extrema(const Curve<Over>& f, std::size_t first, std::size_t last);

/// A step of the `order`th derivative at a break: its size and place.
struct Jump {
  double step = 0;  ///< right limit minus left limit
  double where = 0;
};

/// The largest step (in magnitude) at the interior breaks. For a curve that wraps, also from its
/// end to its start (for one that advances, only of the derivatives). For one that holds, steps of
/// the derivatives also from rest at its start and to rest at its end. Zero if there is none.
template <class Over>
Jump largest_jump(const Curve<Over>& f, int order);

}  // namespace jounce
