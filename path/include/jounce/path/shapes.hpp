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

/// A smooth curve of polynomial pieces for Program::curve(). The parameter of
/// ellipse() and over_length() is nearly the arc length.
///
///     const PathCurve half = ellipse({}, {5000, 0}, {10000, 0}, Plane{0, 1}, 0, 0.8,
///                                    ArcRotation::clockwise, 2);
///     half.length;       // 14180.834
///     half.deviation;    // certified bound of the distance from the ellipse
///     half.speed_error;  // certified bound of | |r'| - 1 |
///
/// The motion follows these pieces, so limits are checked exactly. `deviation` bounds the distance from the
/// pieces to the requested shape. `speed_error` bounds the difference between the parameter and arc
/// length; the timing law is slower by this share, so the motion never exceeds the feed.
struct PathCurve {
  std::size_t axes = 0;                ///< number of axes
  std::vector<Segment> segments = {};  ///< for each piece, one segment for each axis
  Point from{}, to{};                  ///< start and end
  double length = 0;                   ///< length of the interval of the parameter
  double deviation = 0;                ///< bound, unit of length
  double speed_error = 0;              ///< bound, relative
};

/// Directions of a spline at its ends.
struct SplineDirections {
  /// Tangent at the start, any length; omitted: curvature 0 at the start.
  std::optional<Point> start = {};
  std::optional<Point> end = {};  ///< tangent at the end
};

/// Returns the cubic spline through `points`; the first point is the start. The parameter is the
/// length of the chords. The spline is twice continuously differentiable, and has the given
/// directions at its ends. Length is measured in the first `path_axes` axes; in all axes if
/// `path_axes` is 0 or only followers move. Throws InputError "points" for fewer than two points, or for neighbors
/// without a distance in these axes.
PathCurve spline_through(std::span<const Point> points, std::size_t axes,
                         const SplineDirections& ends = {}, std::size_t path_axes = 0);

/// Returns the B-spline of the given control points, of degree 3 to 7, with continuous curvature.
/// The first point is the start. `knots` has points.size() + degree + 1 values. The first and the
/// last knot occur degree + 1 times, so the curve begins and ends at its end points. If `knots` is
/// empty, the knots are evenly spaced. The parameter of the result is the parameter of the knots,
/// which is far from arc length; convert it with over_length(). Throws InputError "degree",
/// "point", "knots".
PathCurve b_spline(std::span<const Point> points, std::size_t axes, std::size_t degree = 3,
                   std::span<const double> knots = {});

/// Returns a polynomial curve as a function of arc length, by pieces of degree 7. `deviation` grows
/// by at most `tolerance` (unit of length); an enclosure of the eighth derivative proves this.
/// Lengths are computed by Gauss quadrature of two orders. Length is measured in the first
/// `path_axes` axes; in all axes if `path_axes` is 0 or only followers move. Where pieces meet
/// tangentially, there is no corner. Throws InputError "tolerance", and "point" at a cusp.
PathCurve over_length(const PathCurve& curve, double tolerance, std::size_t path_axes = 0);

/// Options of ellipse().
struct EllipseOptions {
  int extra_turns = 0;  ///< whole turns that are added
  /// Greatest distance of the end from the ellipse, as a share of the major half axis.
  double tolerance = 1e-6;
  std::size_t path_axes = 0;  ///< number of axes in which length is measured; 0: all
};

/// Returns a part of an ellipse (PMC600 manual 8.1.4, LS_2AxisEllipses), as a fit in arc length
/// with 32 pieces for each turn. `degrees` is the angle of the major axis in the plane, and
/// `ratio`, in (0, 1], the minor axis divided by the major axis. The start determines the size. If
/// start and end are equal, the part is a full turn. All other axes move in proportion to the
/// length. Throws InputError "to" if the end is farther from the ellipse than the tolerance, and
/// "ratio", "plane" or "turns" for a value out of range.
PathCurve ellipse(const Point& from, const Point& center, const Point& to, Plane plane,
                  double degrees, double ratio, ArcRotation rotation, std::size_t axes,
                  const EllipseOptions& options = {});

}  // namespace jounce
