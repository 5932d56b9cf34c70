// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// The motion to which a setpoint belongs, as supervise() needs it. u is the unit of the axis.
struct SupervisedMotion {
  MotionState last = {};         ///< the previous setpoint
  double dt = 0;                 ///< time since the previous setpoint, s
  std::int64_t skipped = 0;      ///< number of ticks that were skipped between both setpoints
  Peaks path = {};               ///< on a path: its greatest magnitudes at rate 1
  bool open_ended = false;       ///< on a path: later rows were not checked yet
  bool joined = false;           ///< one motion continues another between both setpoints
  bool bounded = false;          ///< the whole motion was checked against the position range
  bool in_step = false;          ///< a live master alone determines the acceleration
  bool stops_in_fault = false;   ///< the motion stops on its path because of a fault
  bool searches = false;         ///< a homing, which may stand on a limit switch
  bool positive_switch = false;  ///< the positive limit switch is active
  bool negative_switch = false;  ///< the negative limit switch is active
};

/// Checks a setpoint before its output. Returns none if it may be output, or the fault. `rules` has
/// the limits in effect: during a homing, it has no position range.
///
///     if (const Cause wrong = supervise(next, motion, rules); wrong != Cause::none)
///       fail(wrong, excess(wrong, next, motion, rules));
///
/// Always true for a setpoint that passes: the axis reached it within its stop limits, and it can
/// still stop inside its position range by the gentlest stop that was possible before.
Cause supervise(const MotionState& next, const SupervisedMotion& motion,
                const AxisConfig& rules) noexcept;

/// Returns the number with which the setpoint exceeds a limit, for Tick::fault_value: the speed
/// (u/s) for overspeed, the acceleration (u/s^2) for overacceleration and jump; otherwise NaN.
double excess(Cause wrong, const MotionState& next, const SupervisedMotion& motion,
              const AxisConfig& rules) noexcept;

/// Returns the velocity step that a joint of two motions may have, u/s.
double joint_step(const AxisConfig& config) noexcept;

}  // namespace jounce
