// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "jounce/command/field.hpp"
#include "jounce/profiles/curve/modulo.hpp"
#include "jounce/profiles/sequences/queue.hpp"

/// The commands of an axis, after the function blocks of PLCopen: one struct a command, the same
/// from the program that sends it to the axis that executes it. command_table.hpp describes them.
namespace jounce {

/// A value that is not given: NaN. The axis uses its configured value.
inline constexpr double as_configured = std::numeric_limits<double>::quiet_NaN();

/// Dynamics of a command: magnitudes, > 0. The default of each is the limit of the axis. A command
/// sends the values that its `each_field` lists, and ignores the others: a halt has no velocity.
struct MoveDynamics {
  double velocity = as_configured;      ///< u/s
  double acceleration = as_configured;  ///< u/s^2, while it speeds up
  double deceleration = as_configured;  ///< u/s^2, while it slows down
  double jerk = as_configured;          ///< u/s^3
};

/// Start condition of an armed motion. The numbers are part of the wire format.
enum class StartAt : std::uint8_t {
  tick = 0,             ///< at a tick
  end_of_table = 1,     ///< at the end of the played table or of its pass, without a stop
  master_position = 2,  ///< when the master passes a position
};

/// Behavior of an axis if a cam with a live master ends at a velocity. The numbers are part of the
/// wire format.
enum class CamEnd : std::uint8_t {
  brake = 0,          ///< it comes to rest within its limits
  keep_velocity = 1,  ///< keeps that velocity, independent of the master, until another command
  extend = 2,         ///< the cam continues at the ratio of its end: the axis stays coupled
};

/// Kind of a command. The numbers are part of the record of a run: append new ones.
enum class CommandKind : std::uint8_t {
  none,
  enable,
  disable,
  arm,
  disarm,
  start,
  stop,
  abort,
  reset,
  set_position,
  home,
  hold,
  resume,
  override_,
  finish,
  move_absolute,
  move_relative,
  move_additive,
  move_superimposed,
  move_velocity,
  halt,
  gear_in,
  gear_out,
  cam_out,
  release,
  gear_in_pos,
  queue_switch,
  queue_clear,
  queue_end,
  start_table,
};
inline constexpr std::size_t command_kinds = 30;

}  // namespace jounce

/// The commands that a client sends. Units: u is the unit of the axis, m that of its master.
namespace jounce::command {

/// C is T, or const T.
template <class C, class T>
concept Of = std::same_as<std::remove_const_t<C>, T>;

/// The dynamics of a stop, of a change of velocity, and of a move.
template <Of<MoveDynamics> C, class F>
constexpr void each_field_of_stop(C& c, F f) {
  f(deceleration, c.deceleration);
  f(jerk, c.jerk);
}
template <Of<MoveDynamics> C, class F>
constexpr void each_field_of_ramp(C& c, F f) {
  f(acceleration, c.acceleration);
  each_field_of_stop(c, f);
}
template <Of<MoveDynamics> C, class F>
constexpr void each_field(C& c, F f) {
  f(velocity, c.velocity);
  each_field_of_ramp(c, f);
}

/// A command without fields.
template <class C, class F>
requires std::is_empty_v<C>
constexpr void each_field(C& /*c*/, F /*f*/) {}

struct Enable {
  static constexpr auto kind = CommandKind::enable;
};
struct Disable {
  static constexpr auto kind = CommandKind::disable;
};
/// Clears a fault.
struct Reset {
  static constexpr auto kind = CommandKind::reset;
};

/// Sets the present position, without motion.
struct SetPosition {
  static constexpr auto kind = CommandKind::set_position;
  double position = 0;    ///< u
  bool relative = false;  ///< adds it to the present position
};
template <Of<SetPosition> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"position", Quantity::position, FieldRange::finite, "VALUE"}, c.position);
  f(Field{"relative", Quantity::none, FieldRange::flag, "relative",
          "set-position: the value is an offset"},
    c.relative);
}

/// Searches for the home position. NaN, and method 0: as configured (HomingSpec).
struct Home {
  static constexpr auto kind = CommandKind::home;
  double offset = as_configured;           ///< u: the new position of the home position
  int method = 0;                          ///< method of CiA 402
  double search_velocity = as_configured;  ///< u/s, > 0
  double index_velocity = as_configured;   ///< u/s, > 0
  double acceleration = as_configured;     ///< u/s^2, > 0
  double timeout = as_configured;          ///< s, > 0
  double distance = as_configured;         ///< u, > 0
};
template <Of<Home> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"offset", Quantity::position, FieldRange::given, "offset",
          "home: the position value of the home position; default: [homing] of the spec of the "
          "axis. The same holds for the next options"},
    c.offset);
  f(Field{"method", Quantity::none, FieldRange::count, "method", "home: method of CiA 402"},
    c.method);
  f(Field{"search velocity", Quantity::velocity, FieldRange::positive, "search-velocity",
          "home: velocity of the search for a switch"},
    c.search_velocity);
  f(Field{"index velocity", Quantity::velocity, FieldRange::positive, "index-velocity",
          "home: velocity of the search for the edge of the switch and the index"},
    c.index_velocity);
  f(acceleration, c.acceleration);
  f(Field{"timeout", Quantity::time, FieldRange::positive, "timeout",
          "home: fault after this time"},
    c.timeout);
  f(Field{"distance", Quantity::position, FieldRange::positive, "distance",
          "home: fault if one search is longer than this"},
    c.distance);
}

