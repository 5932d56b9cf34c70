// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/path/point.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// A circular arc or a helix, in any plane in the space of the axes:
///
///     r(angle) = center + radius (e1 cos angle + e2 sin angle) + drift angle / sweep
///
/// The angle runs from 0 to sweep. e1 points from the center to the start; e2 is perpendicular to
/// e1, in the direction of travel; both have length 1. `drift` is a displacement outside the plane,
/// in proportion to the angle: the pitch of a helix, or the motion of axes that follow the path.
///
///     const Arc half = arc_about(from, {50, 0}, {100, 0}, Plane{0, 1}, ArcRotation::clockwise);
///     const Arc ball = arc_through(from, via, to, 3);            // through three points, in space
///     const Arc screw = arc_about(from, center, {0, 0, 100}, Plane{0, 1},
///                                 ArcRotation::counterclockwise, 4);  // four extra turns
///
/// **Units**: the axes of the plane have the same unit of length; angles are in rad. **Throws**
/// InputError with the reason and the size of the difference; the functions also throw for numbers
/// that are not finite, an invalid plane ("plane"), and negative extra turns ("turns"). The reader
/// of a program adds the line of the program.
struct Arc {
  Point center{}, e1{}, e2{};  ///< center and unit vectors
  double radius = 0;           ///< unit of length
  double sweep = 0;            ///< rad, > 0
  Point drift{};               ///< displacement outside the plane over the whole arc
  Point to{};                  ///< end point, as given
  double center_moved = 0;     ///< distance by which the given center was moved to fit both ends
};

/// Direction of rotation in a plane. Counterclockwise is positive: from the first axis of the plane
/// towards its second axis. Chapters 7 (PathChoice) and 8 (ArcIpo_dir) of the PMC600 manual number
/// the directions in opposite ways; the readers of these programs convert the numbers (decision
/// 0090).
enum class ArcRotation { clockwise, counterclockwise };

/// Plane of an arc: its two axes, counted from 0. G17 is {0, 1}, G18 is {2, 0}, G19 is {1, 2}.
struct Plane {
  std::size_t first = 0;
  std::size_t second = 1;
};

/// Returns the arc from `from` through `via` to `to`, in the space of the first `axes` >= 2 axes.
/// All other axes move to `to` in proportion to the angle; their coordinates of `via` are not used.
/// The arc turns by less than one turn, plus `extra_turns` >= 0 whole turns. Throws InputError
/// "via" if the points coincide or lie on a line (within 1e-9 of the chord).
Arc arc_through(const Point& from, const Point& via, const Point& to, std::size_t axes,
                int extra_turns = 0);

/// Returns the arc around a center to `to`. Only the coordinates of the center in the plane are
/// used. If start and end coincide in the plane, the arc is a full turn. `extra_turns` >= 0 whole
/// turns are added (PMC600 RunCycle). All other axes move in proportion to the angle. If the radii
/// of start and end differ by at most `tolerance` (unit of length), the function moves the center
/// along the bisector of the chord, and `center_moved` is the distance. If they differ by more, or
/// if the center is an end of the arc, it throws InputError "center".
Arc arc_about(const Point& from, const Point& center, const Point& to, Plane plane,
              ArcRotation rotation, int extra_turns = 0, double tolerance = 0.01);

/// Returns an arc of a given radius, as in DIN 66025: a positive radius gives the minor arc (up to
/// half a turn), a negative radius the major arc. Throws InputError "radius" if the chord exceeds
/// twice the radius by more than 1e-9 of it, or if start and end coincide.
Arc arc_of_radius(const Point& from, double radius, const Point& to, Plane plane,
                  ArcRotation rotation, int extra_turns = 0);

/// Returns an arc around a center by an angle in degrees, counterclockwise positive (HIMC
/// ArcAngle2D; PMC600 StopAngle). The axes outside the plane move to `to`. Throws InputError
/// "angle" for an angle of 0, and "center" if the start is the center.
Arc arc_by_angle(const Point& from, const Point& center, double degrees, const Point& to,
                 Plane plane);

/// Direction and extra turns of an arc in HIMC's parameter `turns` (HMPL manual 8.2.17). 0 and 1:
/// counterclockwise, no extra turns. n > 1: counterclockwise, n - 1 extra turns. n < 0:
/// clockwise, |n| - 1 extra turns.
struct CircleTurns {
  ArcRotation rotation = ArcRotation::counterclockwise;
  int extra_turns = 0;
};
/// Returns the direction and the extra turns of HIMC's `turns`.
CircleTurns himc_turns(int turns);

/// Returns the point of an arc at an angle in [0, sweep], rad.
Point point_at(const Arc& arc, double angle);

}  // namespace jounce
