// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/pvt/pt.hpp"

#include "gear/src/follow/follow_knots.hpp"

namespace jounce::gear_detail {

/// The interval between two knots.
struct FollowGap {
  double length;  // L
  double travel;  // S
  double r0;
  double r1;
};

FollowGap gap(const FollowKnot& a, const FollowKnot& b);

/// Returns the direction of a gap, 1 or -1: the common sign of the ratios at both ends, or the sign
/// of the travel if both ratios are 0. 0 if the ratios differ in sign.
int way(const FollowGap& gap);

/// A piece of a gap: its length, its travel, and whether its ratio is constant.
struct FollowPiece {
  double length;
  double travel;
  PtType type = PtType::normal;
};

/// Returns pieces of linear ratio that fill a gap. They do not move backwards unless the ratio at
/// an end does. `whole`: they begin and end at whole master units if the gap is long enough.
std::vector<FollowPiece> pieces_of(const FollowGap& gap, bool whole);

}  // namespace jounce::gear_detail
