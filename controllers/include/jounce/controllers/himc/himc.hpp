// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/dynamics.hpp"
#include "jounce/profiles/vibration/notch.hpp"
#include "jounce/profiles/vibration/shaper.hpp"

namespace jounce::himc {

/// The profile of an axis of a HIWIN HIMC controller, with the names of HMPL, the controller's
/// language (HMPL manual 5.1, 5.3.1 to 5.3.16, 5.3.37). The profile consists of a velocity, an
/// acceleration (or the time that it takes), and a smoothing time.
///
///     const himc::AxisProfile axis{.velocity = 100, .acceleration = 500, .smoothing_time = 50};
///     const Profile move = himc::move_abs(0, 1000, axis);       // ramps of 250 ms, jerk 10000
///     const Trajectory running = move.curve();
///     const Trajectory changed = himc::move_abs(running, 3, 500, axis);   // SetVel, MoveAbs in flight
///
/// **Law** (manual 5.1): jerk = acceleration / Ts, where Ts is the smoothing time. An acceleration
/// phase takes Ta + Ts, where Ta is the time of the phase without smoothing. With Ts = 0, the
/// profile is a trapezoid. A ramp that is too short to reach the acceleration has the same jerk.
///
/// **Units** are the units of HMPL: mm or deg for positions, ms for the times of this struct. The
/// time of the resulting motions is in s.
struct AxisProfile {
  double velocity = 0;      ///< SetVel: velocity, mm/s, > 0
  double acceleration = 0;  ///< SetAcc: acceleration, mm/s^2, > 0; only without acceleration_time
  /// SetAccTime: time from rest to `velocity` without smoothing, ms, > 0.
  double acceleration_time = 0;
  /// SetDec: deceleration, mm/s^2; default: acceleration.
  double deceleration = 0;
  double deceleration_time = 0;  ///< SetDecTime: time of the deceleration, ms; only without
                                 ///< `deceleration`
  double smoothing_time = 0;     ///< SetSMTime: smoothing time Ts, ms, 0 to 500
  double velocity_scale = 100;   ///< SetVelScale: factor on the velocity only, %, above 0 up to 100
};

/// Returns the profile as Dynamics. Throws InputError for a value out of range, and unless exactly
/// one of acceleration and acceleration_time is given.
Dynamics dynamics(const AxisProfile& axis);

/// MoveAbs from standstill (manual 5.2.4). MoveRel (5.2.5) is move_abs(from, from + distance,
/// axis).
Profile move_abs(double from, double to, const AxisProfile& axis);

/// MoveAbs in motion, or a new velocity, acceleration or target, at the time t, s (manual 5.1: "the
/// generator replans"). HMPL does not permit a change of the smoothing time in motion: pass the
/// present one in `axis`.
Trajectory move_abs(const Trajectory& running, double t, double to, const AxisProfile& axis);

/// MoveVel (manual 5.2.6): accelerates to the velocity of `axis` in the direction 1 or -1, and
/// keeps this velocity.
Profile move_vel(const MotionState& from, int direction, const AxisProfile& axis);
/// MoveVel in motion, at the time t, s.
Trajectory move_vel(const Trajectory& running, double t, int direction, const AxisProfile& axis);

/// Stop and Halt (manual 5.2.9, 5.2.10) at the time t, s: come to rest with the deceleration of the
/// axis.
Trajectory stop(const Trajectory& running, double t, const AxisProfile& axis);

/// Owner of a filter: a single axis, or a group of axes.
enum class FilterOf { axis, group };

/// Checks an input shaper against the ranges of SetAxisInShape and SetGrpInShape (manual 15.1): the
/// type NORMAL (zv) or ROBUST (zvd); 1.5 to 300 Hz for an axis, 3 to 300 Hz for a group; damping
/// ratio 0 to 0.3. Throws InputError with the error of the controller.
void require_in_shape(const ShaperSpec& shaper, FilterOf of);

/// Checks a filter against the ranges of SetAxisVsf (manual 15.1): 0.1 to 200 Hz, damping ratio 0.7
/// to 1.5. Throws InputError with the error of the controller.
void require_vsf(const NotchSpec& notch);

}  // namespace jounce::himc
