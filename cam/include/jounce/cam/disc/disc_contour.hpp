// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/cam/disc/disc.hpp"

namespace jounce {

/// A vertex of a contour, and the piece to the next vertex: a line, or an arc. bulge = tan(a/4),
/// where a is the angle of the arc, positive counterclockwise (as in DXF); 0: a line. u is the
/// slave's unit, a length; m the master's.
struct Vertex {
  double x = 0;       ///< u
  double y = 0;       ///< u
  double bulge = 0;   ///< tan(a/4) of the piece to the next vertex
  double master = 0;  ///< m, master position at the vertex
};

/// A closed curve; the piece of the last vertex leads to the first.
using Contour = std::vector<Vertex>;

/// Pieces of a contour: lines only, or lines and arcs.
enum class Pieces { lines, arcs };

/// Returns the curve parallel to the pitch curve, at `distance` (u) outwards: 0 is the pitch curve
/// itself, -roller_radius the profile, cutter_radius - roller_radius the path of the center of a
/// cutter.
///
/// No point of the true curve is farther than `tolerance` (u, > 0) from the contour. A bound over
/// the whole length of each piece proves this (equations (1) and (2) in disc_contour.cpp), not
/// samples. The vertices lie on the curve, include every break of the cam, and close exactly. If
/// the cam is undercut, the contour includes the loops of the parallel curve.
///
/// Throws InputError("distance", ...) if the distance is not finite, InputError("tolerance", ...)
/// if the tolerance is not positive, or is below 1e-10 of the cam's size, and InputError("cam",
/// ...) if the velocity steps, because the contour would have a corner.
Contour contour(const Disc& disc, double distance, double tolerance, Pieces pieces = Pieces::arcs);

}  // namespace jounce
