// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "jounce/axis/movement.hpp"
#include "jounce/command/commands.hpp"

/// The commands that only the executor sends to an axis. The executor sends each of them to carry
/// out a message of a client.
namespace jounce::command {

/// No command in this tick.
struct None {
  static constexpr auto kind = CommandKind::none;
};
/// Arms a movement, in place of the armed one.
struct Arm {
  static constexpr auto kind = CommandKind::arm;
  Movement* movement = nullptr;  ///< must live until the axis returns it
  /// Number of its group: the motions of a group start and stop together; 0: none.
  std::int64_t group = 0;
};
/// Disarms the armed movement, unless its start was accepted.
struct Disarm {
  static constexpr auto kind = CommandKind::disarm;
};
/// Starts the armed movement.
struct Start {
  static constexpr auto kind = CommandKind::start;
  StartAt when = StartAt::tick;  ///< condition of the start
  std::int64_t tick = -1;        ///< tick of the start, for StartAt::tick; -1: at once
  /// Master position of the start, m (unit of the master), for StartAt::master_position.
  double position = 0;
  std::int64_t group = 0;  ///< group of the armed movement
};
/// Brings the axis to rest, on its path if it has one, and disarms. Only a fault interrupts a stop.
struct Stop {
  static constexpr auto kind = CommandKind::stop;
  MoveDynamics dynamics = {};  ///< deceleration and jerk
};
/// Stops at once and sets a fault.
struct Abort {
  static constexpr auto kind = CommandKind::abort;
};
/// Starts a live movement without arming it first, even in motion: the executor's form of GearIn,
/// GearInPos and CombineAxes.
struct Couple {
  static constexpr auto kind = CommandKind::gear_in;
  Movement* movement = nullptr;  ///< must live until the axis returns it
  std::int64_t tick = -1;        ///< tick of the start; -1: at once
};
/// Stops the axis like Stop, at the end of a hold-to-run jog.
struct Release {
  static constexpr auto kind = CommandKind::release;
};

/// Replaces the path of a group by a path that equals the present one up to the path time `until`,
/// and continues beyond it. The motion of the group does not change at the replacement. Rejected if
/// the group has passed `until`.
struct Extend {
  static constexpr auto kind = CommandKind::extend;
  Movement* movement = nullptr;  ///< must live until the axis returns it
  /// Length along the present path at which the new path begins, in the unit of the path.
  double position = 0;
  double shift = 0;  ///< time of the present path at which the new path begins, s
  double until = 0;  ///< time of the present path up to which both paths are equal, s
};

}  // namespace jounce::command

namespace jounce {

/// The commands that an axis executes.
using AxisCommand = Extended<SharedCommand, command::None, command::Arm, command::Disarm,
                             command::Start, command::Stop, command::Abort, command::Couple,
                             command::Release, command::Extend>::after;
static_assert(std::is_trivially_copyable_v<AxisCommand>);

/// Returns the movement of an Arm, a Couple or an Extend; null for other commands.
inline Movement* movement_of(const AxisCommand& command) {
  return std::visit(
      [](const auto& each) -> Movement* {
        if constexpr (requires { each.movement; }) return each.movement;
        return nullptr;
      },
      command);
}

/// Sets the movement of an Arm, a Couple or an Extend. Has no effect on other commands.
inline void set_movement(AxisCommand& command, Movement* movement) {
  std::visit(
      [&](auto& each) {
        if constexpr (requires { each.movement; }) each.movement = movement;
      },
      command);
}

/// A command to an axis. An axis executes at most one command in each tick: of several commands for
/// the same tick, only the last one takes effect.
///
///     axis.step(0, {command::Enable{}});
///     axis.step(1, {.what = command::MoveAbsolute{.position = 120}, .at = 50});
struct Command {
  AxisCommand what = {};  ///< the command
  std::int64_t at = -1;   ///< tick of the execution; -1: at once. Arm, Start and Couple require -1
  std::uint64_t id = 0;   ///< id that the sender gave to the command; the answer repeats it

  /// Kind of the command.
  [[nodiscard]] CommandKind kind() const { return kind_of(what); }
};

}  // namespace jounce
