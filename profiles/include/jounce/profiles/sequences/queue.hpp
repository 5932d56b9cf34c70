// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/moves/dynamics.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// A queue of commands for one axis, planned as one motion, like the command buffer of a controller
/// with buffered, blended and aborting moves (PLCopen Motion Control Part 1; PMC600 manual 7.1,
/// Table 7.1; HIMC HMPL manual 8.1.4).
///
///     const Dynamics slow{.velocity = 5, .acceleration = 10};
///     const Dynamics fast{.velocity = 20, .acceleration = 20};
///     const QueuedMotion motion = queue({.commands = {
///         {MoveAbsolute{10}, slow},
///         {MoveAbsolute{50}, fast, BufferMode::blending_low}}});
///     motion.commands[0].reached;        // 5: the velocity with which the axis passes 10
///
/// **Vocabulary.** A *junction* is the transition from a position move to the next command. It lies
/// at the end position of the move, with acceleration 0, at the *junction velocity*. A *batch* is
/// the sequence of commands that are planned together: an aborting command and all commands up to
/// the next aborting one.
///
/// **Units.** The axis' unit u: u, u/s, u/s^2, u/s^3. Times in s from the start of the queue.
///
/// **Throws** InputError for bad input; its key counts commands from 1. Bad input is a queue
/// without commands, a magnitude above 1e30, a limit below 1e-30, a queue of duration 0, or a
/// command that would begin in a state beyond the range of move_to(). Every other queue has a
/// motion.

/// When a command begins, relative to the previous command. The controllers use the same numbers.
enum class BufferMode : std::uint8_t {
  aborting = 0,  ///< at once, when issued; ends the present command and removes all waiting
                 ///< commands
  /// when the previous command is done: at rest or, for MoveVelocity, at its velocity
  buffered = 1,
  /// At the end position of the previous command, with the lower of the two command velocities.
  blending_low = 2,
  blending_previous = 3,  ///< like blending_low, with the velocity of the previous command
  blending_next = 4,      ///< like blending_low, with the velocity of this command
  blending_high = 5,      ///< like blending_low, with the higher of the two velocities
};

/// MC_MoveAbsolute: a move to a position.
struct MoveAbsolute {
  double position = 0;  ///< u
};

/// MC_MoveRelative: a move by a distance. It counts from the target of the previous command or,
/// after an abort, from the position at that moment (PMC600 manual 5.2.2).
struct MoveRelative {
  double distance = 0;  ///< u, signed
};

/// MC_MoveVelocity: a change to the velocity of the command's dynamics. Done when the axis reaches
/// the velocity.
struct MoveVelocity {
  int direction = 1;  ///< 1 or -1
};

/// MC_Halt: a stop, at any position. Done at rest.
struct Halt {};

/// Waits in the state in which the previous command ended: at rest or, after MoveVelocity, at its
/// velocity.
struct Dwell {
  double time = 0;  ///< s, >= 0; need not be a multiple of a cycle (PMC600 manual 7.2.6, GroupWait)
};

using MotionCommand = std::variant<MoveAbsolute, MoveRelative, MoveVelocity, Halt, Dwell>;

/// A command in the queue.
struct QueuedCommand {
  MotionCommand command = {};
  /// Not used by Dwell; Halt does not use the velocity. In both directions, `acceleration` applies
  /// while the axis speeds up, `deceleration` while it slows down. If the two differ, a motion that
  /// must reverse (after an abort) stops first, then moves back, like with_target(). There is only
  /// one jerk: deceleration_jerk must be 0 or equal to jerk.
  Dynamics dynamics = {};
  /// For the first command, only `aborting` has an effect: it permits `issued`.
  BufferMode mode = BufferMode::buffered;
  /// Time at which an aborting command is issued: s, >= 0, not before the previous aborting
  /// command. Required for an aborting command, except for the first command; not permitted
  /// otherwise. A Dwell can abort only as the first command.
  std::optional<double> issued = {};
};

/// Input of queue().
struct QueueSpec {
  /// State at time 0; acceleration must be 0 if the first command is a Dwell, or is issued later
  /// than 0 s.
  MotionState start = {};
  std::vector<QueuedCommand> commands = {};  ///< in the order of the queue
};

/// Outcome of a command.
enum class CommandState : std::uint8_t {
  done,     ///< the axis reached the command's target or velocity
  aborted,  ///< aborted while it ran, or before it began (then end == begin); PLCopen
            ///< CommandAborted
};

/// Result of one command. Positions and velocities have the sign of the axis.
struct CommandRecord {
  double begin = 0;    ///< s, a break of the trajectory
  double end = 0;      ///< s, a break of the trajectory
  double target = 0;   ///< u, the end position; for an aborted command, its intended end position
  double planned = 0;  ///< u/s, the junction velocity that the mode of the next command requires
  double reached = 0;  ///< u/s, the velocity at `end`
  CommandState state = CommandState::done;
};

/// Result of queue().
struct QueuedMotion {
  /// Begins at 0 s; holds outside if it begins and ends at rest; otherwise it refuses.
  Trajectory trajectory;
  std::vector<CommandRecord> commands = {};  ///< one for each command, in their order
  MotionState end = {};                      ///< state at the end of the trajectory
};

/// Plans the queue. The result consists of exact cubic segments; it is continuous up to the
/// acceleration (without a jerk limit: up to the velocity). Rules:
///
/// 1. A junction is passed exactly at the end position, with acceleration 0, at the velocity that
///    the mode requires. The velocity is lower in two cases. If the move before the junction is too
///    short, the junction velocity is the highest that this move can reach. If the moves after the
///    junction are too short, it is the highest from which all of them can keep their junction
///    velocities and the last one can stop. All moves of a batch are considered.
/// 2. The junction velocity is 0 if the next command reverses, covers no distance, or dwells. After
///    MoveVelocity and Halt the next command begins when they are done, in every mode.
/// 3. No move overshoots its end, except the first move of a batch, if the axis is too fast at the
///    beginning of the batch. If the following moves permit, the axis then passes the end faster
///    than planned. Otherwise it overshoots, returns, and begins the next move at rest.
/// 4. An aborting command begins with the position, velocity and acceleration at that moment. The
///    acceleration counts as 0 if the aborted motion has no jerk limit.
/// 5. Each command keeps its own dynamics, with two exceptions. A command that begins with a
///    velocity or acceleration above its limits returns inside them as fast as its dynamics permit.
///    A command that ends faster than its own velocity (modes blending_next, blending_high) speeds
///    up just before its end.
QueuedMotion queue(const QueueSpec& spec);

}  // namespace jounce
