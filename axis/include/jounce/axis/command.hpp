// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "jounce/axis/movement.hpp"
#include "jounce/profiles/curve/modulo.hpp"
#include "jounce/profiles/sequences/queue.hpp"

namespace jounce {

/// A value of MoveDynamics that is not given: NaN.
inline constexpr double as_configured = std::numeric_limits<double>::quiet_NaN();

/// Dynamics of a move: magnitudes, > 0. The default of each is the limit of the axis.
struct MoveDynamics {
  double velocity = as_configured;      ///< u/s
  double acceleration = as_configured;  ///< u/s^2, while it speeds up
  double deceleration = as_configured;  ///< u/s^2, while it slows down
  double jerk = as_configured;          ///< u/s^3
};

/// Start condition of the armed movement.
enum class StartAt : std::uint8_t {
  tick,             ///< `at`
  end_of_table,     ///< at the end of the played table or of its pass, without a stop
  master_position,  ///< when the master passes `position`
};

/// Changes of a command to the HomingSpec of an axis, besides its offset (`position`), search
/// velocity and acceleration (`dynamics`). NaN, and method 0: as configured.
struct HomingChoice {
  int method = 0;
  double index_velocity = as_configured;  ///< u/s, > 0
  double timeout = as_configured;         ///< s, > 0
  double distance = as_configured;        ///< u, > 0
};

/// A command to an axis, at most one in each tick. If several arrive for a tick, the last one takes
/// effect.
struct Command {
  enum class Kind : std::uint8_t {
    none,
    enable,
    disable,
    arm,                ///< arms `movement`; replaces an armed one
    disarm,             ///< disarms it, unless its start was accepted
    start,              ///< starts the armed motion, see `start_at`
    stop,               ///< to rest, on the path if there is one; disarms; only a fault ends it
    abort,              ///< stops at once: a fault
    reset,              ///< clears a fault
    set_position,       ///< sets the present position to `position` (`relative`: adds it)
    home,               ///< searches for the home position with `homing`, in the state homing
    hold,               ///< brings a path or a planned move to rest; it waits there
    resume,             ///< ends the hold
    override_,          ///< `factor` times the speed from now on
    finish,             ///< ends a table that repeats at the end of this pass (Agito StopRep)
    move_absolute,      ///< to `position`
    move_relative,      ///< by `position` from the present setpoint
    move_additive,      ///< by `position` from the target of the present move
    move_superimposed,  ///< by `position` on top of the motion; `dynamics.velocity` is added
    move_velocity,      ///< at the velocity `position`, u/s, until the next command; 0: to rest.
                        ///< Ignores dynamics.velocity
    halt,               ///< like stop, but any command may follow at once
    gear_in,            ///< starts `movement`, a live one, now, during any motion
    gear_out,           ///< leaves the gear; the velocity stays
    cam_out,            ///< leaves the cam; the velocity stays
    release,            ///< like stop: end of a hold-to-run jog
  };
  Kind kind = Kind::none;
  std::uint64_t id = 0;          ///< id of the sender, returned with the answer
  Movement* movement = nullptr;  ///< must live until the axis returns it
  StartAt start_at = StartAt::tick;
  std::int64_t group =
      0;  ///< group of an arm and its start: its motions start and stop together; 0: none
  std::int64_t at = -1;  ///< tick; -1: at once, the only value for arm
  /// u; u/s of move_velocity, m for a master; relative moves: a distance; home: the new position of
  /// the home position, NaN: as configured.
  double position = 0;
  bool relative = false;
  double factor = 1;  ///< factor of override_, 0 to 2
  MoveDynamics dynamics = {};
  Direction direction = Direction::shortest;  ///< for a move on a modulo axis
  /// Start relative to the previous motion: docs/executor/axis.md.
  BufferMode buffer = BufferMode::aborting;  ///< for move_absolute, move_relative, move_velocity
  HomingChoice homing = {};
};
inline constexpr std::size_t command_kinds = 25;

/// "move_absolute", ...
const char* name(Command::Kind kind);

}  // namespace jounce
