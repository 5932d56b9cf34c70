// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "jounce/path/overlap.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/profiles/vibration/vibration.hpp"
#include "jounce/pvt/lazy_curve.hpp"
#include "jounce/pvt/sample.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// Residual vibration of a mode at the end of the motion: predicted for each mode that an operator
/// of the spec was made for, in the unit of the position.
struct Residual {
  Mode mode;          ///< Hz
  double before = 0;  ///< before: of the motion without its operators
  double after = 0;   ///< after: of the finished motion
};

/// Result of a spec for one axis: the exact curve, the table for a controller, and their greatest
/// difference.
struct Made {
  AxisPart part;  ///< the axis of this result
  LazyCurve curve;
  std::vector<std::string>
      segments;  ///< a name for each segment of the curve, for reports; none: 1, 2, ...
  Sampled sampled;
  std::vector<Residual> residuals = {};
  std::vector<SyncZone> zones =
      {};  ///< in which the slave is in sync, if its generator reports them
  std::shared_ptr<const Plan> plan = {};  ///< plan of a spec of kind "path", shared by its axes
  std::shared_ptr<const Overlapped> overlap = {};  ///< instead of a plan: lines that overlap
};

/// Spec -> generator -> operators -> curve -> table; one per axis, all over the same time. Throws
/// InputError, placed in the spec's document.
std::vector<Made> make_axes(const Spec& spec);

/// The same for one axis; several are an InputError.
Made make(const Spec& spec);

/// Warnings for a valid time table (kinds "pt" and "pvt", before any operator): steps, swings and
/// overshoot; for a polydyne cam: steps of its acceleration. Empty for all others.
Report table_warnings(const Spec& spec);

/// The master's motion of a cam spec over time in *seconds*. Throws InputError, which names the
/// section to add, if there is no [master].
Trajectory make_master(const Spec& spec);

/// Length of the time unit of the spec, s.
double seconds_per_unit(const Spec& spec);

/// [limits.slave] as limits by master, which runs at full speed. Throws InputError
/// (`limits.slave.velocity`, ...) if there is such a limit, but no [master].
Limits slave_limits_by_master(const Spec& spec);

/// The optimization problem of a cam spec, under [limits] and [limits.slave] at full speed. Throws
/// InputError, placed in the document, unless it is well posed.
CamProblem make_problem(const Spec& spec);

/// The same for a spec with free shapes: spec.optimize.shape. Figures of a drive have no function
/// yet (jounce/spec/drive_figures.hpp): they throw unless `against_a_drive`.
CamShapeProblem make_shape_problem(const Spec& spec, bool against_a_drive = false);

}  // namespace jounce
