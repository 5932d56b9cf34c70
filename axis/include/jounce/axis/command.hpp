// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "jounce/axis/movement.hpp"
#include "jounce/command/commands.hpp"

/// The commands that the executor sends to an axis on behalf of a client's message.
namespace jounce::command {

struct None {
  static constexpr auto kind = CommandKind::none;
};
/// Arms a motion; replaces an armed one.
struct Arm {
  static constexpr auto kind = CommandKind::arm;
  Movement* movement = nullptr;  ///< must live until the axis returns it
  std::int64_t group = 0;        ///< its motions start and stop together; 0: none
};
/// Disarms the armed motion, unless its start was accepted.
struct Disarm {
  static constexpr auto kind = CommandKind::disarm;
};
/// Starts the armed motion.
struct Start {
  static constexpr auto kind = CommandKind::start;
  StartAt when = StartAt::tick;
  std::int64_t tick = -1;  ///< for StartAt::tick; -1: at once
  double position = 0;     ///< m, for StartAt::master_position
  std::int64_t group = 0;  ///< that of the arm
};
/// Brings the axis to rest, on its path if it has one, and disarms. Only a fault interrupts this.
struct Stop {
  static constexpr auto kind = CommandKind::stop;
  MoveDynamics dynamics = {};  ///< deceleration and jerk
};
/// Stops at once and sets a fault.
struct Abort {
  static constexpr auto kind = CommandKind::abort;
};
/// Ends a repeating table at the end of its present pass (Agito StopRep).
struct Finish {
  static constexpr auto kind = CommandKind::finish;
};
/// Starts a live movement during any motion: that of a GearIn or GearInPos.
struct Couple {
  static constexpr auto kind = CommandKind::gear_in;
  Movement* movement = nullptr;  ///< must live until the axis returns it
  std::int64_t tick = -1;        ///< -1: at once
};
/// Like Stop: end of a hold-to-run jog.
struct Release {
  static constexpr auto kind = CommandKind::release;
};

}  // namespace jounce::command

namespace jounce {

/// The commands that an axis executes.
using AxisCommand = Extended<SharedCommand, command::None, command::Arm, command::Disarm,
                             command::Start, command::Stop, command::Abort, command::Finish,
                             command::Couple, command::Release>::after;
static_assert(std::is_trivially_copyable_v<AxisCommand>);

/// The movement of an arm or of a coupling; null: none.
inline Movement* movement_of(const AxisCommand& command) {
  return std::visit(
      [](const auto& each) -> Movement* {
        if constexpr (requires { each.movement; }) return each.movement;
        return nullptr;
      },
      command);
}

/// Has no effect on a command without a movement.
inline void set_movement(AxisCommand& command, Movement* movement) {
  std::visit(
      [&](auto& each) {
        if constexpr (requires { each.movement; }) each.movement = movement;
      },
      command);
}

/// A command to an axis, at most one in each tick. If several arrive for a tick, the last one takes
/// effect.
///
///     axis.step(0, {command::Enable{}});
///     axis.step(1, {.what = command::MoveAbsolute{.position = 120}, .at = 50});
struct Command {
  AxisCommand what = {};
  std::int64_t at = -1;  ///< tick; -1: at once, the only value for an arm, a start and a coupling
  std::uint64_t id = 0;  ///< id that the sender gave to the command; returned with the answer

  [[nodiscard]] CommandKind kind() const { return kind_of(what); }
};

}  // namespace jounce
