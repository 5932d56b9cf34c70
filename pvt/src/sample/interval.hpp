// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce::pvt_detail {

/// A knot of a future table: its position, the side of the curve whose limits it has, and the
/// numbers that the table will contain.
struct Knot {
  double x = 0;
  Side side = Side::right;
  Jet jet{};
};

/// Tolerances of position and velocity; infinite: no requirement.
struct Tolerances {
  double position = 0;
  double velocity = 0;
};

/// The piece of the table from knot a to knot b.
Segment between(Interpolation rule, const Knot& a, const Knot& b);
/// The share of its tolerances that the table uses from knot a to knot b: the greater of the two
/// ratios of error to tolerance. It is exact up to 1 (see interval.cpp). Above 1 it is a number
/// above 1 that is at most the true share. Allocates only the scratch memory of the thread.
template <class Over>
double share(const Curve<Over>& f, Interpolation rule, const Knot& a, const Knot& b,
             const Tolerances& tolerances);

}  // namespace jounce::pvt_detail
