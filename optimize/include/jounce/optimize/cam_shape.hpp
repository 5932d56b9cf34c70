// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/optimize/problem.hpp"
#include "jounce/optimize/shape.hpp"

namespace jounce {

/// The jerk at the ends of a run.
enum class EndJerk {
  as_given,  ///< that of the given cam, unless it has a step there: its law decides
  free,      ///< it may step there
  zero,
};

/// A segment of a cam whose law is only the start of the search: any shape may replace it.
struct FreeShape {
  std::size_t segment = 0;   ///< counted from 0
  std::size_t pieces = 100;  ///< polynomials
  int continuity = 4;        ///< continuous derivatives inside, 2 to 6; the degree is one more
  bool monotone = false;     ///< the slave never turns back within the segment
  EndJerk end_jerk = EndJerk::as_given;  ///< if a run begins or ends with this segment
};

/// A cam of which some segments may take any shape.
///
///     CamShapeProblem problem{.cam = cam, .shapes = {{.segment = 1}}};
///     problem.minimize = {{{PeakOf{derivative_of_shape(3)}}}};
///     CamShapeOutcome outcome = optimize_cam_shapes(problem);
///     if (outcome.usable()) Cam better = design(outcome.best).cam;
///
/// **Runs.** Free segments that follow one another, over the seam of a periodic cam too, are one
/// *run*: one function, as smooth at the knots between them as inside. Runs are optimized one
/// after another; a figure is that of one run.
///
/// **Knots.** At the two ends of a run, slave, geo_velocity and geo_acceleration stay as in the
/// given cam. So does geo_jerk if the given cam has no step of it there, unless the shape's
/// end_jerk requires otherwise; `active` of the run then lists it as "kept/geo_jerk". The values in
/// `knots` are free within their bounds, which may be infinite: at knots inside a run, and at the
/// start and the end of a cam that is not periodic. Masters are never free. Everything else of the
/// cam stays as it is, exactly.
///
/// **Order.** Each entry of `minimize` is a weighted sum; where there are several, each is one figure
/// alone, and none that was minimized before may get worse by more than `concession` (relative).
///
/// **Units.** x is the master: quantities depend on the slave's derivatives by master.
struct CamShapeProblem {
  CamSpec cam = {};
  std::vector<FreeShape> shapes = {};  ///< ascending; at least one
  std::vector<FreeKnot> knots = {};    ///< without masters
  Limits limits = {};                  ///< per master unit
  std::vector<Corridor> corridors =
      {};                              ///< from, to in the cam's master; cut to the runs they meet
  std::vector<Ceiling> ceilings = {};  ///< ceilings of each run
  std::vector<std::vector<WeightedFigure>> minimize = {};  ///< most important first
  bool refine = false;
  OptimizeOptions options = {};  ///< those of every run; the time is for all of them
  double concession = 1e-3;
};

/// Throws InputError (keys like "segment[2].free.shape") unless the problem is well posed: a valid cam,
/// an objective, shapes that exist, one continuity in a run, knots that a shape reaches.
void require_valid(const CamShapeProblem& problem);

/// Outcome of one run.
struct CamRunOutcome {
  std::vector<std::size_t> segments;  ///< segments of the spec, in the order of the master
  /// Shape of the last entry of `minimize`. Its figures are those of all entries, then of the ceilings.
  ShapeOutcome shape;
};

/// The cam `best` has laws `hermite` in place of the free ones. Status and reason are those of the worst run;
/// figures, active constraints and counts are those of all runs in turn. `limits` is check(best, limits),
/// with segments of the spec counted from 0.
struct CamShapeOutcome : Outcome<CamSpec> {
  std::vector<CamRunOutcome> runs = {};
};

/// Throws InputError like require_valid().
CamShapeOutcome optimize_cam_shapes(const CamShapeProblem& problem,
                                    const KeepGoing& keep_going = {});

}  // namespace jounce
