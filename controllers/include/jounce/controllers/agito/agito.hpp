// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/profiles/moves/dynamics.hpp"

/// The point-to-point motions of an Agito controller, in the keywords of its manual (Agito PCSuite
/// IDE manual, 4.1, 4.6, 4.10, 4.11, 5.3). Units: user units and s, except where ms is stated.
///
///     using namespace jounce::agito;
///     const Settings axis{.accel = 100000, .decel = 100000, .speed = 1000};
///     const Profile move = begin(0, {.abs_trgt = 2000}, axis);                    // 2.01 s
///     const Trajectory there_and_back = repetitive(0, {.abs_trgt = 2000}, axis, 6, 500);
///
/// **Jerk** is an exponent, not a jerk. The acceleration rises in the time 2^Jerk / 16384 s, so the
/// jerk is Accel (or Decel) divided by this time. Jerk = 0 means no jerk limit: a trapezoid.
///
/// **Errors**: the functions throw InputError for a value out of the range that the manual gives.
namespace jounce::agito {

inline constexpr double sample_time = 1.0 / 16384;  ///< sampling period of the controller, s

/// Settings of an axis.
struct Settings {
  double accel = 0;       ///< Accel, user units/s^2, 100 to 2e9
  double decel = 100000;  ///< Decel, user units/s^2, 100 to 2e9
  /// Speed, user units/s, -6e7 to 6e7. The sign is the direction of a jog; other motions ignore it.
  double speed = 0;
  int jerk = 0;  ///< Jerk, 0 to 9: exponent, see above
};

/// Target of a motion. If rel_trgt is not 0, it is used in place of abs_trgt.
struct Target {
  std::int32_t abs_trgt = 0;  ///< AbsTrgt, user units
  std::int32_t rel_trgt = 0;  ///< RelTrgt, user units from the present position
};

/// Returns the time in which the acceleration rises, s: 2^jerk / 16384; 0 for the exponent 0.
double jerk_time(int jerk);

/// Returns the target position of a Begin at `position`, user units.
double resolved(const Target& target, double position);

/// Returns the settings as Dynamics. Throws InputError for a speed of 0.
Dynamics dynamics(const Settings& settings);

/// Begin in MotionMode 1 (PTP), from standstill at `position`.
Profile begin(double position, const Target& target, const Settings& settings);

/// Changes the target, speed, acceleration or deceleration of a running motion at the time t, s.
/// RelTrgt counts from the position at t. The controller cannot change Jerk in motion: pass the
/// present value.
Trajectory begin(const Trajectory& running, double t, const Target& target,
                 const Settings& settings);

/// Begin in MotionMode 0 (jog): moves at Speed, in the direction of its sign, without end.
Profile jog(const MotionState& from, const Settings& settings);

/// Stop at the time t, s: comes to rest with Decel. Speed is not used. If the axis has an
/// acceleration at t, the acceleration first falls with the jerk of Accel (of Decel if Accel is 0).
Trajectory stop(const Trajectory& running, double t, const Settings& settings);

/// MotionMode 2 (repetitive PTP) between `position` and the target. `strokes` >= 1: number of
/// moves. `rpt_wait`: RptWait, standstill between two moves, ms, >= 0.
Trajectory repetitive(double position, const Target& target, const Settings& settings, int strokes,
                      double rpt_wait = 0);

/// Returns the settings with which a repetitive PTP over 2 * amplitude approximates a sine (manual
/// 4.10). For the amplitude A (user units) and the `frequency` F (Hz), they are Accel = Decel = 32
/// A F^2 and Speed = 8 A F. Two moves without a wait take 1 / F. The velocity is a triangle whose
/// peak is Speed.
Settings quasi_sine(double amplitude, double frequency);

/// A change of speed at a position.
struct SpeedChange {
  double position = 0;   ///< SpeedChgPos: position of the change, user units
  double new_speed = 0;  ///< SpeedChgNew: new speed, user units/s, -6e7 to 6e7, not 0
  /// SpeedChgDir: direction of the crossing: upwards (1), downwards (-1), or either (0).
  int direction = 0;
};

/// Returns the motion with a change of the speed when it first crosses the position in the given
/// direction. Without such a crossing, returns the motion unchanged. `target` is the target of the
/// motion, user units.
Trajectory with_speed_change(const Trajectory& running, double target, const Settings& settings,
                             const SpeedChange& change);

}  // namespace jounce::agito