/// Brings a path or a planned move to rest; it waits there.
struct Hold {
  static constexpr auto kind = CommandKind::hold;
};
/// Ends the hold.
struct Resume {
  static constexpr auto kind = CommandKind::resume;
};
/// Multiplies the speed from now on.
struct Override {
  static constexpr auto kind = CommandKind::override_;
  double factor = 1;  ///< 0 to 2
};
template <Of<Override> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"factor", Quantity::none, FieldRange::factor, "VALUE"}, c.factor);
}

struct MoveAbsolute {
  static constexpr auto kind = CommandKind::move_absolute;
  double position = 0;  ///< u
  MoveDynamics dynamics = {};
  Direction direction = Direction::shortest;  ///< for a modulo axis
  BufferMode buffer = BufferMode::aborting;   ///< start relative to the previous motion
};
template <Of<MoveAbsolute> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"position", Quantity::position, FieldRange::finite, "to", "Move to this position"},
    c.position);
  each_field(c.dynamics, f);
  f(Field{"direction", Quantity::none, FieldRange::direction, "direction",
          "Direction of a rotary axis with --to: shortest, positive, negative"},
    c.direction);
  f(buffer_mode, c.buffer);
}

/// Moves by a distance from the present setpoint.
struct MoveRelative {
  static constexpr auto kind = CommandKind::move_relative;
  double distance = 0;  ///< u
  MoveDynamics dynamics = {};
  BufferMode buffer = BufferMode::aborting;
};
template <Of<MoveRelative> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, FieldRange::finite, "by",
          "Move by this distance from the commanded position"},
    c.distance);
  each_field(c.dynamics, f);
  f(buffer_mode, c.buffer);
}

/// Moves by a distance from the target of the present move.
struct MoveAdditive {
  static constexpr auto kind = CommandKind::move_additive;
  double distance = 0;  ///< u
  MoveDynamics dynamics = {};
};
template <Of<MoveAdditive> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, FieldRange::finite, "add",
          "Move by this distance from the end position of the present motion"},
    c.distance);
  each_field(c.dynamics, f);
}

/// Moves by a distance on top of the present motion.
struct MoveSuperimposed {
  static constexpr auto kind = CommandKind::move_superimposed;
  double distance = 0;         ///< u
  MoveDynamics dynamics = {};  ///< its velocity is added to that of the motion
};
template <Of<MoveSuperimposed> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, FieldRange::finite, "on-top",
          "Move by this distance on top of the present motion"},
    c.distance);
  f(Field{"velocity difference", velocity.quantity, velocity.range, velocity.option, velocity.help},
    c.dynamics.velocity);
  each_field_of_ramp(c.dynamics, f);
}

/// Moves at a velocity, until the next command.
struct MoveVelocity {
  static constexpr auto kind = CommandKind::move_velocity;
  double velocity = 0;         ///< u/s, signed; 0: to rest
  MoveDynamics dynamics = {};  ///< without velocity
  BufferMode buffer = BufferMode::aborting;
  bool hold_to_run = false;  ///< the motion stops unless its session sends heartbeats
};
template <Of<MoveVelocity> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"velocity", Quantity::velocity, FieldRange::finite, "VALUE"}, c.velocity);
  each_field_of_ramp(c.dynamics, f);
  f(buffer_mode, c.buffer);
  f(Field{"hold to run", Quantity::none, FieldRange::flag, "hold-to-run",
          "jog only while this command runs: the axis stops when it ends, or sends no heartbeat "
          "for 0.2 s"},
    c.hold_to_run);
}

/// Brings the axis to rest. Any command may follow at once.
struct Halt {
  static constexpr auto kind = CommandKind::halt;
  MoveDynamics dynamics = {};  ///< deceleration and jerk
};
template <Of<Halt> C, class F>
constexpr void each_field(C& c, F f) {
  each_field_of_stop(c.dynamics, f);
}

/// Couples the axis to its live master by a ratio, now, during any motion.
struct GearIn {
  static constexpr auto kind = CommandKind::gear_in;
  std::int32_t numerator = 0;
  std::int32_t denominator = 0;
  MoveDynamics dynamics = {};  ///< without velocity
};
template <Of<GearIn> C, class F>
constexpr void each_field(C& c, F f) {
  f(numerator, c.numerator);
  f(denominator, c.denominator);
  each_field_of_ramp(c.dynamics, f);
}

