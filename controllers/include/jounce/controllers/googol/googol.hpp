// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "jounce/profiles/moves/dynamics.hpp"

/// The point-to-point, jog and on-the-fly moves of a Googol iDEABOX Pro, in its own words and
/// units: pulse, pulse/ms, pulse/ms^2, pulse/ms^3, ms. The trajectories run over ms.
///
///     using namespace jounce::googol;
///     const Profile move = trap({.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125,
///                                .smooth_time = 25});                   // 1325 ms, example 7-1
///     const Profile fly = move_absolute({.pos = 50000, .vel = 50, .acc = 1, .dec = 10,
///                                        .percent = 50});
///     const Trajectory later = move_absolute(fly.curve(), 300, {.pos = 80000, .vel = 50, .acc = 1});
///
/// **Percent** (7.7.1): 100 * 2 ta / (2 ta + te), where ta is the time in which the acceleration
/// rises (or falls) and te the time for which it is constant; 0 is a trapezoid, 100 has no constant
/// part. `acc` is the peak, so that a change of velocity dv takes T = dv / (acc (1 - percent/200)).
///
/// **Throws** InputError for a value out of the manual's range.
namespace jounce::googol {

inline constexpr std::int64_t max_position = 1'073'741'823;  ///< pulse, of either sign (I-144)

/// GT_PrfTrap, GT_SetTrapPrm, GT_SetPos, GT_SetVel, GT_Update. Manual 7.2.
struct Trap {
  double from = 0;       ///< pulse
  std::int64_t pos = 0;  ///< pulse, +-1 073 741 823, not equal to `from`
  double vel = 0;        ///< pulse/ms, > 0
  double acc = 0;        ///< pulse/ms^2, > 0
  double dec = 0;        ///< pulse/ms^2; 0: as acc
  double vel_start = 0;  ///< velStart, pulse/ms, not above vel: the motion begins at this speed
  int smooth_time = 0;   ///< smoothTime, ms, 0 to 50, in which the acceleration builds up
};

/// A move from standstill. The acceleration ramps linearly over smoothTime (jerk = acc /
/// smoothTime, dec / smoothTime); a start speed steps from rest, the acceleration then starts from
/// zero.
Profile trap(const Trap& move);

/// Position or velocity changed while moving, effective at t (GT_SetPos, GT_SetVel, GT_Update);
/// `from` and `vel_start` are not used. See with_target for the rules.
Trajectory trap(const Trajectory& running, double t, const Trap& move);

/// GT_PrfJog, GT_SetJogPrm, GT_SetVel. Manual 7.3.
struct Jog {
  double acc = 0;     ///< pulse/ms^2, > 0
  double dec = 0;     ///< pulse/ms^2; 0: as acc
  double smooth = 0;  ///< 0 to below 1: the share of a ramp that is not at constant acceleration,
                      ///< 2 ta / (2 ta + te) as in `percent`; larger is gentler
};

/// GT_SetVel and GT_Update at a time.
struct JogVelocity {
  double time = 0;  ///< ms
  double vel = 0;   ///< pulse/ms, signed
};

/// Accelerates to the velocity and keeps it. If the axis already accelerates, the jerk is that of
/// `smooth` for a ramp between rest and the greater of the two velocities.
Profile jog(const MotionState& from, double vel, const Jog& parameters);

/// Several velocities one after another, from standstill at `from`; times ascend. Begins with the
/// first and ends when the last velocity is reached.
Trajectory jog(double from, std::span<const JogVelocity> velocities, const Jog& parameters);

/// GT_MoveAbsolute. Manual 7.7, I-103.
struct MoveAbsolute {
  double from = 0;       ///< pulse
  std::int64_t pos = 0;  ///< pulse, +-1 073 741 823
  double vel = 0;        ///< pulse/ms, > 0
  double acc = 0;        ///< pulse/ms^2, > 0, the peak
  double dec = 0;        ///< pulse/ms^2, the peak; 0: as acc
  int percent = 0;       ///< 0 to 100
};

/// From standstill.
Profile move_absolute(const MoveAbsolute& move);

/// While moving: from the state at t; `from` is not used. The jerk of each half is that of
/// `percent` for a ramp from rest to `vel`; see with_target.
Trajectory move_absolute(const Trajectory& running, double t, const MoveAbsolute& move);

/// GT_MoveAbsoluteEx, from standstill. Manual 7.7, I-104.
struct MoveAbsoluteEx {
  double from = 0;
  std::int64_t pos = 0;
  double vel = 0;
  double acc = 0;
  double dec = 0;
  int percent = 0;
  double vel_start = 0;       ///< velStart, pulse/ms, in the direction of the move, 0 to vel
  double vel_end = 0;         ///< velEnd, pulse/ms, likewise: the speed at which pos is passed
  int acc_start_percent = 0;  ///< accStartPercent: initial acceleration in % of acc
  int dec_end_percent = 0;    ///< decEndPercent: final deceleration in % of dec
};

/// The rising ramp leads from accStartPercent of acc to acc in the same ta, the last one from dec
/// to decEndPercent of dec: `percent` keeps its meaning. Refused if the distance is too short for
/// the change from vel_start to vel_end.
Profile move_absolute_ex(const MoveAbsoluteEx& move);

/// MC_POSITIVE_DIRECTION, MC_NEGATIVE_DIRECTION, MC_CURRENT_DIRECTION.
enum class Direction { positive, negative, current };

/// GT_MoveVelocity. Manual 7.8, I-105.
struct MoveVelocity {
  double vel = 0;         ///< pulse/ms; a negative one reverses the direction
  double acc = 0;         ///< pulse/ms^2, > 0, for speeding up
  double dec = 0;         ///< pulse/ms^2, for slowing down; 0: as acc
  double jerk_begin = 0;  ///< jerkBegin, pulse/ms^3, > 0: from no acceleration to the peak
  double jerk_end = 0;    ///< jerkEnd, pulse/ms^3, > 0: from the peak to none
  Direction direction = Direction::positive;  ///< current, at standstill: positive
};

/// Accelerates to the velocity and keeps it; from any state.
Profile move_velocity(const MotionState& from, const MoveVelocity& move);
Trajectory move_velocity(const Trajectory& running, double t, const MoveVelocity& move);

}  // namespace jounce::googol
