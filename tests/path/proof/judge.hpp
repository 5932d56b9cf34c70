// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "path/proof/case.hpp"

namespace jounce::path_proof {

/// Worst numbers of all cases.
struct Worst {
  double excess = -1;  ///< over a limit, as a share of it; negative: below the limit
  double end = 0;      ///< error of an end, as a share of the sizes of coordinates and path
  double wide = 0;     ///< deviation, as a share of the permitted one
};

/// Requirements of a motion.
struct Demand {
  Point from{}, to{};
  double size = 0;      ///< greatest coordinate or length: rounding is a share of it
  double duration = 0;  ///< s
  double velocity =
      0;  ///< greatest velocity along the path: directions differ by rounding at a joint
  bool steps = false;  ///< true: the acceleration may step
  /// Rounding of a position, as a share of `size`. Over a segment of the time T, it changes the velocity by
  /// rounding size / T and the acceleration by rounding size / T^2.
  double rounding = 0;
};

// Each function returns what is wrong, or "".

/// The axes join in position, velocity and acceleration, stay within the limits everywhere, and move from rest at
/// `from` to rest at `to`.
std::string judge_axes(const PlanAxes& axes, const GroupLimits& limits, const Demand& demand,
                       Worst& worst);

/// A plan of the case: judge_axes(), its deviations, its duration, and the limits along the path. `rounding`: see
/// Demand.
std::string judge_plan(const Case& c, const Plan& plan, Worst& worst, double rounding = 0);

/// A motion along the path of `plan`, such as one held: judge_axes(), and every place of it is one of that path.
/// It begins at q = `from` and ends at rest.
std::string judge_motion(const Case& c, const Plan& plan, const Plan& motion, double from,
                         Worst& worst);

/// Every rounded corner is as near to its point and to its sides as its command permits.
std::string judge_corners(const Case& c, const Plan& plan, Worst& worst);

/// Every place of an averaged path is near the place of the lines with the same length before it.
std::string judge_average(const Case& c, const Plan& plan, Worst& worst);

/// Time of lines with a stop behind each of them, and of the dwells: by formulas.
double time_with_stops(const Case& c);

/// Point of a path at q.
Point point_at_length(const Path& path, double q);

double distance(const Point& a, const Point& b, std::size_t axes = max_axes);

}  // namespace jounce::path_proof
