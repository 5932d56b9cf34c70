// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/pvt/pt.hpp"

/// One segment of a PT chain: for pt(), which makes whole curves, and for the player, which
/// computes one segment at a time.
namespace jounce::pvt_detail {

/// A segment: its increments, and its rates by equation (2) of pt.cpp.
struct PtLink {
  double from;      // position of the previous point
  double length;    // T
  double distance;  // P
  PtType type;
  PtRate rate;
};

/// Computes a link. `first`: it is the first segment of its pass. `rate`: end rate of the previous
/// segment.
PtLink pt_link(const PtPoint& before, const PtPoint& point, bool first, double rate);

/// The segment by equation (1) of pt.cpp.
Segment segment_of(const PtLink& link);

}  // namespace jounce::pvt_detail
