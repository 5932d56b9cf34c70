// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// Splines through the points of a table, as segments for a Cam.
///
///     SplineSpec table{.points = {{0, 0}, {60, 12}, {150, 40}, {240, 25}, {360, 0}}};
///     table.ends = SplineEnds::periodic;
///     Cam cam(quintic_spline(table), 0, Extrapolation::wrap);
///     double hardest = extrema(cam, 2).peak().value;      // exact, as for every curve
///
/// **Vocabulary.** The curve passes through the *points*. Two segments meet at a *break*, which is
/// one of the points. At its breaks, a cubic spline is continuous up to geo_acceleration, a quintic
/// spline up to the fourth derivative. An end is *clamped* if a derivative is given for it, and
/// *natural* if the derivative is omitted: the spline then chooses the smoothest value.
///
/// **Smoothest.** Of all functions through the points with the given end values, the cubic spline
/// has the least integral of geo_acceleration^2, and the quintic spline the least integral of
/// geo_jerk^2 (except with not_a_knot ends).
///
/// **Units.** Master m, slave u; derivatives with respect to the master in u/m, u/m^2.
///
/// **Throws** InputError unless there are at least two points, all finite, with ascending masters;
/// for a derivative that the kind of end does not accept; and for a tolerance that is not zero
/// (smoothing_spline() accepts tolerances).

/// A point of a spline.
struct SplinePoint {
  double master = 0;     ///< m
  double slave = 0;      ///< u
  double tolerance = 0;  ///< u, >= 0; for smoothing_spline() only
};

/// Conditions at the first and at the last point.
enum class SplineEnds {
  natural,   ///< given derivatives apply, omitted derivatives are free
  periodic,  ///< value and derivatives continue from the end to the start; the slave may advance
  /// The first two intervals share one polynomial, and so do the last two (quintic: three).
  not_a_knot,
};

/// Derivatives at one end; for SplineEnds::natural only.
struct SplineEnd {
  std::optional<double> geo_velocity = {};  ///< u/m
  /// u/m^2; for quintic_spline() and smoothing_spline() only.
  std::optional<double> geo_acceleration = {};
};

/// Input of the splines.
struct SplineSpec {
  std::vector<SplinePoint> points = {};
  SplineEnds ends = SplineEnds::natural;  ///< kind of both ends
  SplineEnd start = {};                   ///< derivatives at the first point
  SplineEnd end = {};                     ///< derivatives at the last point
};

/// Returns the cubic spline: geo_acceleration is continuous, geo_jerk steps at every break. It has
/// one segment for each interval (not_a_knot: one for the first two and one for the last two; three
/// points give a parabola). An end without a given slope has geo_acceleration zero. For points of a
/// smooth function at distance h, the error is of order h^4 (near natural ends h^2). Source: C. de
/// Boor, A Practical Guide to Splines, ch. IV.
std::vector<Segment> cubic_spline(const SplineSpec& spec);

/// Returns the quintic spline: continuous up to the fourth derivative, least integral of
/// geo_jerk^2. At a natural end the third derivative is zero, and also the fourth if the slope is
/// omitted. For points of a smooth function at distance h, the error is of order h^6 (near natural
/// ends h^3). Two points without derivatives give the straight line. Source: I. Schoenberg 1964,
/// natural splines of degree 2 m - 1 with m = 3.
std::vector<Segment> quintic_spline(const SplineSpec& spec);

}  // namespace jounce
