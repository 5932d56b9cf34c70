// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/command/cause.hpp"

namespace jounce {

/// The two windows of an axis around its setpoint: one for the following error (Googol
/// GT_SetPosErr, Agito MaxPosErr, HMPL GetPosErr), one for the state *in position* (Googol
/// GT_SetAxisBand, Agito InTargetTol). Call too_far() and settled() once a tick. `error` is the
/// following error, u (the unit of the axis). A drive without position feedback (error NaN) causes
/// no fault and is never in position. `dt` is the time since the previous step, s.
///
///     Supervision windows;
///     const bool lost = windows.too_far(set - actual, dt, config);
///     const bool there = windows.settled(set - actual, at_rest, dt, config);
class Supervision {
 public:
  /// True if |error| exceeds AxisConfig::following_error, and has exceeded it for following_time.
  bool too_far(double error, double dt, const AxisConfig& config) noexcept;
  /// True if the axis is at rest and |error| has been within AxisConfig::in_position for
  /// in_position_time. One tick outside the window, or in motion, starts the time again.
  bool settled(double error, bool at_rest, double dt, const AxisConfig& config) noexcept;
  /// Restarts the times of the two windows.
  void reset() noexcept { *this = {}; }

 private:
  double outside_ = 0;  // time outside the window of the following error, s
  double inside_ = 0;   // time inside the window of in position, s
};

/// Returns the greatest valid position of an axis, u: its travel in 2^40 ticks at its velocity
/// limit. At greater positions, rounding could lose the travel of one tick.
double furthest(const AxisConfig& config) noexcept;

/// Returns the inputs with impossible numbers replaced by NaN. The NaN means that the master is
/// lost, or that the drive has failed.
Inputs sound(const Inputs& inputs, const AxisConfig& config) noexcept;

/// Returns the fault that the drive or the watchdog reports for an enabled axis, or none.
Cause check_inputs(const Inputs& inputs) noexcept;

/// Reaction of the axis to a fault.
enum class Reaction : std::uint8_t {
  freeze,        ///< stops at once: the setpoint keeps its present position
  brake,         ///< brakes by a planned move from the last good setpoint
  stop_on_path,  ///< stops on the path; without a path, brakes
  power_off,     ///< stops at once and disables the drive
};
/// Returns the reaction of the axis to a fault.
Reaction reaction_to(Cause fault) noexcept;

}  // namespace jounce
