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

/// Predicted residual vibration of a mode at the end of the motion, in the unit of the position. A
/// spec has one for each mode that an operator of [[then]] or [polydyne] suppresses.
struct Residual {
  Mode mode = {};     ///< the mode, frequency in Hz
  double before = 0;  ///< vibration of the motion without operators and [polydyne]
  double after = 0;   ///< vibration of the finished motion
};

/// The result of a spec for one axis: the exact curve, and the table for a controller with the
/// error of the table.
struct Made {
  AxisPart part = {};  ///< the axis
  LazyCurve curve;     ///< the exact curve
  /// Name of each segment of the curve, for reports; empty: segments have numbers from 1.
  std::vector<std::string> segments = {};
  Sampled sampled;                       ///< the table and its error
  std::vector<Residual> residuals = {};  ///< one for each mode of an operator or of [polydyne]
  std::vector<SyncZone> zones = {};      ///< sync zones of the slave, if its generator reports them
  std::shared_ptr<const Plan> plan = {};  ///< for kind "path": the plan, shared by its axes
  /// For kind "path" with overlapping lines: their motion, instead of a plan.
  std::shared_ptr<const Overlapped> overlap = {};
  /// Error of the curve, from operators of a cam with a tolerance; the error of the table includes
  /// it.
  double fit = 0;
};

/// Makes the motions of a spec: first the generator, then the operators, then the table. Returns
/// one result for each axis; the axes of a motion over time have the same start and end. Throws
/// InputError, with the place in the document.
std::vector<Made> make_axes(const Spec& spec);

/// Makes the motion of a spec of one axis. Throws InputError if the spec has several axes.
Made make(const Spec& spec);

/// Returns warnings of a valid spec. For a table over time (kinds "pt" and "pvt", without
/// operators): steps of the velocity, oscillation and overshoot. For a polydyne cam: steps of its
/// acceleration. Empty for all other specs.
Report table_warnings(const Spec& spec);

/// Returns the motion of a cam's master over time in *seconds*. It begins at the start of the cam.
/// If the spec has no [master], throws InputError with the section to add. Also throws for a
/// distance outside 1e-9 to 1e4 times the length of the cam, and for a distance that the master
/// travels in less than 1 us.
Trajectory make_master(const Spec& spec);

/// Returns the length of the spec's unit of time, s.
double seconds_per_unit(const Spec& spec);

/// Returns [limits.slave] converted to limits per master unit, for a master at full speed. Throws
/// InputError (`limits.slave.velocity`, ...) if the spec has such a limit but no [master].
Limits slave_limits_by_master(const Spec& spec);

/// Returns `limits`, which count per master unit, together with slave_limits_by_master(): the lower
/// one of two limits of the same derivative.
Limits with_slave_limits(Limits limits, const Spec& spec);

/// Returns the error of a spec in which nothing is free: what to add, or that this kind has no
/// motion.
InputError nothing_free(const Spec& spec);

/// Returns the optimization problem of a cam spec, with [limits], and with [limits.slave] at full
/// speed. Throws InputError, with the place in the document, unless the problem is valid.
CamProblem make_problem(const Spec& spec);

/// Returns the problem of a spec with free shapes (spec.optimize.shape). Throws InputError for a
/// figure of a drive, which needs the drive, unless
/// `against_a_drive` is true: then the caller adds the drive.
CamShapeProblem make_shape_problem(const Spec& spec, bool against_a_drive = false);

}  // namespace jounce
