// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce::pvt_detail {

/// A knot of a table to be: its place, the side of the curve there whose limits it takes, and the
/// numbers that the table will hold.
struct Knot {
  double x = 0;
  Side side = Side::right;
  Jet jet{};
};

/// For position and velocity; infinite where nothing is asked.
struct Tolerances {
  double position = 0;
  double velocity = 0;
};

/// The piece of the table from knot a to knot b.
Segment between(Interpolation rule, const Knot& a, const Knot& b);

/// The share of its tolerances that the table uses up from knot a to knot b: the greater ratio of error to
/// tolerance. It is exact (see interval.cpp) up to 1; above that it is some number above 1, at most the true
/// one. Does not allocate beyond a scratch of the thread.
template <class Over>
double share(const Curve<Over>& f, Interpolation rule, const Knot& a, const Knot& b,
             const Tolerances& tolerances);

}  // namespace jounce::pvt_detail
