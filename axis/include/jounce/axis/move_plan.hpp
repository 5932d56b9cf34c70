// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/cause.hpp"
#include "jounce/axis/command.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// Goal and dynamics of a planned move, for all moves of PLCopen.
struct Goal {
  enum class Kind : std::uint8_t {
    rest,      ///< MC_Stop, MC_Halt
    position,  ///< MC_MoveAbsolute, Relative, Additive
    velocity,  ///< MC_MoveVelocity, and what CamOut and GearOut leave
  };
  Kind kind = Kind::rest;
  double value = 0;            ///< u (of a modulo axis not reduced), or u/s, signed
  MoveDynamics dynamics = {};  ///< like fill() leaves it
  double through = 0;          ///< u/s, signed: the velocity at a position, also above that of the
                               ///< dynamics: then it speeds up before it; 0: it ends there
};

/// Fills in what is not given with the limits of the axis (an infinite jerk where it has none), in place.
/// Rejects values that are not greater than 0 or exceed a limit (PMC600 errors 201, 226, 301).
std::optional<Refusal> fill(MoveDynamics& dynamics, const AxisConfig& config) noexcept;

/// Like `fill`, with the limits of a stop: its deceleration and jerk may be what the axis stops with.
std::optional<Refusal> fill_stop(MoveDynamics& dynamics, const AxisConfig& config) noexcept;

/// The move to the goal from any state, at `factor` times its velocity; the fastest that keeps the dynamics and the
/// position range. Nothing where there is none, or none that a double has the digits for (a deceleration of 1e-12
/// after full speed). While it slows down it does so with `deceleration`; an axis that has to turn round brakes
/// with `acceleration`. To rest it turns round at the end of the range, if it must, and comes back to it.
/// Factor 0: to rest, with the limits of the axis, independent of the dynamics of the goal.
///
///     Goal goal{Goal::Kind::position, 6000, dynamics};
///     if (const auto profile = plan(now, goal, 1, config)) ...
std::optional<Profile> plan(const MotionState& from, const Goal& goal, double factor,
                            const AxisConfig& config) noexcept;

/// The lowest and the highest velocity of a motion, u/s, exactly.
std::array<double, 2> velocities(const Profile& profile) noexcept;

/// The lowest and the highest position of a motion, u, to rounding.
std::array<double, 2> positions(const Profile& profile) noexcept;

/// The greatest magnitudes of a motion, u/s, u/s^2, u/s^3; of one without a jerk limit the jerk is 0.
Peaks peaks(const Profile& profile) noexcept;

/// The velocity, u/s and signed, at which a move may pass its target on the way to that of the next
/// one: as the mode defines, also above its own, but at most so that neither move turns round and the axis can
/// stop inside its range (the greatest such velocity to 1e-6 of it). 0: it comes to rest there.
double passing_velocity(const MotionState& from, const Goal& goal, const Goal& next,
                        BufferMode mode, double factor, const AxisConfig& config) noexcept;

/// Target of a move to `position` on this axis: `position`, or on a modulo axis the requested way from
/// the state it is in. Nothing where there is no such way.
std::optional<double> target_of(double position, Direction direction, const MotionState& from,
                                const MoveDynamics& dynamics, const AxisConfig& config) noexcept;

}  // namespace jounce
