// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/pvt/reduce.hpp"

#include "pvt/src/sample/interval.hpp"
#include "pvt/src/sample/stretches.hpp"

namespace jounce::pvt_detail {

/// The curve's own numbers at x, on one side (at the ends of the curve: inside).
template <class Over>
Knot knot_at(const Curve<Over>& f, double x, Side side);

/// The same numbers as the target's table would contain them: rounded.
template <class Over>
Knot held_at(const Curve<Over>& f, const Target& target, double x, Side side);

/// The knots that may follow a so that the interval stays within the tolerances: first the farthest
/// knot that the target permits, then breaks of the curve near it, from which the next interval may
/// reach farther. No knot is beyond the next end of a stretch, which must be a knot. Empty if no
/// knot can follow. `guess` > 0 is a length to try first, such as the length of the previous
/// interval.
template <class Over>
std::vector<Knot> followers(const Curve<Over>& f, const Target& target, const Knot& a,
                            const Tolerances& tolerances, const std::vector<Straight>& stretches,
                            double guess);

/// The error of an interval is proportional to this power of its length: 2, 4, 6; 3 for two
/// quadratic pieces.
int order(const Target& target);

}  // namespace jounce::pvt_detail
