// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "jounce/profiles/moves/dynamics.hpp"

/// The single-axis blocks of a Leadshine PMC600 (PMC600 manual, volume 4, 4.1, 5.2.2 and 5.2.4),
/// with the names of its manual. Units: u, the unit of the axis (or pulse), and s.
///
///     using namespace jounce::pmc600;
///     const Dynamics axis{.velocity = 2000, .acceleration = 4000};
///     const Trajectory move = move_absolute(0, 4000, axis, VelocityMode::sigmoid);
///     const Profile quick = ls_move({.to = 50000, .velocity = 10000, .acceleration = 100000,
///                                    .start_velocity = 1000});
///     const Trajectory more = move_additive(move, 1, 500, {.velocity = 2000, .acceleration = 4000});
///
/// **Errors**: functions throw InputError for a value out of range (the controller's errors 201,
/// 226, 251, 276, 301, 16#FFFFFF7 to 16#FFFFFF9).
namespace jounce::pmc600 {

/// Law of a change of velocity (manual 4.1, "velocity mode"). SMC_INT_VELMODE in CODESYS has the
/// same names and laws.
enum class VelocityMode {
  /// Constant acceleration.
  trapezoid = 0,
  /// The velocity of each ramp follows a sin^2, in the time of the ramp of the trapezoid. So the
  /// peak acceleration is pi/2 times the given acceleration.
  sigmoid = 1,
  /// Like sigmoid, but the given acceleration is the peak: a ramp takes pi/2 times as long.
  sigmoid_limit = 2,
  /// The acceleration is a trapezoid with the given jerk; the velocity consists of parabolas and
  /// lines.
  quadratic = 3,
};

/// MC_MoveAbsolute from standstill (5.2.2); MC_MoveRelative is move_absolute(from, from +
/// distance). Mode quadratic needs a jerk > 0; the other modes do not use it.
Trajectory move_absolute(double from, double to, const Dynamics& dynamics,
                         VelocityMode mode = VelocityMode::trapezoid);

/// Default of StartVel and EndSecondVel, u/s. If the velocity of the move is lower than this value,
/// the default is the velocity of the move.
inline constexpr double default_end_velocity = 20;

/// LS_MoveAbs and LS_MoveRel (manual 5.2.4): a trapezoid whose velocity steps from rest to a start
/// velocity, and from an end velocity to rest.
struct LsMove {
  double from = 0;                                    ///< start position, u
  double to = 0;                                      ///< target, u
  double velocity = 0;                                ///< velocity, u/s, > 0
  double acceleration = 0;                            ///< acceleration, u/s^2, > 0
  double deceleration = 0;                            ///< deceleration, u/s^2; 0: acceleration
  double start_velocity = default_end_velocity;       ///< StartVel, u/s, 0.001 to velocity
  double end_second_velocity = default_end_velocity;  ///< EndSecondVel, u/s, 0.001 to velocity
};

/// Returns the move. It ends at `to` with end_second_velocity; the axis then stands still. If the
/// distance is too short for the change from start_velocity to end_second_velocity, or back, the
/// higher of these velocities is reduced.
Profile ls_move(const LsMove& move);

/// LS_MoveVel from standstill: the velocity steps to start_velocity (at most |velocity|), changes
/// to `velocity` (u/s, signed), and then stays constant.
Profile ls_move_velocity(double from, double velocity, double acceleration,
                         double start_velocity = default_end_velocity);

/// LS_PositionToVelocity (manual 5.2.4): two moves without a stop between them. Arrays have one
/// entry for each move.
struct PositionToVelocity {
  double from = 0;        ///< start position, u
  bool relative = false;  ///< MoveMode; true: an end position is relative to the previous position
  std::array<double, 2> end_pos{};                     ///< end positions, u
  std::array<double, 2> velocity{10, 10};              ///< u/s, > 0
  std::array<double, 2> acceleration{10, 10};          ///< u/s^2, > 0
  std::array<double, 2> deceleration{10, 10};          ///< u/s^2, > 0
  std::array<double, 2> jerk{90'000'000, 90'000'000};  ///< u/s^3, > 0, for mode quadratic
  VelocityMode mode = VelocityMode::sigmoid;
};

/// Returns the two moves as one motion. The axis passes end_pos[0] without acceleration, at the
/// lower of the two velocities. If the first move is too short to reach this velocity, or the
/// second move too short to stop from it, the axis passes end_pos[0] more slowly. If the direction
/// reverses, the axis comes to rest at end_pos[0].
Trajectory position_to_velocity(const PositionToVelocity& move);

// Functions for any running motion; t is the time of the change, s. For LS_MoveAbsChangePosVel use
// with_target(); for LS_MoveChangeVel, MC_Halt and MC_Stop use with_velocity().

/// MC_MoveAdditive: from t on, moves to the previous target plus `distance` (u), with these
/// dynamics. After a velocity command (a motion that ends at a nonzero velocity), `distance` counts
/// from the position at t.
Trajectory move_additive(const Trajectory& running, double t, double distance,
                         const Dynamics& dynamics);

/// MC_MoveSuperImposed: from t on, adds a second motion over `distance` (u) to the running one.
/// dynamics.velocity is the VelocityDiff of the added motion. If `abort` (s) is given, the added
/// motion stops at that time with its deceleration, and the running motion continues. After a
/// velocity command, the function acts like move_additive().
Trajectory move_superimposed(const Trajectory& running, double t, double distance,
                             const Dynamics& dynamics, std::optional<double> abort = {});

/// SMC_Inch: one step of `distance` (u, signed) from standstill. If the input is released at the
/// time `released` (s), the axis stops early.
Trajectory inch(double from, double distance, const Dynamics& dynamics,
                std::optional<double> released = {});

/// Inputs of MC_Jog from the given time on. If both inputs are on, the axis does not move.
struct JogInput {
  double time = 0;        ///< s
  bool forward = false;   ///< the input JogForward
  bool backward = false;  ///< the input JogBackward
};

/// MC_Jog from standstill. Times must ascend strictly. `max_velocity` (u/s), if given, limits the
/// velocity. The motion begins with the first input and ends when the axis reaches the velocity of
/// the last input.
Trajectory jog(double from, std::span<const JogInput> inputs, const Dynamics& dynamics,
               std::optional<double> max_velocity = {});

}  // namespace jounce::pmc600
