// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/cause.hpp"
#include "jounce/axis/inputs.hpp"

namespace jounce {

/// The windows of an axis around its setpoint: the following error's (Googol GT_SetPosErr, Agito
/// MaxPosErr, HMPL GetPosErr) and that of the position reached (GT_SetAxisBand, InTargetTol). A
/// step each tick; a drive without position feedback causes no fault and is in no window.
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

/// The furthest position that an axis can count to, u: its way in 2^40 ticks at its velocity. Beyond
/// that the way of one tick would be lost in rounding.
double furthest(const AxisConfig& config) noexcept;

/// The inputs without numbers that none can be: of a master, so that it is lost; of a drive, so that
/// it has failed.
Inputs sound(const Inputs& inputs, const AxisConfig& config) noexcept;

/// The fault that drive and watchdog report for an enabled axis, or none.
Cause check_inputs(const Inputs& inputs) noexcept;

/// Reaction of the axis to a fault.
enum class Reaction : std::uint8_t {
  freeze,        ///< the setpoint stays where it is, at once
  brake,         ///< a stop by a move of its own from the last good setpoint
  stop_on_path,  ///< a stop on the path where there is one, else as brake
  power_off,     ///< freezes the setpoint and disables the drive
};
Reaction reaction_to(Cause fault) noexcept;

}  // namespace jounce
