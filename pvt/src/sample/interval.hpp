// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce::detail {

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

/// How much of its tolerances the table uses up from knot a to knot b: the greater of the two errors
/// over theirs, exact (see interval.cpp) as far as it is at most 1. Above that something in (1, the
/// true one]. Does not allocate beyond a scratch of the thread.
template <class Over>
double share(const Curve<Over>& f, Interpolation rule, const Knot& a, const Knot& b,
             const Tolerances& tolerances);

}  // namespace jounce::detail
