// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "jounce/profiles/moves/dynamics.hpp"

/// The single-axis blocks of a Leadshine PMC600, in its own words: u (or pulse) and s. PMC600
/// manual, volume 4, 4.1, 5.2.2 and 5.2.4.
///
///     using namespace jounce::pmc600;
///     const Dynamics axis{.velocity = 2000, .acceleration = 4000};
///     const Trajectory move = move_absolute(0, 4000, axis, VelocityMode::sigmoid);
///     const Profile quick = ls_move({.to = 50000, .velocity = 10000, .acceleration = 100000,
///                                    .start_velocity = 1000});
///     const Trajectory more = move_additive(move, 1, 500, {.velocity = 2000, .acceleration = 4000});
///
/// **Throws** InputError for values out of range (the controller's errors 201, 226, 251, 276, 301,
/// 16#FFFFFF7 to 9).
namespace jounce::pmc600 {

/// Law of a change of velocity (4.1, "velocity mode"). The laws and their names are those of
/// SMC_INT_VELMODE in CODESYS.
enum class VelocityMode {
  trapezoid = 0,
  /// The trapezoid's edges as sin^2 of velocity, in the same time: the peak of the acceleration is
  /// pi/2 times the one given.
  sigmoid = 1,
  /// The same with the acceleration given as its peak: edges pi/2 times as long.
  sigmoid_limit = 2,
  /// Trapezoidal acceleration with the jerk given: the velocity is made of parabolas.
  quadratic = 3,
};

/// MC_MoveAbsolute from standstill (5.2.2); MC_MoveRelative is move_absolute(from, from + distance).
/// Mode quadratic needs a jerk > 0; the other modes do not use it.
Trajectory move_absolute(double from, double to, const Dynamics& dynamics,
                         VelocityMode mode = VelocityMode::trapezoid);

/// Default of StartVel and EndSecondVel, u/s; the velocity instead, if that is lower.
inline constexpr double default_end_velocity = 20;

/// LS_MoveAbs and LS_MoveRel (5.2.4): a trapezoid that steps to a start velocity, and from an end
/// velocity to rest.
struct LsMove {
  double from = 0;
  double to = 0;
  double velocity = 0;                                ///< u/s, > 0
  double acceleration = 0;                            ///< u/s^2, > 0
  double deceleration = 0;                            ///< u/s^2; 0: as acceleration
  double start_velocity = default_end_velocity;       ///< StartVel, u/s, >= 0.001, at most velocity
  double end_second_velocity = default_end_velocity;  ///< EndSecondVel, u/s, likewise
};

/// Ends at `to` with end_second_velocity, after which the axis stands. If the distance is too short
/// for the change from one of the two velocities to the other, the higher one is lowered.
Profile ls_move(const LsMove& move);

/// LS_MoveVel: from standstill, stepping to start_velocity (not above |velocity|), to `velocity`
/// (signed), and on.
Profile ls_move_velocity(double from, double velocity, double acceleration,
                         double start_velocity = default_end_velocity);

/// LS_PositionToVelocity (5.2.4): two moves with no stop at the joint.
struct PositionToVelocity {
  double from = 0;
  bool relative = false;  ///< MoveMode: end positions count from the one before
  std::array<double, 2> end_pos{};
  std::array<double, 2> velocity{10, 10};
  std::array<double, 2> acceleration{10, 10};
  std::array<double, 2> deceleration{10, 10};
  std::array<double, 2> jerk{90'000'000, 90'000'000};
  VelocityMode mode = VelocityMode::sigmoid;
};

/// Passes end_pos[0] without acceleration at the lower of the two velocities; slower, if the first
/// move is too short to reach it or the second to stop from it; at rest, if the direction reverses.
Trajectory position_to_velocity(const PositionToVelocity& move);

// ---- in flight: these take any running motion; t in s ---------------------------------------------
// LS_MoveAbsChangePosVel is with_target, LS_MoveChangeVel, MC_Halt and MC_Stop are with_velocity.

/// MC_MoveAdditive: to the previous target plus `distance`, with this block's dynamics from t on;
/// after a velocity command (a motion that ends moving): `distance` from the position at t.
Trajectory move_additive(const Trajectory& running, double t, double distance,
                         const Dynamics& dynamics);

/// MC_MoveSuperImposed: a second motion over `distance` on top of the running one from t on;
/// dynamics.velocity is its VelocityDiff. At `abort`, if given, it stops with its deceleration,
/// while the running motion continues. After a velocity command: as move_additive.
Trajectory move_superimposed(const Trajectory& running, double t, double distance,
                             const Dynamics& dynamics, std::optional<double> abort = {});

/// SMC_Inch: one step of `distance` (signed) from standstill; the input dropped at `released` s ends
/// it early with a stop.
Trajectory inch(double from, double distance, const Dynamics& dynamics,
                std::optional<double> released = {});

/// MC_Jog's inputs from a time on; both at once mean no motion.
struct JogInput {
  double time = 0;  ///< s
  bool forward = false;
  bool backward = false;
};

/// MC_Jog from standstill; times ascend, none equal to the one before. The velocity is clipped to
/// `max_velocity`, if given. Begins with the first input and ends when the velocity of the last one
/// is reached.
Trajectory jog(double from, std::span<const JogInput> inputs, const Dynamics& dynamics,
               std::optional<double> max_velocity = {});

}  // namespace jounce::pmc600
