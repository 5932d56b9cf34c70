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

/// Goal and dynamics of a planned move, for all moves of PLCopen.
struct Goal {
  enum class Kind : std::uint8_t {
    rest,      ///< MC_Stop, MC_Halt
    position,  ///< MC_MoveAbsolute, Relative, Additive
    velocity,  ///< MC_MoveVelocity, and the velocity after CamOut and GearOut
  };
  Kind kind = Kind::rest;
  double value = 0;            ///< u (not reduced for a modulo axis), or u/s, signed
  MoveDynamics dynamics = {};  ///< complete after fill()
  double through = 0;          ///< u/s, signed: the velocity at the target; 0: it ends there. May
                               ///< exceed that of the dynamics: the move then speeds up before it
};

/// Sets missing values to the limits of the axis (an infinite jerk if it has none), in place.
/// Rejects values that are not greater than 0 or exceed a limit (PMC600 errors 201, 226, 301).
std::optional<Refusal> fill(MoveDynamics& dynamics, const AxisConfig& config) noexcept;

/// Like `fill`, with the limits of a stop: deceleration and jerk may be as large as those of a
/// stop.
std::optional<Refusal> fill_stop(MoveDynamics& dynamics, const AxisConfig& config) noexcept;

/// Returns the fastest move to the goal from any state, at `factor` times its velocity, within the
/// dynamics and the position range. Returns nullopt if there is none, or none within the precision
/// of a double (a deceleration of 1e-12 after full speed). The move slows down with `deceleration`;
/// an axis that has to reverse brakes with `acceleration`. A move to rest reverses at the end of
/// the range if necessary and returns to it. Factor 0: to rest, with the limits of the axis,
/// independent of the dynamics of the goal.
///
///     Goal goal{Goal::Kind::position, 6000, dynamics};
///     if (const auto profile = plan(now, goal, 1, config)) ...
std::optional<Profile> plan(const MotionState& from, const Goal& goal, double factor,
                            const AxisConfig& config) noexcept;

/// The lowest and the highest velocity of a motion, u/s, exactly.
std::array<double, 2> velocities(const Profile& profile) noexcept;

/// The lowest and the highest position of a motion, u, to rounding.
std::array<double, 2> positions(const Profile& profile) noexcept;

/// The greatest magnitudes of a motion, u/s, u/s^2, u/s^3; the jerk is 0 for a motion without a
/// jerk limit.
Peaks peaks(const Profile& profile) noexcept;

/// Returns the velocity, u/s and signed, at which a move may pass its target on the way to that of
/// the next one, as the mode defines. It may exceed the velocity of the move. Neither move
/// reverses, and the axis can stop inside its range (the greatest such velocity to 1e-6 of it). 0:
/// the move comes to rest there.
double passing_velocity(const MotionState& from, const Goal& goal, const Goal& next,
                        BufferMode mode, double factor, const AxisConfig& config) noexcept;

/// Returns the target of a move to `position` on this axis: `position`, or on a modulo axis the
/// target in the requested direction from the present state. Returns nullopt if there is none.
std::optional<double> target_of(double position, Direction direction, const MotionState& from,
                                const MoveDynamics& dynamics, const AxisConfig& config) noexcept;

}  // namespace jounce
