// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// A request for a speed factor: from `time` on, the axes move at `factor` times the planned speed.
/// Factor 0 holds the motion (feed hold).
struct FactorRequest {
  double time = 0;    ///< s, on the time axis of the overridden motion
  double factor = 1;  ///< 0 <= factor <= OverrideSpec::maximum
};

/// Speed factors of a planned motion.
struct OverrideSpec {
  std::vector<FactorRequest> requests = {};  ///< in ascending order of time
  /// Factor at the start; use 1 if the plan begins in motion, because any other factor steps the
  /// velocity.
  double factor = 1;
  double maximum = 1;  ///< the largest permitted factor: 1.2 is 120 %
};

/// Outcome of one request.
struct FactorRamp {
  double begin = 0;  ///< s, when the factor begins to change; not before the request
  double end = 0;    ///< s, when the factor is reached
  /// The factor that is reached: the requested one, or a lower one if the limits do not permit it.
  double factor = 1;
  /// False: not executed, because the motion ends before a ramp within the limits would end.
  bool granted = true;
};

/// A motion with its overrides applied.
struct Overridden {
  Trajectory clock;  ///< path time (s) over time (s); its velocity is the factor
  std::vector<Trajectory> axes =
      {};  ///< position of each axis over time: composed(axis, clock), exact
  std::vector<FactorRamp> ramps = {};  ///< one for each request, in their order
  /// False: the last factor is 0, so the axes stand still before the end of the path.
  bool arrived = true;
};

/// Returns a planned motion with a speed override. Sources: PLCopen MC_SetOverride; HIMC HMPL
/// manual, SetVelScale (5.3.37, 8.3.28), Halt and Resume (5.2.10, 5.2.11). All axes follow one
/// clock, so no axis leaves the path, and after a hold the motion continues exactly on it.
///
///     const std::vector axes{s_curve({.to = 50, .velocity = 10, .acceleration = 20,
///                                     .jerk = 100}).curve()};
///     const std::vector<Limits> limits{{.velocity = 10, .acceleration = 20, .jerk = 100}};
///     const Overridden held = overridden(axes, limits, {{{2, 0}, {4, 1}}});  // hold, resume
///     const Motion now = held.axes[0].at(3);  // at rest, on the path
///
/// **Ramps.** The factor changes along a ramp whose first and second derivatives are limited. The
/// function tries eight ramp shapes, from gentle to sharp at either end. It makes each shape as
/// steep as the limits of every axis permit over the whole ramp (by the exact check(), to 0.3 %),
/// and takes the ramp that ends first. If no shape is possible at once, the ramp begins later: at a
/// break of the plan, or at a quarter of the stretch between two breaks. For example, a plan that
/// brakes at its limit cannot brake harder.
///
/// **Duration.** In a cruise, a hold is as fast as the axis can stop. While the plan accelerates or
/// brakes, a hold takes up to about three times as long as a stop (measured over four plans; on
/// average 1.0 to 1.5 times), unless the motion ends first. The search takes about a millisecond
/// for each request: call this function during planning, not in the control cycle.
///
/// **Guarantees.** If the plan stays within the limits of velocity, acceleration and jerk, so does
/// the result, at every instant and for all requests. A change that would break a limit begins
/// later, or is not executed (`granted` is false). A hold that would end after the motion is not
/// executed. A factor above 1 is reduced to the value that the rest of the plan permits. Steps of
/// the plan's acceleration (as in a trapezoid) remain steps and do not count as jerk.
///
/// A request replaces a ramp in progress and continues from its present state. The curves end at
/// the end of the path or, if the motion does not reach the end, with the last ramp. Outside, they
/// hold.
///
/// Throws InputError if
/// - the number of limits differs from the number of axes, or an axis has no limit of velocity,
///   acceleration or jerk;
/// - the plan itself, or the plan at the first factor, breaks a limit (the error has the limit, the
///   place and the amount);
/// - a factor is out of range, the times descend (equal times are permitted), or the first one is
///   before the start;
/// - there is no axis, the axes have different intervals, or none of them moves;
/// - the first factor is 0 and no request starts the motion;
/// - composed() throws: a plan of degree 4 or more does not fit the ramp of a clock (degree 3).
Overridden overridden(std::span<const Trajectory> axes, std::span<const Limits> limits,
                      const OverrideSpec& spec);

}  // namespace jounce
