// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/cam/laws/spline.hpp"

namespace jounce {

/// Measured points of a cam. m is the unit of the master, u the unit of the slave.
struct MeasuredCam {
  /// The points: masters ascend, each tolerance > 0. The tolerance is the greatest permitted
  /// distance of the cam from the point, in u, and includes the error of the measurement.
  std::vector<SplinePoint> points = {};
  /// True: the cam repeats, and the last point is the first one a period later. If their slave
  /// positions differ by more than the sum of their tolerances, the slave advances in each period.
  bool periodic = false;
};

/// The distance of a segment of a fitted cam from the points.
struct SegmentFit {
  double gap = 0;                ///< u, greatest distance from a point in the segment
  std::optional<Law> next = {};  ///< the law that fits second best, if the segment has a law
  double next_gap = 0;           ///< u, greatest distance of the law `next` from a point; may be
                                 ///< within the tolerance
};

/// A cam through measured points.
struct CamFit {
  CamSpec spec = {};                      ///< the cam
  std::vector<SegmentFit> segments = {};  ///< one for each segment of the spec
  double gap = 0;                         ///< u, greatest distance from a point
  double where = 0;                       ///< m, master position of the point with this distance
  /// u, greatest distance of the cam beyond the tolerance of a point; 0: every point is within its
  /// tolerance. Positive if the first and the last point of a period differ by more than their
  /// tolerances, or if two points of the same dwell do.
  double excess = 0;
};

/// Returns a cam with few segments that passes every point within its tolerance.
///
///     const CamFit fit = fit_cam({.points = measured, .periodic = true});
///     const Cam cam = design(fit.spec).cam;
///
/// A range in which the slave rests becomes a dwell. A motion between two rests gets the law with
/// the least root mean square distance from the points. If this law exceeds a tolerance, laws with
/// an inflection are tried in the same way. If none of them fits, the longest straight line in the
/// motion becomes a segment, and the parts before and after it are fitted separately. A part that
/// no law fits becomes a quintic, or a quintic spline with few points. Then the values of the knots
/// are rounded, as far as the points permit. Knots are at any master positions, not only at the
/// positions of the points.
///
/// Throws InputError for fewer than five points, for points that are not finite or do not ascend,
/// and for a tolerance that is not greater than 0.
CamFit fit_cam(const MeasuredCam& measured);

}  // namespace jounce
