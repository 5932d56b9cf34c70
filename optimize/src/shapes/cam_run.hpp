// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/optimize/cam_shape.hpp"

/// A run of free segments of a cam, converted to one function to optimize, and back.
namespace jounce::optimize_detail {

/// One knot of a run: its fixed values, and the bounds of its free ones.
struct RunKnot {
  std::size_t knot = 0;  ///< in the spec
  double master = 0;     ///< master of the spec
  double ahead = 0;      ///< 0, or the length of the cam beyond its seam
  double auxiliary = 0;  ///< 0, or how far the slave advances in a period, beyond the seam
  std::optional<double> slave, geo_velocity, geo_acceleration, geo_jerk;
  FreeKnot free;

  [[nodiscard]] double x() const { return master + ahead; }
};

/// Consecutive free segments. Over the seam, segment 0 follows segment n - 1.
struct CamRunOf {
  std::vector<std::size_t> segments;
  std::vector<RunKnot> knots;  ///< one more than segments
  bool closed = false;         ///< all of a periodic cam: both ends are one knot
  double start = 0;            ///< start of the whole cam
  double length = 0;           ///< length of it
  double advance = 0;          ///< advance of its slave
};

std::vector<CamRunOf> runs_of(const CamShapeProblem& problem);

/// The jerks that are fixed at the ends of the run, as findings "kept/geo_jerk".
std::vector<Finding> kept_jerks(const CamRunOf& run);

const FreeShape& shape_of(const CamShapeProblem& problem, std::size_t segment);

/// True if a corridor of the cam covers some of the run.
bool meets(const Corridor& corridor, const CamRunOf& run);

/// Returns the run as a separate problem, with an empty `minimize`. `accuracy` is the relative
/// accuracy of positions: the limits are tightened by its effect on the cam as written.
ShapeProblem shape_problem(const CamShapeProblem& problem, const CamRunOf& run, double accuracy);

/// Returns `cam` with the shape in place of the run's laws: laws `hermite`, and the slave positions
/// of knots that were free.
CamSpec with_shape(CamSpec cam, const CamRunOf& run, const ShapeProblem& problem,
                   const std::vector<Segment>& shape);

}  // namespace jounce::optimize_detail
