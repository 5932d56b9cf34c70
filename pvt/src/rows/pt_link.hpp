// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/pvt/pt.hpp"

/// One segment of a PT chain, for pt(), which makes whole curves, and for the player, which takes one at a time.
namespace jounce::pvt_detail {

/// A segment: its increments, and the rates by equation (2) of pt.cpp.
struct PtLink {
  double from;      // position of the point before
  double length;    // T
  double distance;  // P
  PtType type;
  PtRate rate;
};

/// `first` in its pass; `rate`: at the end of the segment before.
PtLink pt_link(const PtPoint& before, const PtPoint& point, bool first, double rate);

/// Equation (1) of pt.cpp.
Segment segment_of(const PtLink& link);

}  // namespace jounce::pvt_detail
