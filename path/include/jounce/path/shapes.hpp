// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "jounce/path/arc.hpp"
#include "jounce/path/point.hpp"
#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// A smooth curve of polynomial pieces for Program::curve, over near arc length.
///
///     const PathCurve half = ellipse({}, {5000, 0}, {10000, 0}, Plane{0, 1}, 0, 0.8, ArcRotation::clockwise, 2);
///     half.length;       // 14180.834
///     half.deviation;    // at most so far from the ellipse: certified
///     half.speed_error;  // | |r'| - 1 | at most: certified
///
/// The pieces are the path: its limits are exact, `deviation` and `speed_error` state how far it is from the shape
/// that was asked for, and from arc length. The feed is never exceeded: the law runs slower by the speed error.
struct PathCurve {
  std::size_t axes = 0;
  std::vector<Segment> segments;  ///< piece by piece, one segment an axis
  Point from{}, to{};
  double length = 0;       ///< in q
  double deviation = 0;    ///< unit of length
  double speed_error = 0;  ///< relative
};

/// Ends of a spline.
struct SplineDirections {
  std::optional<Point> start = {};  ///< tangent, any length; nothing: the curvature is 0 there
  std::optional<Point> end = {};
};

/// The cubic spline through `points`, the first of which is the start, over the length of its chords: twice
/// continuously differentiable, clamped where a direction is given. Throws "points" for fewer than two points or
/// equal neighbors.
PathCurve spline_through(std::span<const Point> points, std::size_t axes,
                         const SplineDirections& ends = {});

/// The B-spline of control points, the first of which is the start: degree 3 to 7, its curvature does not step.
/// `knots`: one for each point, and degree + 1 more; the ends occur degree + 1 times, so the curve begins and ends
/// at its points; empty: evenly spaced. Over its knots, which are far from arc length: see over_length(). Throws
/// "degree", "point", "knots".
PathCurve b_spline(std::span<const Point> points, std::size_t axes, std::size_t degree = 3,
                   std::span<const double> knots = {});

/// A polynomial curve over its arc length, by pieces of degree 7: `deviation` is at most `tolerance` more, by an
/// enclosure of the eighth derivative, and the length of each piece is that of two orders of Gauss. `path_axes`:
/// the first axes, whose length counts; 0: all. Tangent neighbors are then passed without a corner. Throws
/// "tolerance", and "point" at a cusp.
PathCurve over_length(const PathCurve& curve, double tolerance, std::size_t path_axes = 0);

/// Part of an ellipse (PMC600 manual 8.1.4, LS_2AxisEllipses): `degrees` is the angle of the major axis in the
/// plane, `ratio` that of minor to major axis, in (0, 1]; the size follows from the start. Equal ends are one turn;
/// `extra_turns` come on top. All other axes run in proportion to the length. Fitted in arc length, 32 pieces a
/// turn. Throws "to" where the end is off the ellipse by more than `tolerance` of the major half axis.
PathCurve ellipse(const Point& from, const Point& center, const Point& to, Plane plane,
                  double degrees, double ratio, ArcRotation rotation, std::size_t axes,
                  int extra_turns = 0, double tolerance = 1e-6);

}  // namespace jounce
