// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/disc/disc.hpp"

namespace jounce {

/// A corner of a contour and the way to the next: a line, or an arc with bulge = tan(a/4), a the
/// angle it turns through, > 0 counterclockwise (as in DXF).
struct Vertex {
  double x = 0;
  double y = 0;
  double bulge = 0;
  double master = 0;  ///< the master's position there
};

/// A closed curve; the last vertex leads back to the first.
using Contour = std::vector<Vertex>;

/// Lines only, or arcs as well.
enum class Pieces { lines, arcs };

/// The curve parallel to the pitch curve at `distance` outwards: 0 is the pitch curve itself,
/// -roller_radius the profile, cutter_radius - roller_radius the centre of a cutter.
///
/// No point of the true curve is further than `tolerance` (u, > 0) from the contour: each piece is
/// accepted by a bound (equations (1) and (2) in disc_contour.cpp) on its whole length, none by samples.
/// Its vertices lie on the curve, at every break of the cam among others, and it closes exactly.
/// Where the cam is undercut, the loops of the parallel curve are part of it.
///
/// Throws InputError("tolerance", ...) if it is not positive or below 1e-10 of the cam's size, and
/// ("cam", ...) where the velocity steps: the contour would have a corner.
Contour contour(const Disc& disc, double distance, double tolerance, Pieces pieces = Pieces::arcs);

}  // namespace jounce
