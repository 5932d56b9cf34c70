// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/dynamics.hpp"
#include "jounce/profiles/vibration/notch.hpp"
#include "jounce/profiles/vibration/shaper.hpp"

namespace jounce::himc {

/// The axis profile of a HIWIN HIMC controller, in HMPL's words: velocity, acceleration or the time
/// it takes, and a smoothing time. HMPL manual 5.1, 5.3.1 to 5.3.16, 5.3.37.
///
///     const himc::AxisProfile axis{.velocity = 100, .acceleration = 500, .smoothing_time = 50};
///     const Profile move = himc::move_abs(0, 1000, axis);       // ramps of 250 ms, jerk 10000
///     const Trajectory running = move.curve();
///     const Trajectory changed = himc::move_abs(running, 3, 500, axis);   // SetVel, MoveAbs in flight
///
/// **Law** (5.1): jerk = acceleration / Ts; an acceleration phase lasts T = Ta + Ts, where Ta is
/// the time of the trapezoid; Ts = 0 gives the trapezoid. A ramp too short to reach the
/// acceleration keeps that jerk.
///
/// **Units** as in HMPL: mm or deg, and ms for the times set here; results run over s.
struct AxisProfile {
  double velocity = 0;           ///< SetVel: mm/s, > 0
  double acceleration = 0;       ///< SetAcc: mm/s^2, > 0; or else
  double acceleration_time = 0;  ///< SetAccTime: ms, > 0, from rest to `velocity` before smoothing
  double deceleration = 0;       ///< SetDec: mm/s^2; with neither: as acceleration
  double deceleration_time = 0;  ///< SetDecTime: ms
  double smoothing_time = 0;     ///< SetSMTime: Ts, ms, 0 to 500
  double velocity_scale = 100;   ///< SetVelScale: %, > 0 to 100, of the velocity alone
};

/// The same in common terms. Throws InputError for a value out of range, an acceleration given
/// twice or not at all.
Dynamics dynamics(const AxisProfile& axis);

/// MoveAbs from standstill (5.2.4); MoveRel (5.2.5) is move_abs(from, from + distance, axis).
Profile move_abs(double from, double to, const AxisProfile& axis);

/// MoveAbs, or a new velocity, acceleration or target, while moving (5.1: "the generator replans"):
/// effective at t. The smoothing time of `axis` applies; HMPL does not permit a change of it in
/// motion.
Trajectory move_abs(const Trajectory& running, double t, double to, const AxisProfile& axis);

/// MoveVel (5.2.6): accelerates to the axis velocity in the given direction (1 or -1) and keeps it.
Profile move_vel(const MotionState& from, int direction, const AxisProfile& axis);
Trajectory move_vel(const Trajectory& running, double t, int direction, const AxisProfile& axis);

/// Stop and Halt (5.2.9, 5.2.10): to rest, with the axis deceleration.
Trajectory stop(const Trajectory& running, double t, const AxisProfile& axis);

/// Whose filter it is: an axis's or a group's.
enum class FilterOf { axis, group };

/// Range of SetAxisInShape and SetGrpInShape (15.1): NORMAL (zv) or ROBUST (zvd); an axis 1.5 to 300 Hz,
/// a group 3 to 300 Hz; damping 0 to 0.3. Throws InputError with the controller's error.
void require_in_shape(const ShaperSpec& shaper, FilterOf of);

/// Range of SetAxisVsf (15.1): 0.1 to 200 Hz, damping 0.7 to 1.5. Throws InputError likewise.
void require_vsf(const NotchSpec& notch);

}  // namespace jounce::himc