/// The same with a position at which both run in step.
struct GearInPos {
  static constexpr auto kind = CommandKind::gear_in_pos;
  std::int32_t numerator = 0;
  std::int32_t denominator = 0;
  double master_sync_position = 0;   ///< m
  double slave_sync_position = 0;    ///< u
  double master_start_distance = 0;  ///< m
  bool avoid_reversal = false;
};
template <Of<GearInPos> C, class F>
constexpr void each_field(C& c, F f) {
  f(numerator, c.numerator);
  f(denominator, c.denominator);
  f(Field{"master sync position", Quantity::master, FieldRange::finite, "master-sync",
          "gear-in-pos: master position from which both run in step"},
    c.master_sync_position);
  f(Field{"slave sync position", Quantity::position, FieldRange::finite, "slave-sync",
          "gear-in-pos: position of the axis there"},
    c.slave_sync_position);
  f(Field{"master start distance", Quantity::master, FieldRange::finite, "start-distance",
          "gear-in-pos: master distance before it, in which the axis engages"},
    c.master_start_distance);
  f(Field{"avoid reversal", Quantity::none, FieldRange::flag, "avoid-reversal",
          "gear-in-pos: reject a motion against the direction of the gear"},
    c.avoid_reversal);
}

/// Leaves the gear; the velocity stays.
struct GearOut {
  static constexpr auto kind = CommandKind::gear_out;
};
/// Leaves the cam; the velocity stays.
struct CamOut {
  static constexpr auto kind = CommandKind::cam_out;
};

/// The other bank of a static queue continues at the end of this one.
struct QueueSwitch {
  static constexpr auto kind = CommandKind::queue_switch;
  std::uint32_t queue = 0;
  std::uint8_t bank = 0;
};
template <Of<QueueSwitch> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
  f(bank, c.bank);
}

/// Empties a bank that does not play.
struct QueueClear {
  static constexpr auto kind = CommandKind::queue_clear;
  std::uint32_t queue = 0;
  std::uint8_t bank = 0;
  std::uint32_t seq = 0;  ///< number from which its messages count again
};
template <Of<QueueClear> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
  f(bank, c.bank);
  f(Field{"seq", Quantity::none, FieldRange::count}, c.seq);
}

/// No more rows follow: the last one ends the stream.
struct QueueEnd {
  static constexpr auto kind = CommandKind::queue_end;
  std::uint32_t queue = 0;
};
template <Of<QueueEnd> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
}

/// Plays the table of the axis (a virtual master) from its beginning.
struct StartTable {
  static constexpr auto kind = CommandKind::start_table;
};

}  // namespace jounce::command

namespace jounce {

/// A variant with further alternatives.
template <class Variant, class... More>
struct Extended;
template <class... Commands, class... More>
struct Extended<std::variant<Commands...>, More...> {
  using type = std::variant<Commands..., More...>;
  /// The same with `More` first.
  using after = std::variant<More..., Commands...>;
};

/// The commands that an axis executes as a client sends them.
using SharedCommand =
    std::variant<command::Enable, command::Disable, command::Reset, command::SetPosition,
                 command::Home, command::Hold, command::Resume, command::Override,
                 command::MoveAbsolute, command::MoveRelative, command::MoveAdditive,
                 command::MoveSuperimposed, command::MoveVelocity, command::Halt, command::GearOut,
                 command::CamOut>;

/// A command that a client sends to an axis.
///
///     ClientCommand move = command::MoveAbsolute{.position = 120, .dynamics = {.velocity = 200}};
using ClientCommand =
    Extended<SharedCommand, command::GearIn, command::GearInPos, command::QueueSwitch,
             command::QueueClear, command::QueueEnd, command::StartTable>::type;
static_assert(std::is_trivially_copyable_v<ClientCommand>);

/// Kind of a command: of a ClientCommand, or of another variant of commands.
template <class... Commands>
CommandKind kind_of(const std::variant<Commands...>& command) {
  return std::visit([](const auto& each) { return each.kind; }, command);
}

/// The command of a kind with the defaults of its fields; nullopt: the variant has none of it.
template <class Commands>
std::optional<Commands> made(CommandKind kind) {
  std::optional<Commands> command;
  const auto make = [&]<std::size_t... I>(std::index_sequence<I...> /*all*/) {
    ((std::variant_alternative_t<I, Commands>::kind == kind
          ? void(command = std::variant_alternative_t<I, Commands>{})
          : void()),
     ...);
  };
  make(std::make_index_sequence<std::variant_size_v<Commands>>{});
  return command;
}

/// True if the motion runs only while its session sends heartbeats: a hold-to-run jog.
inline bool holds_to_run(const ClientCommand& command) {
  const auto* const jog = std::get_if<command::MoveVelocity>(&command);
  return jog != nullptr && jog->hold_to_run;
}

/// The fields of a command, in the order of the wire.
template <class C>
constexpr Fields fields_of() {
  Fields all;
  C command{};
  command::each_field(
      command, [&](const Field& field, const auto& /*member*/) { all.field[all.count++] = field; });
  return all;
}

}  // namespace jounce
