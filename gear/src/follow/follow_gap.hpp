// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/pvt/pt.hpp"

#include "gear/src/follow/follow_knots.hpp"

namespace jounce::gear_detail {

/// Interval between two knots.
struct FollowGap {
  double length;  // L
  double travel;  // S
  double r0;
  double r1;
};

FollowGap gap(const FollowKnot& a, const FollowKnot& b);

/// True if a ratio is against both ends': 0 where those differ in sign, or are both 0.
int way(const FollowGap& gap);

/// A piece of a gap: how long, how far, and whether it stands or runs evenly.
struct FollowPiece {
  double length;
  double travel;
  PtType type = PtType::normal;
};

/// The pieces of linear ratio that fill a gap and do not run backwards where its ends do not;
/// `whole`: they begin and end at whole master units where the gap is long enough.
std::vector<FollowPiece> pieces_of(const FollowGap& gap, bool whole);

}  // namespace jounce::gear_detail
