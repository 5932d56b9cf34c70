// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/optimize/outcome.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Objective for the times of a spline.
enum class TimeObjective {
  shortest,           ///< least duration within the limits
  least_peak_jerk,    ///< least max |jerk| over all joints, for a given duration
  least_square_jerk,  ///< least sum over all joints of the integral of jerk^2, for a given duration
};

/// A motion of several joints through points, from rest to rest, as cubic splines with common
/// knots.
///
///     SplineTimesSpec spec;
///     spec.points = {{-10, 20}, {60, 50}, {20, 120}, {55, 35}};  // 4 points of 2 joints
///     spec.limits = {{.velocity = 100, .acceleration = 45, .jerk = 60},
///                    {.velocity = 95, .acceleration = 40, .jerk = 60}};
///     const SplineTimes best = spline_times(spec).best;
///     Trajectory joint1 = best.joints[0];                                // best.duration seconds
///
/// **Splines.** Each joint is a cubic spline with continuous acceleration. All joints have the same
/// knots: the points, and two *virtual* knots, one after the first point and one before the last.
/// The positions of the virtual knots make velocity and acceleration zero at both ends (Lin, Chang
/// and Luh, IEEE TAC 28, 1983). The *intervals* between the knots are free. Their number is the
/// number of points plus one.
///
/// **Units.** Positions in u (unit of the joint), time in s, limits in u/s, u/s^2, u/s^3. The
/// search does not consider position limits, but the outcome reports a broken one.
///
/// **Errors.** Throws InputError (keys `points[i][j]`, `limits[j]....`, `duration`, `starts`) in
/// these cases: fewer than two or more than 60 points; points of different size; numbers that are
/// not finite; joints that all stand still; an invalid limit; with `shortest`, a joint without a
/// jerk limit (its first and last interval would shrink to 0) or a given duration; with the other
/// objectives, no duration.
struct SplineTimesSpec {
  /// Points, u: at least two, each with one position for each joint.
  std::vector<std::vector<double>> points = {};
  /// Limits of each joint, required for `shortest`. The result is checked against them for all
  /// objectives.
  std::vector<Limits> limits = {};
  TimeObjective objective = TimeObjective::shortest;  ///< objective of the search
  double duration = 0;           ///< given duration for the other two objectives, s
  OptimizeOptions options = {};  ///< default: 24 starts; the budget is not used
};

/// The times of a spline, and the motions of its joints.
struct SplineTimes {
  double duration = 0;                  ///< whole duration, s
  std::vector<double> intervals = {};   ///< times between the knots, s
  std::vector<Trajectory> joints = {};  ///< motion of each joint; constant before and after
};

/// Result of spline_times(). `value` is in s, u/s^3 or u^2/s^5, depending on the objective. The
/// search is local and proves nothing: the status is `converged` if several starts agree on the
/// best result to 1e-6, and `stalled` if only one start reached it. `limits` checks all joints by
/// exact extrema. `active` has the limits that are reached to 1e-6, and the peaks of the objective.
struct SplineTimesOutcome : Outcome<SplineTimes> {
  double spread = 0;  ///< relative difference between the two best starts
};

/// Returns the best times from several starts. A change of the whole duration scales velocity,
/// acceleration and jerk exactly, so the result of `shortest` satisfies every limit and reaches one
/// of them. keep_going is called after each start.
SplineTimesOutcome spline_times(const SplineTimesSpec& spec, const KeepGoing& keep_going = {});

/// Returns the joints as cubic splines with these intervals (s). (spline_times() varies these
/// intervals.) Throws InputError for points that SplineTimesSpec does not permit, unless the number
/// of intervals is the number of points plus one, and for an interval that is not positive.
std::vector<Trajectory> spline_through(const std::vector<std::vector<double>>& points,
                                       const std::vector<double>& intervals);

}  // namespace jounce
