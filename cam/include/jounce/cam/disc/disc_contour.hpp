// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/disc/disc.hpp"

namespace jounce {

/// A corner of a contour and the piece to the next: a line, or an arc with bulge = tan(a/4), where
/// a is its angle, > 0 counterclockwise (as in DXF).
struct Vertex {
  double x = 0;
  double y = 0;
  double bulge = 0;
  double master = 0;  ///< master position at the corner
};

/// A closed curve; the last vertex leads back to the first.
using Contour = std::vector<Vertex>;

/// Lines only, or arcs as well.
enum class Pieces { lines, arcs };

/// The curve parallel to the pitch curve at `distance` outwards: 0 is the pitch curve itself,
/// -roller_radius the profile, cutter_radius - roller_radius the center of a cutter.
///
/// No point of the true curve is further than `tolerance` (u, > 0) from the contour: a bound on its
/// whole length (equations (1) and (2) in disc_contour.cpp) accepts each piece, without samples.
/// Its vertices lie on the curve and include every break of the cam; it closes exactly. If the cam
/// is undercut, it includes the loops of the parallel curve.
///
/// Throws InputError("tolerance", ...) if it is not positive or below 1e-10 of the cam's size, and
/// ("cam", ...) if the velocity steps: the contour would have a corner.
Contour contour(const Disc& disc, double distance, double tolerance, Pieces pieces = Pieces::arcs);

}  // namespace jounce
