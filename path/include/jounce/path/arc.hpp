// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/path/point.hpp"

namespace jounce {

/// A circular arc or a helix in any plane of any axes:
///
///     r(angle) = center + radius (e1 cos angle + e2 sin angle) + drift angle / sweep
///
/// with angle from 0 to sweep. e1 points from the center to the start, e2 is perpendicular to it in the
/// direction of travel; both have length 1. `drift` moves the axes outside the plane in proportion to
/// the angle: the pitch of a helix, and followers.
///
///     const Arc half = arc_about(from, {50, 0}, {100, 0}, Plane{0, 1}, ArcRotation::clockwise);
///     const Arc ball = arc_through(from, via, to);                 // any plane of all axes
///     const Arc screw = arc_about(from, center, {0, 0, 100}, Plane{0, 1},
///                                 ArcRotation::counterclockwise, 4);  // four extra turns
///
/// **Units**: the axes of the plane share one unit of length; angles in rad. **Throws** InputError, which
/// names what does not fit and by how much; the reader of a program adds the line.
struct Arc {
  Point center{}, e1{}, e2{};
  double radius = 0;
  double sweep = 0;         ///< rad, > 0
  Point drift{};            ///< displacement over the whole arc
  Point to{};               ///< end, as given
  double center_moved = 0;  ///< distance by which a given center was moved, so that both ends fit
};

/// Sense of rotation in a plane, from its first axis towards its second axis: counterclockwise is positive.
/// PMC600 chapter 7 (PathChoice) and chapter 8 (ArcIpo_dir) number it in opposite ways; they are mapped
/// where they are read (decision 0090).
enum class ArcRotation { clockwise, counterclockwise };

/// Plane of an arc: its two axes, counted from 0. G17: {0, 1}; G18: {2, 0}; G19: {1, 2}.
struct Plane {
  std::size_t first = 0;
  std::size_t second = 1;
};

/// Arc from `from` through `via` to `to`, less than one turn (+ whole `extra_turns` >= 0); in space, of all
/// `axes` >= 2 axes. Throws "via" for points that lie on a line (within 1e-9 of the chord) or coincide.
Arc arc_through(const Point& from, const Point& via, const Point& to, std::size_t axes,
                int extra_turns = 0);

/// Arc about a center (its coordinates in the plane count) to `to`. Where the ends coincide in the plane
/// it is a full turn. `extra_turns` >= 0 whole turns come on top (PMC600 RunCycle). All other axes run in
/// proportion to the angle. Radii that differ by at most `tolerance` (unit of length): the center moves
/// along the bisector of the chord, and `center_moved` states how far; otherwise throws "center".
Arc arc_about(const Point& from, const Point& center, const Point& to, Plane plane,
              ArcRotation rotation, int extra_turns = 0, double tolerance = 0.01);

/// Arc with a radius: positive for the minor arc (up to half a turn), negative for the major arc, as in
/// DIN 66025. Throws "radius" where the chord exceeds twice the radius by more than 1e-9 of it, or the ends
/// coincide.
Arc arc_of_radius(const Point& from, double radius, const Point& to, Plane plane, ArcRotation rotation,
                  int extra_turns = 0);

/// Arc about a center by an angle in degrees, counterclockwise positive (HIMC ArcAngle2D; PMC600 StopAngle);
/// the axes outside the plane go to `to`.
Arc arc_by_angle(const Point& from, const Point& center, double degrees, const Point& to,
                 Plane plane);

/// Extra turns and sense of HIMC's `turns` (HMPL manual 8.2.17): 0 and 1 are a plain counterclockwise arc, n > 1
/// adds n - 1 turns, n < 0 is clockwise with |n| - 1 extra turns.
struct CircleTurns {
  ArcRotation rotation = ArcRotation::counterclockwise;
  int extra_turns = 0;
};
CircleTurns himc_turns(int turns);

/// Point of an arc at an angle in [0, sweep].
Point point_at(const Arc& arc, double angle);

}  // namespace jounce
