// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/optimize/problem.hpp"
#include "jounce/optimize/shape.hpp"

namespace jounce {

/// Condition for the jerk at an end of a run of free segments (see CamShapeProblem).
enum class EndJerk {
  /// The jerk of the given cam; if the jerk of the cam steps at this end, the jerk that the law of
  /// the segment has there.
  as_given,
  free,  ///< any value: the jerk may step
  zero,  ///< 0; requires a continuity of at least 3
};

/// A segment of a cam that may get any shape. Its law is only the start of the search.
struct FreeShape {
  std::size_t segment = 0;   ///< index of the segment, from 0
  std::size_t pieces = 100;  ///< number of polynomials, 1 to 2000
  /// Continuous derivatives between the polynomials, 2 to 6, the same in all free segments; their
  /// degree is one more.
  int continuity = 4;
  /// True: the slave must not reverse within the segment; the segment must then have a stroke.
  bool monotone = false;
  /// Condition at an end of a run, if the run begins or ends with this segment; for any other
  /// segment, it must be as_given.
  EndJerk end_jerk = EndJerk::as_given;
};

/// A cam in which some segments may take any shape.
///
///     CamShapeProblem problem{.cam = cam, .shapes = {{.segment = 1}}};
///     problem.minimize = {{{PeakOf{derivative_of_shape(3)}}}};
///     CamShapeOutcome outcome = optimize_cam_shapes(problem);
///     if (outcome.usable()) Cam better = design(outcome.best).cam;
///
/// **Runs.** Successive free segments form one *run*, even across the end of the period of a
/// periodic cam. A run is one function, equally smooth at its inner knots and between them. Runs
/// are optimized one after another. A figure is computed for each run separately.
///
/// **Knots.** At both ends of a run, slave, geo_velocity and geo_acceleration stay as in the given
/// cam. With EndJerk::as_given, geo_jerk stays as well, under these conditions: geo_jerk of the
/// given cam does not step there, geo_acceleration is not free, and the continuity is at least 3.
/// `active` has "kept/geo_jerk" for each end whose geo_jerk is fixed. The values in `knots` are
/// free within their bounds, which may be infinite. The knots with free values may lie inside a
/// run, or be the start or the end of a cam that is not periodic. Master positions are never free.
/// All other parts of the cam stay exactly as they are.
///
/// **Order.** Each entry of `minimize` is a weighted sum of figures. If it has several entries,
/// each entry must be a single figure. The entries are minimized one after another, and no earlier
/// figure may become worse by more than `concession` (relative).
///
/// **Units.** The independent variable x is the master, so quantities are linear functions of the
/// derivatives with respect to the master.
struct CamShapeProblem {
  CamSpec cam = {};                    ///< the given cam
  std::vector<FreeShape> shapes = {};  ///< free segments, in ascending order; at least one
  std::vector<FreeKnot> knots = {};    ///< free values at knots, without masters
  Limits limits = {};                  ///< limits of the derivatives with respect to the master
  /// Corridors over the master; only their parts inside runs have an effect.
  std::vector<Corridor> corridors = {};
  std::vector<Ceiling> ceilings = {};  ///< greatest values of figures, for each run
  /// Objectives, the most important first; see Order.
  std::vector<std::vector<WeightedFigure>> minimize = {};
  bool refine = false;           ///< true: add knots (see ShapeProblem)
  OptimizeOptions options = {};  ///< options for each run; budget.seconds is for all runs together
  double concession = 1e-3;      ///< permitted relative loss of earlier objectives; see Order
};

/// Throws InputError (keys like "segment[2].free.shape") unless the problem is complete and
/// consistent: a valid cam, an objective, existing segments, the same continuity in all free
/// segments, free knots that belong to a run, corridors that meet a run, and `concession` between 0
/// and 1.
void require_valid(const CamShapeProblem& problem);

/// Result of one run.
struct CamRunOutcome {
  std::vector<std::size_t> segments =
      {};  ///< indices of the segments of the run, in the order of the
           ///< master
  /// The result for the last entry of `minimize`. Its figures are the figures of all entries,
  /// followed by the figures of the ceilings.
  ShapeOutcome shape = {};
};

/// Result of optimize_cam_shapes(). In the cam `best`, segments with the law `hermite` replace the
/// free segments. Status and reason come from the worst run. Figures, active constraints and counts
/// come from all runs, one after another. `limits` is check(best, limits), with segments counted
/// from 0 as in the spec.
struct CamShapeOutcome : Outcome<CamSpec> {
  std::vector<CamRunOutcome> runs = {};  ///< result of each run
};

/// Optimizes the shapes. `keep_going`: see optimize(). Throws InputError like require_valid().
CamShapeOutcome optimize_cam_shapes(const CamShapeProblem& problem,
                                    const KeepGoing& keep_going = {});

}  // namespace jounce
