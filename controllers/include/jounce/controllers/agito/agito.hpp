// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/profiles/moves/dynamics.hpp"

/// The point-to-point motions of an Agito controller, in its keywords. In user units and s; a time in
/// ms is marked. Agito PCSuite IDE manual 5.3, 4.1, 4.6, 4.10, 4.11.
///
///     using namespace jounce::agito;
///     const Settings axis{.accel = 100000, .decel = 100000, .speed = 1000};
///     const Profile move = begin(0, {.abs_trgt = 2000}, axis);                    // 2.01 s
///     const Trajectory there_and_back = repetitive(0, {.abs_trgt = 2000}, axis, 6, 500);
///
/// **Jerk** is an exponent: the acceleration builds up in 2^Jerk / 16384 s, so jerk = Accel (Decel)
/// over that time; 0 means none, a trapezoid.
///
/// **Throws** InputError for a value out of the manual's range.
namespace jounce::agito {

inline constexpr double sample_time = 1.0 / 16384;  ///< s

struct Settings {
  double accel = 0;       ///< Accel: user units/s^2, 100 to 2e9
  double decel = 100000;  ///< Decel: the same range
  double speed = 0;       ///< Speed: user units/s, +-6e7; its sign is the direction of a jog only
  int jerk = 0;           ///< Jerk: 0 to 9
};

/// AbsTrgt and RelTrgt: int32; a RelTrgt other than 0 overrides AbsTrgt.
struct Target {
  std::int32_t abs_trgt = 0;
  std::int32_t rel_trgt = 0;
};

/// The time in which the acceleration builds up: 2^jerk samples, s; 0 for exponent 0.
double jerk_time(int jerk);

/// The target of a Begin at `position`.
double resolved(const Target& target, double position);

/// The same in common terms. A speed of 0 is refused: nothing would move.
Dynamics dynamics(const Settings& settings);

/// Begin in MotionMode 1 (PTP), from standstill.
Profile begin(double position, const Target& target, const Settings& settings);

/// A target, speed, acceleration or deceleration written while moving: effective at t. The base of
/// RelTrgt is the position at t. Jerk is not writable while moving: give the running one.
Trajectory begin(const Trajectory& running, double t, const Target& target,
                 const Settings& settings);

/// Begin in MotionMode 0 (jog): to Speed, with its sign, and on.
Profile jog(const MotionState& from, const Settings& settings);

/// Stop: to rest with Decel. Speed is not used; a present acceleration falls with the jerk of
/// Accel, or of Decel if that is 0.
Trajectory stop(const Trajectory& running, double t, const Settings& settings);

/// MotionMode 2 (repetitive PTP): `strokes` >= 1 of them, between the start and the target, with
/// RptWait ms >= 0 of standstill between two.
Trajectory repetitive(double position, const Target& target, const Settings& settings, int strokes,
                      double rpt_wait = 0);

/// The settings of 4.10 that make repetitive PTP over 2 * amplitude look like a sine of `frequency`
/// (Hz): Accel = Decel = 32 A F^2, Speed = 8 A F. Two strokes, without wait, last 1 / frequency; the
/// velocity is a triangle that just touches Speed.
Settings quasi_sine(double amplitude, double frequency);

/// SpeedChgPos, SpeedChgNew, SpeedChgDir: another speed as soon as the position is crossed.
struct SpeedChange {
  double position = 0;   ///< SpeedChgPos, user units
  double new_speed = 0;  ///< SpeedChgNew, user units/s, +-6e7
  int direction = 0;     ///< SpeedChgDir: 1 upwards, -1 downwards, 0 both
};

/// The move of `begin`, with the speed changed at its first crossing of the position in that
/// direction; unchanged if it does not cross.
Trajectory with_speed_change(const Trajectory& running, double target, const Settings& settings,
                             const SpeedChange& change);

}  // namespace jounce::agito
