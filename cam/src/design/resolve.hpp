// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/design/design.hpp"

/// From a spec to what each segment is made of.
namespace jounce::camming {

/// A segment of the spec between its two knots, ready to be built.
struct Placed {
  std::size_t index = 0;  ///< in the spec
  const CamSegment* spec = nullptr;
  LawForm form;           ///< with the inflection that follows from an acceleration
  bool reversed = false;  ///< an R-U law run backwards: U-R
  CamKnot from, to;
  bool closed = false;  ///< a spline that is the whole of a periodic cam, with nothing given

  [[nodiscard]] double length() const { return to.master - from.master; }
};

/// All segments, every derivative of their knots filled in. Throws as resolved_knots() does.
std::vector<Placed> resolve(const CamSpec& spec);

/// The finished segments of one. What goes wrong is named by the segment: InputError.
std::vector<Segment> built(const Placed& segment);

/// built() for the law hermite.
std::vector<Segment> through_hermite_points(const Placed& segment);

/// The shapes that built() adds up, for a law of its own shape.
std::vector<LawPiece> shapes(const Placed& segment);

/// "start.slave", "segment[2].end.geo_velocity": what a knot's field is called.
std::string key_of(std::size_t knot, const char* field);

}  // namespace jounce::camming
