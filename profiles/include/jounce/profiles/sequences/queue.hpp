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

/// A queue of single-axis commands, planned as one motion, like a controller's command buffer with
/// buffered, blended and aborting moves (PLCopen motion control part 1; PMC600 manual 7.1, Table
/// 7.1; HIMC HMPL manual 8.1.4).
///
///     const Dynamics slow{.velocity = 5, .acceleration = 10};
///     const Dynamics fast{.velocity = 20, .acceleration = 20};
///     const QueuedMotion motion = queue({.commands = {
///         {MoveAbsolute{10}, slow},
///         {MoveAbsolute{50}, fast, BufferMode::blending_low}}});
///     motion.commands[0].reached;        // 5: the velocity at 10, passed without stopping
///
/// **Vocabulary.** A *junction* is the transition from one command to the next: at the end position
/// of a position move, with acceleration 0, at the *junction velocity*. A *batch* contains the
/// commands known at the start of planning: an aborting command and all that follow up to the next
/// aborting one.
///
/// **Units.** u for the axis' unit: u, u/s, u/s^2, u/s^3; times in s from the start of the queue.
///
/// **Throws** InputError for bad input (the key counts commands from 1), which includes magnitudes
/// greater than 1e30 and limits less than 1e-30, for a queue without duration, and for a command
/// that would begin in a state beyond the range of move_to(); every other queue has a motion.

/// Start mode after the command before; the numbers are those of the controllers.
enum class BufferMode : std::uint8_t {
  aborting = 0,           ///< at once, when it is issued: the running and all waiting ones end
  buffered = 1,           ///< when the one before is done: at rest, or in velocity
  blending_low = 2,       ///< at its end position with the lower of the two command velocities
  blending_previous = 3,  ///< velocity of the command before
  blending_next = 4,      ///< its own velocity
  blending_high = 5,      ///< the higher of the two
};

/// MC_MoveAbsolute: to a position, u.
struct MoveAbsolute {
  double position = 0;
};

/// MC_MoveRelative: by a distance, u, from the start of the command: the target of the one before,
/// or after an abort the position at that moment (PMC600 manual 5.2.2).
struct MoveRelative {
  double distance = 0;
};

/// MC_MoveVelocity: to the velocity of its dynamics; done once that is reached.
struct MoveVelocity {
  int direction = 1;  ///< 1 or -1
};

/// MC_Halt: to rest, wherever that is; done once it is reached.
struct Halt {};

/// Keeps on for a time as the command before ended: at rest, or (after MoveVelocity) in velocity.
struct Dwell {
  double time = 0;  ///< s, >= 0; any, not a multiple of a cycle (PMC600 manual 7.2.6, GroupWait)
};

using MotionCommand = std::variant<MoveAbsolute, MoveRelative, MoveVelocity, Halt, Dwell>;

struct QueuedCommand {
  MotionCommand command;
  /// Not used by Dwell; Halt does not use the velocity. In both directions, `acceleration` holds
  /// while the axis speeds up and `deceleration` while it slows down. If the two differ, a motion
  /// that has to reverse (after an abort) stops first, then moves back, like with_target(). There
  /// is one jerk: deceleration_jerk must be 0 or equal to it.
  Dynamics dynamics = {};
  BufferMode mode = BufferMode::buffered;  ///< mode of the first command: not used
  /// s, >= 0, ascending; only for an aborting command, which must have it unless it is the first.
  std::optional<double> issued = {};
};

struct QueueSpec {
  MotionState start = {};  ///< acceleration must be 0 if the first command is a Dwell or waits
  std::vector<QueuedCommand> commands;
};

enum class CommandState : std::uint8_t {
  done,     ///< reached its target or velocity
  aborted,  ///< CommandAborted, while running or (then end == begin) before it began
};

/// Outcome of a command. All with the sign of the axis.
struct CommandRecord {
  double begin = 0;    ///< s
  double end = 0;      ///< s; both are breaks of the trajectory
  double target = 0;   ///< u; its end, or for an aborted command its intended end
  double planned = 0;  ///< u/s, the junction velocity that the next command's mode asks for
  double reached = 0;  ///< u/s, at `end`
  CommandState state = CommandState::done;
};

struct QueuedMotion {
  Trajectory trajectory;  ///< from 0; holds outside if it is at rest there, otherwise refuses
  std::vector<CommandRecord> commands;
  MotionState end;
};

/// Plans the queue. Exact cubic segments, continuous up to acceleration (without a jerk limit: up to
/// velocity). Rules:
///
/// 1. A junction is passed exactly at the end position, with acceleration 0, at exactly the velocity
/// that the mode requires; or, if the move before is too short, the highest that it can reach; or,
/// if the moves after it are too short, the highest from which they all can keep theirs and the
/// last can stop. All moves of a batch are considered.
/// 2. It is 0 if the next move reverses, covers no distance, or dwells; after MoveVelocity and
///    Halt the next command begins when they are done, in every mode.
/// 3. No move overshoots its end, except a batch's first that is too fast for it when it begins. It
///    passes the end faster than planned if the moves after it can cope, otherwise it overshoots,
///    returns, and hands over at rest.
/// 4. An abort takes position, velocity and acceleration over; the acceleration counts as 0 if
///    the aborted motion has no jerk limit.
/// 5. Each command keeps its dynamics, except that one which begins faster (or under a greater
///    acceleration) than it permits is brought inside as fast as it permits, and that one which hands
///    over at more than its own velocity (next, high) speeds up to it just before its end.
QueuedMotion queue(const QueueSpec& spec);

}  // namespace jounce
