// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// From `time` on the motion shall run at `factor` times its planned speed. 0 is a feed hold.
struct FactorRequest {
  double time = 0;    ///< s, on the axis of the motion as it is played
  double factor = 1;  ///< 0 <= factor <= OverrideSpec::maximum
};

/// Speed of a planned motion.
struct OverrideSpec {
  std::vector<FactorRequest> requests = {};  ///< times ascend
  double factor = 1;   ///< initial factor; the plan begins at rest unless this is 1
  double maximum = 1;  ///< the largest permitted factor: 1.2 is 120 %
};

/// Outcome of one request.
struct FactorRamp {
  double begin = 0;     ///< s, when the factor begins to change: not before the request
  double end = 0;       ///< s, when it is reached
  double factor = 1;    ///< reached factor; less than requested if the limits do not allow more
  bool granted = true;  ///< false: the motion is over before a ramp that holds the limits ends
};

/// A motion as it was played.
struct Overridden {
  Trajectory clock;               ///< path time over time; its velocity is the factor
  std::vector<Trajectory> axes;   ///< each axis along the clock, exactly: composed(axis, clock)
  std::vector<FactorRamp> ramps;  ///< one for each request
  bool arrived = true;            ///< false: a feed hold without an end; the axes stand still
};

/// Plays a planned motion with a speed override (HIMC HMPL manual 5.3.37, 8.3.28: SetVelScale;
/// Halt and Resume 5.2.10, 5.2.11; PLCopen MC_SetOverride): all axes along one clock, so that
/// no axis leaves the path, and exactly continued after a hold.
///
///     const std::vector axes{s_curve({.to = 50, .velocity = 10, .acceleration = 20,
///                                     .jerk = 100}).curve()};
///     const std::vector<Limits> limits{{.velocity = 10, .acceleration = 20, .jerk = 100}};
///     const Overridden held = overridden(axes, limits, {{{2, 0}, {4, 1}}});  // hold, resume
///     const Motion now = held.axes[0].at(3);  // at rest, on the path
///
/// **Ramps.** The factor changes by a ramp of limited first and second derivative. Of eight shapes
/// (gentle to sharp at either end), each as steep as every axis keeps its limits all through the
/// ramp (by the exact `check`; to 0.3 %), the one that ends first is taken. Where none holds at
/// once (a plan that brakes at its limit cannot brake harder) the ramp begins later: at a break of
/// the plan or a quarter between. In a cruise a hold is as fast as the axis can stop. While the
/// plan accelerates or brakes it takes up to about three times as long (measured over four plans;
/// 1.0 to 1.5 times on average), or the motion ends first. The search takes about a millisecond a
/// request: it belongs into planning, not into the control cycle.
///
/// **Guaranteed.** Velocity, acceleration and jerk limits hold at every instant if they hold for
/// the plan, for all requests: a change that would break them comes later, or not at all
/// (`granted`); a hold that would end after the motion itself gives way to it. A factor above 1 is
/// reduced to the margin of the rest of the plan. Steps of the plan's acceleration (a
/// trapezoid's) stay steps and count as no jerk.
///
/// A request replaces a ramp that has begun, from its present state. The curves end with the path,
/// or, if its end is not reached, with the last ramp; they hold there.
///
/// Throws InputError if there are not as many limits as axes, an axis lacks a velocity,
/// acceleration or jerk limit, if the plan breaks one (with limit, place and amount) or breaks it
/// at the first factor, for a factor out of range, times that do not ascend or lie before the
/// start, axes with different intervals or that all stand still, a first factor of 0 without an
/// end, and like `composed` (a plan of degree 4 or more does not fit the ramp of a clock, degree
/// 3).
Overridden overridden(std::span<const Trajectory> axes, std::span<const Limits> limits,
                      const OverrideSpec& spec);

}  // namespace jounce
