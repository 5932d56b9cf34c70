// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/pvt/reduce.hpp"

#include "pvt/src/sample/interval.hpp"

namespace jounce::pvt_detail {

/// A straight line of the curve that a reduced table keeps exactly, from knot to knot.
struct Straight {
  Knot begin;
  Knot end;
  bool dwell = false;  ///< true: without motion
};

/// The dwells and straight lines that the target's table keeps exactly, in their order (see
/// stretches.cpp). Their knots are on the target's steps, never outside of the stretch, and have
/// its rate. The knots of a dwell have equal positions and are at rest.
template <class Over>
std::vector<Straight> kept_stretches(const Curve<Over>& f, const Target& target);

}  // namespace jounce::pvt_detail
