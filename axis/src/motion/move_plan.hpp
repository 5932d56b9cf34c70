// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// Goal and dynamics of a move that the axis plans. The motion commands of PLCopen are converted to
/// goals. u is the unit of the axis.
struct Goal {
  enum class Kind : std::uint8_t {
    rest,      ///< MC_Stop, MC_Halt
    position,  ///< MC_MoveAbsolute, MC_MoveRelative, MC_MoveAdditive
    velocity,  ///< MC_MoveVelocity, and the velocity that remains after CamOut and GearOut
  };
  Kind kind = Kind::rest;  ///< kind of the goal
  double value = 0;        ///< target, u (not reduced on a modulo axis), or velocity, u/s, signed
  MoveDynamics dynamics = {};  ///< complete after fill()
  /// Velocity at the target, u/s, signed; 0: rest. It may exceed dynamics.velocity.
  double through = 0;
};

/// Sets missing values to the limits of the axis. If the axis has no jerk limit, a missing jerk
/// becomes infinite. Returns nullopt, or the reason to reject a value that is not greater than 0 or
/// exceeds its limit (PMC600 errors 201, 226, 301).
std::optional<Refusal> fill(MoveDynamics& dynamics, const AxisConfig& config) noexcept;

/// Like fill(), but deceleration and jerk may be as large as in a stop
/// (AxisConfig::stop_acceleration, stop_jerk).
std::optional<Refusal> fill_stop(MoveDynamics& dynamics, const AxisConfig& config) noexcept;

/// Returns the fastest move to the goal from any state, within the dynamics and the position range,
/// at `factor` times the goal's velocity. Returns nullopt if no such move exists, or if a double
/// cannot represent it (for example a deceleration of 1e-12 after full speed).
///
/// The move slows down with `deceleration`; an axis that must reverse brakes with `acceleration`.
/// If necessary, a move to rest reverses at the end of the range and returns into the range. With
/// factor 0 the move goes to rest with the limits of the axis, not with the dynamics of the goal.
///
///     Goal goal{Goal::Kind::position, 6000, dynamics};
///     if (const auto profile = plan(now, goal, 1, config)) ...
std::optional<Profile> plan(const MotionState& from, const Goal& goal, double factor,
                            const AxisConfig& config) noexcept;

/// Returns the lowest and highest velocity of a motion, u/s; exact.
std::array<double, 2> velocities(const Profile& profile) noexcept;

/// Returns the lowest and highest position of a motion, u; exact up to rounding.
std::array<double, 2> positions(const Profile& profile) noexcept;

/// Returns the greatest magnitudes of a motion: u/s, u/s^2, u/s^3. The jerk is 0 for a motion
/// without a jerk limit.
Peaks peaks(const Profile& profile) noexcept;

/// Returns the velocity at which a move may pass its target on the way to the target of the next
/// move, u/s, signed, as the buffer mode defines it. 0: the move comes to rest at its target. The
/// result is the greatest velocity, to 1e-6 of its value, at which neither move reverses and the
/// axis can stop inside its range. It may exceed the velocity of the move.
double passing_velocity(const MotionState& from, const Goal& goal, const Goal& next,
                        BufferMode mode, double factor, const AxisConfig& config) noexcept;

/// Returns the target of a move to `position` on this axis, u. On a modulo axis, the target is the
/// equivalent position in the requested direction from the present state. Returns nullopt if no
/// such target exists.
std::optional<double> target_of(double position, Direction direction, const MotionState& from,
                                const MoveDynamics& dynamics, const AxisConfig& config) noexcept;

}  // namespace jounce
