// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// Splines through the points of a table, as segments for a Cam.
///
///     SplineSpec table{.points = {{0, 0}, {60, 12}, {150, 40}, {240, 25}, {360, 0}}};
///     table.ends = SplineEnds::periodic;
///     Cam cam(quintic_spline(table), 0, Extrapolation::wrap);
///     double hardest = extrema(cam, 2).peak().value;      // exact, as for every curve
///
/// **Vocabulary.** The curve passes through the *points*; two segments meet at a *joint*. Every
/// joint is a point. A cubic spline joins its segments up to geo_acceleration, a quintic spline up
/// to the fourth derivative. An end is *clamped* if a derivative is given there, and *natural* if
/// it is omitted: the curve takes the smoothest value.
///
/// **Smoothest.** The cubic spline has the least integral of geo_acceleration^2 of all functions
/// through the points with the given end values; the quintic spline has the least integral of
/// geo_jerk^2 (except with not_a_knot ends).
///
/// **Units.** master m, slave u; derivatives by master: u/m, u/m^2.
///
/// **Throws** InputError unless there are two points or more, all finite, masters ascending; for a
/// derivative that the kind of end does not accept; and for a tolerance that is not zero: for
/// tolerances, see smoothing_spline.hpp.
struct SplinePoint {
  double master = 0;
  double slave = 0;
  double tolerance = 0;  ///< u, >= 0; for smoothing_spline() alone
};

/// Conditions at the first and the last point.
enum class SplineEnds {
  natural,     ///< given values are kept, omitted ones are free
  periodic,    ///< all derivatives wrap from the end to the start; the slave may advance
  not_a_knot,  ///< one polynomial over the first two (quintic: three) intervals, and the last ones
};

/// Derivatives at one end; for SplineEnds::natural alone.
struct SplineEnd {
  std::optional<double> geo_velocity = {};
  std::optional<double> geo_acceleration = {};  ///< quintic_spline() and smoothing_spline() alone
};

struct SplineSpec {
  std::vector<SplinePoint> points;
  SplineEnds ends = SplineEnds::natural;
  SplineEnd start = {};
  SplineEnd end = {};
};

/// The cubic spline: geo_acceleration is continuous, geo_jerk jumps at every point. One segment per
/// interval (not_a_knot: one for the first two, one for the last two; through three points a
/// parabola). An end without a given slope has geo_acceleration zero. Error between the points of a
/// smooth function: order h^4 (natural ends: h^2 near them). Source: C. de Boor, A Practical Guide
/// to Splines, ch. IV.
std::vector<Segment> cubic_spline(const SplineSpec& spec);

/// The quintic spline: continuous up to the fourth derivative, least integral of geo_jerk^2. A
/// natural end has third (and, if the slope is omitted, fourth) derivative zero. Error between
/// points: order h^6 (natural ends: h^3 near them). Through two points with nothing given: the
/// straight line. Source: I. Schoenberg 1964, natural splines of degree 2 m - 1 with m = 3.
std::vector<Segment> quintic_spline(const SplineSpec& spec);

}  // namespace jounce
