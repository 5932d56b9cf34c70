// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/design/design.hpp"

/// Resolves a spec into the data of each segment.
namespace jounce::cam_detail {

/// A segment of the spec between its two knots, ready to be built.
struct Placed {
  std::size_t index = 0;  ///< index in the spec
  const CamSegment* spec = nullptr;
  LawForm form;           ///< includes the inflection that follows from an acceleration
  bool reversed = false;  ///< an R-U law run backwards: U-R
  CamKnot from, to;
  bool closed = false;  ///< a spline over the whole of a periodic cam, with no derivative given

  [[nodiscard]] double length() const { return to.master - from.master; }
};

/// All segments, with every derivative of their knots. Throws like resolved_knots().
std::vector<Placed> resolve(const CamSpec& spec);

/// Builds the segments of one resolved segment. An InputError names the segment.
std::vector<Segment> built(const Placed& segment);

/// built() for the law hermite.
std::vector<Segment> through_hermite_points(const Placed& segment);

/// The shapes that built() adds up, for a law of its own shape.
std::vector<LawPiece> shapes(const Placed& segment);

/// Key of a knot's field: "start.slave", "segment[2].end.geo_velocity".
std::string key_of(std::size_t knot, const char* field);

}  // namespace jounce::cam_detail
