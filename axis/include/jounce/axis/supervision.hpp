// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/command/cause.hpp"

namespace jounce {

/// The windows of an axis around its setpoint: following error (Googol GT_SetPosErr, Agito
/// MaxPosErr, HMPL GetPosErr) and in position (GT_SetAxisBand, InTargetTol). Call it once a tick. A
/// drive without position feedback causes no fault and is in no window.
///
///     Supervision windows;
///     const bool lost = windows.too_far(set - actual, dt, config);
///     const bool there = windows.settled(set - actual, at_rest, dt, config);
class Supervision {
 public:
  /// True if |error| has been above `following_error` for more than `following_time`.
  bool too_far(double error, double dt, const AxisConfig& config) noexcept;
  /// True if the axis is at rest and |error| has been within `in_position` for `in_position_time`;
  /// cleared at once on violation or motion.
  bool settled(double error, bool at_rest, double dt, const AxisConfig& config) noexcept;
  void reset() noexcept { *this = {}; }

 private:
  double outside_ = 0;  // s
  double inside_ = 0;   // s
};

/// The furthest valid position of an axis, u: its travel in 2^40 ticks at its velocity. Beyond it,
/// rounding would lose the travel of one tick.
double furthest(const AxisConfig& config) noexcept;

/// Returns the inputs with impossible numbers marked: a master is then lost, a drive has failed.
Inputs sound(const Inputs& inputs, const AxisConfig& config) noexcept;

/// The fault that drive and watchdog report for an enabled axis, or none.
Cause check_inputs(const Inputs& inputs) noexcept;

/// Reaction of the axis to a fault.
enum class Reaction : std::uint8_t {
  freeze,        ///< the setpoint keeps its present value, at once
  brake,         ///< the axis brakes by a move of its own from the last good setpoint
  stop_on_path,  ///< stops on the path if there is one, otherwise like brake
  power_off,     ///< freezes the setpoint and disables the drive
};
Reaction reaction_to(Cause fault) noexcept;

}  // namespace jounce
