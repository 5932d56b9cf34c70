// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/optimize/cam_shape.hpp"

/// A run of free segments of a cam, converted to one function to optimize, and back.
namespace jounce::optimize_detail {

/// One knot of a run, with its fixed values and the bounds of its free ones.
struct RunKnot {
  std::size_t knot = 0;  ///< index in the spec
  double master = 0;     ///< its master position in the spec
  /// Length of the cam if the run has passed the end of the period before this knot; otherwise 0.
  double ahead = 0;
  double auxiliary = 0;  ///< advance of the slave in a period, in the same case; otherwise 0
  std::optional<double> slave, geo_velocity, geo_acceleration, geo_jerk;
  FreeKnot free;  ///< bounds of its free values

  /// Its master position in the run.
  [[nodiscard]] double x() const { return master + ahead; }
};

/// A run of free segments. If it extends over the end of the period, segment 0 follows the last
/// one.
struct CamRunOf {
  std::vector<std::size_t> segments;  ///< indices of the segments
  std::vector<RunKnot> knots;         ///< one more than segments
  bool closed = false;                ///< true: the whole periodic cam, both ends are one knot
  double start = 0;                   ///< start of the whole cam
  double length = 0;                  ///< length of the whole cam
  double advance = 0;                 ///< advance of its slave in a period
};

/// Returns the runs of a problem.
std::vector<CamRunOf> runs_of(const CamShapeProblem& problem);

/// Returns the jerks that are fixed at the ends of the run, as findings "kept/geo_jerk".
std::vector<Finding> kept_jerks(const CamRunOf& run);

/// Returns the options of a free segment.
const FreeShape& shape_of(const CamShapeProblem& problem, std::size_t segment);

/// True if a corridor of the cam covers a part of the run.
bool meets(const Corridor& corridor, const CamRunOf& run);

/// Returns the run as a separate problem, with an empty `minimize`. `accuracy` is the relative
/// accuracy of positions: the limits are tightened by its effect on the cam as written.
ShapeProblem shape_problem(const CamShapeProblem& problem, const CamRunOf& run, double accuracy);

/// Returns `cam` with the shape in place of the run's laws: laws `hermite`, and the slave positions
/// of knots that were free.
CamSpec with_shape(CamSpec cam, const CamRunOf& run, const ShapeProblem& problem,
                   const std::vector<Segment>& shape);

}  // namespace jounce::optimize_detail
