// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "jounce/profiles/moves/dynamics.hpp"

/// The point-to-point, jog and on-the-fly moves of a Googol iDEABOX Pro, with the names and units
/// of its manual: pulse, pulse/ms, pulse/ms^2, pulse/ms^3, ms. The time of all motions is in ms.
///
///     using namespace jounce::googol;
///     const Profile move = trap({.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125,
///                                .smooth_time = 25});                   // 1325 ms, example 7-1
///     const Profile fly = move_absolute({.pos = 50000, .vel = 50, .acc = 1, .dec = 10,
///                                        .percent = 50});
///     const Trajectory later = move_absolute(fly.curve(), 300, {.pos = 80000, .vel = 50, .acc = 1});
///
/// **Percent** (manual 7.7.1) is 100 * 2 ta / (2 ta + te). In a ramp, ta is the time in which the
/// acceleration rises (and the time in which it falls), and te is the time at constant
/// acceleration. 0 gives a trapezoid; with 100, no part has a constant acceleration. `acc` is the
/// peak acceleration, so a change of velocity dv takes dv / (acc (1 - percent/200)).
///
/// **Errors**: the functions throw InputError for a value out of the range that the manual gives.
namespace jounce::googol {

/// Greatest |position|, pulse (manual I-144).
inline constexpr std::int64_t max_position = 1'073'741'823;

/// A trapezoidal move: GT_PrfTrap, GT_SetTrapPrm, GT_SetPos, GT_SetVel, GT_Update (manual 7.2).
struct Trap {
  double from = 0;       ///< start position, pulse
  std::int64_t pos = 0;  ///< target, pulse, up to +-1 073 741 823, not equal to `from`
  double vel = 0;        ///< velocity, pulse/ms, > 0
  double acc = 0;        ///< acceleration, pulse/ms^2, > 0
  double dec = 0;        ///< deceleration, pulse/ms^2; 0: acc
  double vel_start = 0;  ///< velStart: velocity at which the motion begins, pulse/ms, 0 to vel
  int smooth_time = 0;   ///< smoothTime: time in which the acceleration rises, ms, 0 to 50
};

/// Returns a move from standstill. The acceleration rises linearly in smoothTime: the jerk is acc /
/// smoothTime, or dec / smoothTime. With a start velocity, the velocity steps from 0 to velStart,
/// and the acceleration then begins at 0.
Profile trap(const Trap& move);

/// Changes the target or the velocity of a running motion at the time t, ms (GT_SetPos, GT_SetVel,
/// GT_Update). `from` and `vel_start` are not used. For the rules, see with_target().
Trajectory trap(const Trajectory& running, double t, const Trap& move);

/// Parameters of a jog: GT_PrfJog, GT_SetJogPrm, GT_SetVel (manual 7.3).
struct Jog {
  double acc = 0;  ///< acceleration, pulse/ms^2, > 0
  double dec = 0;  ///< deceleration, pulse/ms^2; 0: acc
  /// Share 2 ta / (2 ta + te) of a ramp, 0 to below 1 (see Percent above); a larger share is
  /// gentler.
  double smooth = 0;
};

/// A new velocity at a given time (GT_SetVel and GT_Update).
struct JogVelocity {
  double time = 0;  ///< time of the change, ms
  double vel = 0;   ///< new velocity, pulse/ms, signed
};

/// Returns the motion from any state to the velocity `vel`, pulse/ms, which the axis then keeps.
/// The jerk is chosen so that a ramp over this change of velocity has the share `smooth`. If the
/// axis already accelerates, a ramp between rest and the greater of the two speeds has this share.
/// A motion that reverses consists of two ramps that meet at rest, each with this share.
Profile jog(const MotionState& from, double vel, const Jog& parameters);

/// Returns the motion through several velocities, one after another, from standstill at `from`,
/// pulse. Times must ascend, and the first velocity must not be 0. The motion begins at the first
/// time and ends when the axis reaches the last velocity.
Trajectory jog(double from, std::span<const JogVelocity> velocities, const Jog& parameters);

/// A move on the fly: GT_MoveAbsolute (manual 7.7, I-103).
struct MoveAbsolute {
  double from = 0;       ///< start position, pulse
  std::int64_t pos = 0;  ///< target, pulse, up to +-1 073 741 823
  double vel = 0;        ///< velocity, pulse/ms, > 0
  double acc = 0;        ///< peak acceleration, pulse/ms^2, > 0
  double dec = 0;        ///< peak deceleration, pulse/ms^2; 0: acc
  int percent = 0;       ///< 0 to 100: see Percent above
};

/// Returns a move from standstill.
Profile move_absolute(const MoveAbsolute& move);

/// Replaces a running motion at the time t, ms; `from` is not used. Each ramp has the jerk that
/// `percent` gives for a ramp from rest to `vel`. For the rules, see with_target().
Trajectory move_absolute(const Trajectory& running, double t, const MoveAbsolute& move);

/// A move from standstill with start and end velocities: GT_MoveAbsoluteEx (manual 7.7, I-104). The
/// first six members are as in MoveAbsolute.
struct MoveAbsoluteEx {
  double from = 0;
  std::int64_t pos = 0;
  double vel = 0;
  double acc = 0;
  double dec = 0;
  int percent = 0;
  /// velStart: initial velocity in the direction of the move, pulse/ms, 0 to vel.
  double vel_start = 0;
  /// velEnd: velocity at the target in the direction of the move, pulse/ms, 0 to vel.
  double vel_end = 0;
  int acc_start_percent = 0;  ///< accStartPercent: acceleration at the start, % of acc
  int dec_end_percent = 0;    ///< decEndPercent: deceleration at the end, % of dec
};

/// Returns the move. The acceleration rises from accStartPercent of acc to acc; at the end, the
/// deceleration falls from dec to decEndPercent of dec. The rise and the fall each take the time ta
/// that `percent` gives for their ramp, at any initial or final acceleration. Throws InputError if
/// the distance is too short for the change from vel_start to vel_end.
Profile move_absolute_ex(const MoveAbsoluteEx& move);

/// Direction of a velocity move: MC_POSITIVE_DIRECTION, MC_NEGATIVE_DIRECTION,
/// MC_CURRENT_DIRECTION.
enum class Direction { positive, negative, current };

/// A motion to a constant velocity: GT_MoveVelocity (manual 7.8, I-105).
struct MoveVelocity {
  double vel = 0;         ///< velocity, pulse/ms; a negative value reverses the direction
  double acc = 0;         ///< acceleration while speeding up, pulse/ms^2, > 0
  double dec = 0;         ///< deceleration while slowing down, pulse/ms^2; 0: acc
  double jerk_begin = 0;  ///< jerkBegin: jerk while the acceleration rises, pulse/ms^3, > 0
  double jerk_end = 0;    ///< jerkEnd: jerk while the acceleration falls, pulse/ms^3, > 0
  Direction direction = Direction::positive;  ///< direction; `current` at standstill: positive
};

/// Returns the motion from any state to the velocity, which the axis then keeps.
Profile move_velocity(const MotionState& from, const MoveVelocity& move);
/// Replaces a running motion at the time t, ms.
Trajectory move_velocity(const Trajectory& running, double t, const MoveVelocity& move);

}  // namespace jounce::googol
