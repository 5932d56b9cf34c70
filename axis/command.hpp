#pragma once

#include <cstdint>
#include <limits>

#include "jounce/axis/movement.hpp"
#include "jounce/profiles/modulo.hpp"
#include "jounce/profiles/queue.hpp"

namespace jounce {

/// A value of MoveDynamics that is not given: NaN.
inline constexpr double as_configured = std::numeric_limits<double>::quiet_NaN();

/// What a move may do: magnitudes, > 0. One that is not given is the limit of the axis.
struct MoveDynamics {
  double velocity = as_configured;      ///< u/s
  double acceleration = as_configured;  ///< u/s^2, while it speeds up
  double deceleration = as_configured;  ///< u/s^2, while it slows down
  double jerk = as_configured;          ///< u/s^3
};

/// When what is armed begins.
enum class StartAt : std::uint8_t {
  tick,             ///< `at`
  end_of_table,     ///< where the table that is played ends, or its present pass: no stop between
  master_position,  ///< where the master passes `position`
};

/// What a command may change of an axis's HomingSpec, besides its offset (`position`), search velocity and
/// acceleration (`dynamics`). NaN, and method 0: as configured.
struct HomingChoice {
  int method = 0;
  double index_velocity = as_configured;  ///< u/s, > 0
  double timeout = as_configured;         ///< s, > 0
  double distance = as_configured;        ///< u, > 0
};

/// What an axis is told. At most one command a tick; of several in a row the last one wins.
struct Command {
  enum class Kind : std::uint8_t {
    none,
    enable,
    disable,
    arm,                ///< `movement` becomes the one to be started; it replaces one that waits
    disarm,             ///< takes it back, unless its start was accepted
    start,              ///< what is armed, see `start_at`
    stop,               ///< on the path if there is one; disarms; nothing but a fault ends it
    abort,              ///< at once: a fault
    reset,              ///< clears a fault
    set_position,       ///< the axis stands at `position` (or `relative`: so much further on)
    home,               ///< searches for the home position, as `homing` says, in the state homing
    hold,               ///< a path, or a planned move: to rest, and it waits there
    resume,             ///< ends the hold
    override_,          ///< `factor` times the speed from now on
    finish,             ///< a table that repeats ends with this pass (Agito StopRep)
    move_absolute,      ///< to `position`
    move_relative,      ///< by `position` from where the setpoint is
    move_additive,      ///< by `position` from the target of the move under way
    move_superimposed,  ///< by `position` on top of what is under way; `dynamics.velocity` is added
    move_velocity,      ///< at the velocity `position`, u/s, until the next command; 0: to rest.
                        ///< dynamics.velocity has no meaning
    halt,               ///< as stop, but any command may follow at once
    gear_in,            ///< `movement`, a live one, begins now, in whatever motion the axis is
    gear_out,           ///< leaves the gear; the velocity stays
    cam_out,            ///< leaves the cam; the velocity stays
    release,            ///< as stop: who held a hold-to-run jog has let go
  };
  Kind kind = Kind::none;
  std::uint64_t id = 0;          ///< the sender's, handed back with the answer
  Movement* movement = nullptr;  ///< must live until it is handed back
  StartAt start_at = StartAt::tick;
  std::int64_t group = 0;  ///< an arm's and its start's: motions of one group start and stop together; 0: none
  std::int64_t at = -1;  ///< tick; -1: in the step that gets the command. Arm knows no other
  /// u; u/s of move_velocity, m for a master; relative moves: a distance; home: the position that home
  /// gets, NaN: as configured.
  double position = 0;
  bool relative = false;
  double factor = 1;  ///< of override_, 0 to 2
  MoveDynamics dynamics = {};
  Direction direction = Direction::shortest;  ///< of a move on a modulo axis
  /// When a move takes over from the motion before it: docs/executor/axis.md.
  BufferMode buffer = BufferMode::aborting;  ///< of move_absolute, move_relative, move_velocity
  HomingChoice homing = {};
};
inline constexpr std::size_t command_kinds = 25;

/// "move_absolute", ...
const char* name(Command::Kind kind);

}  // namespace jounce
