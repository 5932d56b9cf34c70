// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/optimize/outcome.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Problem of the best times of a spline.
enum class TimeObjective {
  shortest,           ///< least duration within the limits
  least_peak_jerk,    ///< least max |jerk| over all joints, at a given duration
  least_square_jerk,  ///< least sum over the joints of the integral of jerk^2, at a given duration
};

/// A motion of several joints through points, from rest to rest, as cubic splines with common knots.
///
///     SplineTimesSpec spec;
///     spec.points = {{-10, 20}, {60, 50}, {20, 120}, {55, 35}};          // one entry a joint
///     spec.limits = {{.velocity = 100, .acceleration = 45, .jerk = 60},
///                    {.velocity = 95, .acceleration = 40, .jerk = 60}};
///     const SplineTimes best = spline_times(spec).best;
///     Trajectory joint1 = best.joints[0];                                // best.duration seconds
///
/// **Vocabulary.** Each joint is a C2 cubic spline over the same knots: the points, and two
/// *virtual* knots, the second and the last but one, whose positions make velocity and acceleration
/// zero at both ends (Lin, Chang and Luh, IEEE TAC 28, 1983). The free quantities are the
/// *intervals* between the knots, one more than there are points.
///
/// **Units.** u and s; limits u/s, u/s^2, u/s^3. Position limits are checked, not planned for.
///
/// **Throws** InputError (keys `points[i][j]`, `limits[j]....`, `duration`, `starts`) for fewer
/// than two points or more than 60, points of different size, numbers that are not finite, joints
/// that all stand still, an invalid limit, a joint without a jerk limit (shortest: its first and
/// last interval would shrink to 0), a duration given to `shortest` or not given to the others.
struct SplineTimesSpec {
  std::vector<std::vector<double>>
      points;  ///< u; at least two, each with one position for each joint
  std::vector<Limits> limits =
      {};  ///< one for each joint; for `shortest`, and checked for all objectives
  TimeObjective objective = TimeObjective::shortest;
  double duration = 0;           ///< s: of the other two objectives
  OptimizeOptions options = {};  ///< 24 starts unless stated; no budget
};

/// The times of a spline, and its joints.
struct SplineTimes {
  double duration = 0;             ///< s
  std::vector<double> intervals;   ///< s, between knots
  std::vector<Trajectory> joints;  ///< exact; each holds outside
};

/// Result of spline_times(). `value` is in s, u/s^3 or u^2/s^5. The search is local and proves
/// nothing: it is `converged` if several starts agree on the best to 1e-6, and `stalled` if only
/// one start reached it. `limits` checks all joints by exact extrema. `active`: limits met to 1e-6
/// and peaks of the objective.
struct SplineTimesOutcome : Outcome<SplineTimes> {
  double spread = 0;  ///< relative difference of the best two starts
};

/// The best times found from several starts. Uniform scaling of time is exact (velocity 1/s,
/// acceleration 1/s^2, jerk 1/s^3), so the result of `shortest` keeps every limit, and one is met.
/// keep_going is called after each start.
SplineTimesOutcome spline_times(const SplineTimesSpec& spec, const KeepGoing& keep_going = {});

/// The joints as C2 cubic splines with the given intervals (points + 1 of them, > 0 s);
/// spline_times() varies these.
std::vector<Trajectory> spline_through(const std::vector<std::vector<double>>& points,
                                       const std::vector<double>& intervals);

}  // namespace jounce
