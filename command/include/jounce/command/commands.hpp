// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
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

/// The commands of an axis and of a group, modeled on the function blocks of PLCopen. Each command
/// is one struct: the client that sends the command and the axis that executes it use the same
/// struct. docs/executor/orders.md describes the commands. u is the unit of the axis, m the unit of its
/// master.
namespace jounce {

/// Value of a field that the sender does not give: the axis uses its configured value. It is a NaN
/// whose bits spell "Jounce", so that a client can reject the NaN of an invalid computation.
inline constexpr double as_configured =
    std::bit_cast<double>(std::uint64_t{0x7ff8'0000'0000'0000} | 0x4a6f'756e'6365);

/// True for as_configured, also after a multiplication by the factor of a unit; false for any other
/// NaN, such as 0.0 / 0.0.
inline bool is_as_configured(double value) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return (std::bit_cast<std::uint64_t>(value) & ~sign) ==
         std::bit_cast<std::uint64_t>(as_configured);
}

/// Dynamics of a move: magnitudes, > 0. A value that is not given is the limit of the axis.
struct MoveDynamics {
  double velocity = as_configured;      ///< velocity, u/s
  double acceleration = as_configured;  ///< acceleration while the axis speeds up, u/s^2
  /// Deceleration while the axis slows down, u/s^2; an axis that must reverse brakes with
  /// `acceleration`.
  double deceleration = as_configured;
  double jerk = as_configured;  ///< jerk, u/s^3
};

/// Start condition of an armed motion. The numbers are part of the wire format.
enum class StartAt : std::uint8_t {
  tick = 0,  ///< at a given tick
  /// At the end of the present table, or of its present pass if it repeats. The axis does not stop
  /// in between.
  end_of_table = 1,
  master_position = 2,  ///< when the master passes a given position
};

/// Behavior of an axis when a cam on a live master ends at a nonzero velocity. The numbers are part
/// of the wire format.
enum class CamEnd : std::uint8_t {
  brake = 0,          ///< comes to rest within the limits of the axis
  keep_velocity = 1,  ///< keeps the velocity, independent of the master, until another command
  extend = 2,         ///< continues at the cam's final ratio: the axis stays coupled
};

/// Buffer mode of a command of a group (PLCopen part 4): when the command begins, relative to the
/// previous one, and at which velocity the group passes from the previous command to this one. The
/// numbers are part of the wire format.
enum class PathBuffer : std::uint8_t {
  aborting = 0,           ///< at once: the group comes to rest on its path and drops its commands
  buffered = 1,           ///< at rest, at the end of the previous command
  blending_low = 2,       ///< at most at the lower velocity of the two commands
  blending_previous = 3,  ///< at most at the velocity of the previous command
  blending_next = 4,      ///< at most at the velocity of the new command
  blending_high = 5,      ///< at most at the higher velocity of the two commands
  look_ahead = 6,         ///< at the highest velocity within the limits
};

/// Edge of a trigger input that a touch probe captures. The numbers are part of the wire format.
enum class ProbeEdge : std::uint8_t { rising = 0, falling = 1, both = 2 };

/// Numbers of the inputs of a touch probe: 1 to 4 are the trigger inputs of the drive.
inline constexpr int home_switch_input = 5;
inline constexpr int index_input = 6;
inline constexpr int probe_inputs = 6;  ///< number of inputs

/// Kind of a command. The numbers are part of the record of an executor: append new ones at the
/// end.
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
  extend,
  move_linear_absolute,
  move_linear_relative,
  move_circular_absolute,
  move_circular_relative,
  move_direct_absolute,
  move_direct_relative,
  group_wait,
  group_jog,
  phasing_absolute,
  phasing_relative,
  combine_axes,
  change_velocity,
  move_repetitive,
  cut,
  park,
  touch_probe,
  abort_trigger,
  enable_compensation,
  disable_compensation,
  set_coordinate_transform,
  group_set_position,
  group_set_limits,
  group_m_word,
  group_set_override,
  group_acknowledge,
  group_single_step,
};
inline constexpr std::size_t command_kinds = 57;  ///< number of kinds

}  // namespace jounce

/// The commands that a client sends, and their fields.
namespace jounce::command {

/// True if C is T or const T.
template <class C, class T>
concept Of = std::same_as<std::remove_const_t<C>, T>;

/// Calls f(field, member) for each of the dynamics that a stop, a change of velocity (ramp), or a
/// move uses.
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

/// A command without fields: does not call f.
template <class C, class F>
requires std::is_empty_v<C>
constexpr void each_field(C& /*c*/, F /*f*/) {}

/// Enables the axis: its drive follows the setpoints.
struct Enable {
  static constexpr auto kind = CommandKind::enable;
};
/// Disables the axis. In motion, this is a fault.
struct Disable {
  static constexpr auto kind = CommandKind::disable;
};
/// Clears a fault.
struct Reset {
  static constexpr auto kind = CommandKind::reset;
};

/// Assigns a new value to the present position, without motion.
struct SetPosition {
  static constexpr auto kind = CommandKind::set_position;
  double position = 0;    ///< new position, u; or the offset to add, see relative
  bool relative = false;  ///< true: adds `position` to the present position
};
template <Of<SetPosition> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"position", Quantity::position, ranges::finite}, c.position);
  f(Field{"relative", Quantity::none, ranges::flag}, c.relative);
}

/// Searches for the home position. For a value that is not given (NaN; for the method, 0), the axis
/// uses the value in HomingSpec.
struct Home {
  static constexpr auto kind = CommandKind::home;
  static constexpr int without_motion = 37;  ///< method: home is the present position
  double offset = as_configured;             ///< position value of the axis at the home position, u
  int method = 0;                            ///< homing method of CiA 402 (object 6098h)
  double search_velocity = as_configured;    ///< velocity of the search for a switch, u/s, > 0
  double index_velocity = as_configured;     ///< velocity for the edge and the index, u/s, > 0
  double acceleration = as_configured;       ///< acceleration, u/s^2, > 0
  double timeout = as_configured;            ///< time limit of the whole homing, s, > 0
  double distance = as_configured;           ///< greatest length of each search, u, > 0
};
template <Of<Home> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"offset", Quantity::position, ranges::given}, c.offset);
  f(Field{"method", Quantity::none, ranges::count}, c.method);
  f(Field{"search velocity", Quantity::velocity, ranges::positive}, c.search_velocity);
  f(Field{"index velocity", Quantity::velocity, ranges::positive}, c.index_velocity);
  f(acceleration, c.acceleration);
  f(Field{"timeout", Quantity::time, ranges::positive}, c.timeout);
  f(Field{"distance", Quantity::position, ranges::positive}, c.distance);
}

/// Brings a path or a planned move to rest until the command Resume.
struct Hold {
  static constexpr auto kind = CommandKind::hold;
};
/// Continues a motion that Hold brought to rest.
struct Resume {
  static constexpr auto kind = CommandKind::resume;
};
/// Multiplies the speed of the axis by a factor, from now on.
struct Override {
  static constexpr auto kind = CommandKind::override_;
  double factor = 1;  ///< 0 to 2; below 1: slower
};
template <Of<Override> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"factor", Quantity::none, ranges::factor}, c.factor);
}

/// Moves to a position.
struct MoveAbsolute {
  static constexpr auto kind = CommandKind::move_absolute;
  double position = 0;  ///< target, u
  /// Velocity, acceleration, deceleration and jerk of the move.
  MoveDynamics dynamics = {};
  /// Direction on a modulo axis. On a linear axis, positive and negative require a target on that
  /// side.
  Direction direction = Direction::shortest;
  /// When the move begins, relative to the previous motion.
  BufferMode buffer = BufferMode::aborting;
};
template <Of<MoveAbsolute> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"position", Quantity::position, ranges::finite}, c.position);
  each_field(c.dynamics, f);
  f(Field{"direction", Quantity::none, ranges::direction}, c.direction);
  f(buffer_mode, c.buffer);
}

/// Moves by a distance from the present commanded position.
struct MoveRelative {
  static constexpr auto kind = CommandKind::move_relative;
  double distance = 0;  ///< signed distance, u
  MoveDynamics dynamics = {};
  BufferMode buffer = BufferMode::aborting;
};
template <Of<MoveRelative> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, ranges::finite}, c.distance);
  each_field(c.dynamics, f);
  f(buffer_mode, c.buffer);
}

/// Moves by a distance from the target of the present move.
struct MoveAdditive {
  static constexpr auto kind = CommandKind::move_additive;
  double distance = 0;  ///< signed distance, u
  MoveDynamics dynamics = {};
};
template <Of<MoveAdditive> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, ranges::finite}, c.distance);
  each_field(c.dynamics, f);
}

/// Moves by a distance in addition to the present motion.
struct MoveSuperimposed {
  static constexpr auto kind = CommandKind::move_superimposed;
  double distance = 0;  ///< signed distance, u
  /// Dynamics of the added move alone: its velocity is added to the velocity of the motion.
  MoveDynamics dynamics = {};
};
template <Of<MoveSuperimposed> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, ranges::finite}, c.distance);
  f(Field{"velocity difference", velocity.quantity, velocity.range}, c.dynamics.velocity);
  each_field_of_ramp(c.dynamics, f);
}

/// Moves at a given velocity until the next command.
struct MoveVelocity {
  static constexpr auto kind = CommandKind::move_velocity;
  double velocity = 0;         ///< u/s, signed; 0: to rest
  MoveDynamics dynamics = {};  ///< the member `velocity` is not used
  BufferMode buffer = BufferMode::aborting;
  /// True: the axis stops if its sender is silent for the hold timeout of the executor, by default
  /// 0.2 s.
  bool hold_to_run = false;
};
template <Of<MoveVelocity> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"velocity", Quantity::velocity, ranges::finite}, c.velocity);
  each_field_of_ramp(c.dynamics, f);
  f(buffer_mode, c.buffer);
  f(hold_to_run, c.hold_to_run);
}

/// Moves between the present position and `position`, again and again (MotionMode 2 of Agito). Ends
/// with a Finish, a stop or another motion, or after a number of strokes.
struct MoveRepetitive {
  static constexpr auto kind = CommandKind::move_repetitive;
  double position = 0;         ///< the other end of the strokes, u
  MoveDynamics dynamics = {};  ///< dynamics of each stroke
  double wait = 0;             ///< rest between two strokes (RptWait of Agito), s
  std::int32_t strokes = 0;    ///< number of strokes, each from one end to the other; 0: no limit
};
template <Of<MoveRepetitive> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"position", Quantity::position, ranges::finite}, c.position);
  each_field(c.dynamics, f);
  f(Field{"wait", Quantity::time, ranges::not_negative}, c.wait);
  f(Field{"strokes", Quantity::none, ranges::count}, c.strokes);
}

/// Finishes the present stroke of a repetitive move, or the present pass of a table that repeats.
/// The axis then rests (StopRep of Agito).
struct Finish {
  static constexpr auto kind = CommandKind::finish;
};

/// Changes the velocity of the present move. The move keeps its target, or its direction. The
/// change takes effect at once, or when the axis passes a position (SpeedChgPos, SpeedChgNew and
/// SpeedChgDir of Agito).
struct ChangeVelocity {
  static constexpr auto kind = CommandKind::change_velocity;
  double velocity = as_configured;  ///< new velocity: a magnitude, u/s; must be given
  double position = as_configured;  ///< position of the change, u; NaN: at once
  /// positive or negative: only if the axis passes the position in this direction; shortest: in
  /// either direction.
  Direction direction = Direction::shortest;
};
template <Of<ChangeVelocity> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"velocity", Quantity::velocity, ranges::positive}, c.velocity);
  f(Field{"position", Quantity::position, ranges::given}, c.position);
  f(Field{"direction", Quantity::none, ranges::direction}, c.direction);
}

/// Brings the axis to rest. Any other motion can interrupt a halt at once, unlike a stop.
struct Halt {
  static constexpr auto kind = CommandKind::halt;
  MoveDynamics dynamics = {};  ///< deceleration and jerk
};
template <Of<Halt> C, class F>
constexpr void each_field(C& c, F f) {
  each_field_of_stop(c.dynamics, f);
}

/// Couples the axis to its live master at a ratio, at once, even while the axis moves.
struct GearIn {
  static constexpr auto kind = CommandKind::gear_in;
  std::int32_t numerator = 0;  ///< ratio = numerator / denominator; the denominator must not be 0
  std::int32_t denominator = 0;
  MoveDynamics dynamics = {};  ///< the member `velocity` is not used
  /// Travel of the master during which the ratio changes, m (masterSlope of Googol); 0: a ramp over
  /// time, by `dynamics`.
  double clutch = 0;
};
template <Of<GearIn> C, class F>
constexpr void each_field(C& c, F f) {
  f(numerator, c.numerator);
  f(denominator, c.denominator);
  each_field_of_ramp(c.dynamics, f);
  f(Field{"clutch", Quantity::master, ranges::not_negative}, c.clutch);
}

/// Couples the axis to its live master at a ratio. From the instant at which the master reaches
/// `master_sync_position` and the axis `slave_sync_position`, the axis is in step with the master.
struct GearInPos {
  static constexpr auto kind = CommandKind::gear_in_pos;
  std::int32_t numerator = 0;  ///< ratio = numerator / denominator; the denominator must not be 0
  std::int32_t denominator = 0;
  double master_sync_position = 0;  ///< master position at which the axis is in step, m
  double slave_sync_position = 0;   ///< position of the axis at this master position, u
  /// Travel of the master before the sync position, m; the axis engages during this travel.
  double master_start_distance = 0;
  bool avoid_reversal = false;  ///< true: reject a motion against the direction of the gear
};
template <Of<GearInPos> C, class F>
constexpr void each_field(C& c, F f) {
  f(numerator, c.numerator);
  f(denominator, c.denominator);
  f(Field{"master sync position", Quantity::master, ranges::finite}, c.master_sync_position);
  f(Field{"slave sync position", Quantity::position, ranges::finite}, c.slave_sync_position);
  f(Field{"master start distance", Quantity::master, ranges::nonzero}, c.master_start_distance);
  f(Field{"avoid reversal", Quantity::none, ranges::flag}, c.avoid_reversal);
}

/// Couples the axis to the sum of its two live masters, each at a ratio (MC_CombineAxes): the axis
/// moves by numerator / denominator for each m of its master, plus second_numerator /
/// second_denominator for each m of its second master. A negative ratio subtracts. The axis engages
/// as with GearIn.
struct CombineAxes {
  static constexpr auto kind = CommandKind::combine_axes;
  std::int32_t numerator = 0;           ///< ratio to the master = numerator / denominator
  std::int32_t denominator = 0;         ///< must not be 0
  std::int32_t second_numerator = 0;    ///< ratio to the second master = second_numerator /
                                        ///< second_denominator
  std::int32_t second_denominator = 0;  ///< must not be 0
  MoveDynamics dynamics = {};           ///< the member `velocity` is not used
};
template <Of<CombineAxes> C, class F>
constexpr void each_field(C& c, F f) {
  f(numerator, c.numerator);
  f(denominator, c.denominator);
  f(Field{"numerator of the second master", Quantity::none, ranges::whole}, c.second_numerator);
  f(Field{"denominator of the second master", Quantity::none, ranges::whole_nonzero},
    c.second_denominator);
  each_field_of_ramp(c.dynamics, f);
}

/// Shifts the position of the live master, as the axis sees it: the axis moves ahead of its master
/// or behind it, and stays coupled (MC_PhasingAbsolute, MC_PhasingRelative). A phase shift counts
/// from the beginning of the coupling. `dynamics` apply to the shift, in units of the master. The
/// limits of the axis determine each value that is not given.
template <bool relative_>
struct Phasing {
  static constexpr bool relative = relative_;
  static constexpr auto kind =
      relative ? CommandKind::phasing_relative : CommandKind::phasing_absolute;
  double shift = 0;  ///< phase shift after the command, or its change, m
  MoveDynamics dynamics = {};
};
using PhasingAbsolute = Phasing<false>;
using PhasingRelative = Phasing<true>;
template <class C, class F>
requires(Of<C, PhasingAbsolute> || Of<C, PhasingRelative>)  //
    constexpr void each_field(C& c, F f) {
  const auto as_of_master = [](Field field, Quantity quantity) {
    field.quantity = quantity;
    return field;
  };
  f(C::relative ? Field{"change of the phase shift", Quantity::master, ranges::finite}
                : Field{"phase shift", Quantity::master, ranges::finite},
    c.shift);
  f(as_of_master(velocity, Quantity::master_velocity), c.dynamics.velocity);
  f(as_of_master(acceleration, Quantity::master_acceleration), c.dynamics.acceleration);
  f(as_of_master(deceleration, Quantity::master_acceleration), c.dynamics.deceleration);
  f(as_of_master(jerk, Quantity::master_jerk), c.dynamics.jerk);
}

/// Leaves the gear; the axis keeps its velocity.
struct GearOut {
  static constexpr auto kind = CommandKind::gear_out;
};
/// Leaves the cam; the axis keeps its velocity.
struct CamOut {
  static constexpr auto kind = CommandKind::cam_out;
};

/// Changes the cuts of a running plan of cuts. At most one of the numbers may be given. Without a
/// number: adds a cut at the next possible position of the web.
struct Cut {
  static constexpr auto kind = CommandKind::cut;
  double length = as_configured;    ///< length of all pieces that begin at the next cut or later, m
  double position = as_configured;  ///< adds a cut at this position of the web (the master), m
  double waste = as_configured;     ///< length of a piece of waste that begins at the next cut, m
};
template <Of<Cut> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"length", Quantity::master, ranges::given}, c.length);
  f(Field{"position", Quantity::master, ranges::given}, c.position);
  f(Field{"waste", Quantity::master, ranges::given}, c.waste);
}
/// Ends a running plan of cuts: the cutter returns to its home position.
struct Park {
  static constexpr auto kind = CommandKind::park;
};

/// Continues a static queue (rows in two banks, each played as a whole) with the other bank, at the
/// end of the present bank.
struct QueueSwitch {
  static constexpr auto kind = CommandKind::queue_switch;
  std::uint32_t queue = 0;  ///< number of the queue
  std::uint8_t bank = 0;    ///< number of the bank to continue with: 0 or 1
};
template <Of<QueueSwitch> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
  f(bank, c.bank);
}

/// Empties a bank that is not being played.
struct QueueClear {
  static constexpr auto kind = CommandKind::queue_clear;
  std::uint32_t queue = 0;  ///< number of the queue
  std::uint8_t bank = 0;    ///< number of the bank: 0 or 1
  std::uint32_t seq = 0;    ///< number of the next message to this bank
};
template <Of<QueueClear> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
  f(bank, c.bank);
  f(Field{"seq", Quantity::none, ranges::count}, c.seq);
}

/// Ends a dynamic queue (a rolling stream) at its last row: the sender will send no more rows.
struct QueueEnd {
  static constexpr auto kind = CommandKind::queue_end;
  std::uint32_t queue = 0;  ///< number of the queue
};
template <Of<QueueEnd> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
}

/// Plays the table of a virtual master, or the program of a group, from its beginning.
struct StartTable {
  static constexpr auto kind = CommandKind::start_table;
};

// ---- commands of a group ------------------------------------------------------------------------

/// Coordinates in the order of the axes of a group, u; NaN: not given.
template <std::size_t N>
constexpr std::array<double, N> no_coordinates() {
  std::array<double, N> none{};
  for (double& coordinate : none) coordinate = as_configured;
  return none;
}
inline constexpr std::size_t most_coordinates = 9;  ///< greatest number of axes of a group
using Coordinates = std::array<double, most_coordinates>;

/// Dynamics of a command of a group along its path, and how the command joins the previous one.
/// `deviation` and `corner_distance` need a `buffer` that blends, and only one of them may be
/// given.
struct PathDynamics {
  MoveDynamics along = {};  ///< along the path; not given: the limits of the axes
  PathBuffer buffer = PathBuffer::aborting;
  /// Rounds the corner to the previous command: greatest distance of the path from the corner, u.
  double deviation = as_configured;
  /// Rounds the corner: the path leaves the previous command at most this far before its end, and
  /// joins the new one at most this far after its start, u.
  double corner_distance = as_configured;
};
template <Of<PathDynamics> C, class F>
constexpr void each_field(C& c, F f) {
  each_field(c.along, f);
  f(Field{"buffer mode", Quantity::none, {.least = 0, .most = 6, .whole = true, .words = "0 to 6"}},
    c.buffer);
  f(Field{"deviation", Quantity::position, ranges::positive}, c.deviation);
  f(Field{"corner distance", Quantity::position, ranges::positive}, c.corner_distance);
}

/// Calls f(field, member) for each coordinate of an absolute or a relative command.
template <class C, class F>
constexpr void each_target(C& to, bool relative, F f) {
  for (auto& coordinate : to)
    f(relative ? Field{"distance", Quantity::position, ranges::coordinate}
               : Field{"position", Quantity::position, ranges::coordinate},
      coordinate);
}

/// Moves a group along a straight line. A coordinate that is not given stays. In a relative
/// command, `to` is the distance from the end of the previous command.
template <bool relative_>
struct MoveLinear {
  static constexpr bool relative = relative_;
  static constexpr auto kind =
      relative ? CommandKind::move_linear_relative : CommandKind::move_linear_absolute;
  Coordinates to = no_coordinates<most_coordinates>();
  PathDynamics path = {};
};
using MoveLinearAbsolute = MoveLinear<false>;
using MoveLinearRelative = MoveLinear<true>;

/// Moves a group to a point, as fast as its axes permit: along a straight line (PMC600:
/// Path_Invariant), or, if `fast`, each axis in its own shortest time (PMC600: Fast). A fast move
/// begins and ends at rest, and its path depends on the limits of the axes.
template <bool relative_>
struct MoveDirect {
  static constexpr bool relative = relative_;
  static constexpr auto kind =
      relative ? CommandKind::move_direct_relative : CommandKind::move_direct_absolute;
  Coordinates to = no_coordinates<most_coordinates>();
  PathDynamics path = {};
  bool fast = false;
};
using MoveDirectAbsolute = MoveDirect<false>;
using MoveDirectRelative = MoveDirect<true>;

inline constexpr std::int32_t most_extra_turns = 1000;  ///< greatest `turns` of a circular move

/// Moves a group along an arc: through the point `via`, or in the plane of the first two axes
/// around `center`, or with `radius`. Exactly one of these three must be given. The other axes move
/// in proportion to the angle, so an arc with a third coordinate is a helix. In a relative command,
/// all coordinates count from the end of the previous command.
template <bool relative_>
struct MoveCircular {
  static constexpr bool relative = relative_;
  static constexpr auto kind =
      relative ? CommandKind::move_circular_relative : CommandKind::move_circular_absolute;
  Coordinates to = no_coordinates<most_coordinates>();
  std::array<double, 3> via = no_coordinates<3>();     ///< a point of the arc, u
  std::array<double, 2> center = no_coordinates<2>();  ///< center of the arc, u
  double radius = as_configured;  ///< u; > 0: at most half a turn; < 0: the longer arc
  bool clockwise = false;         ///< true: the group moves clockwise; not used with `via`
  std::int32_t turns = 0;         ///< additional whole turns, at most most_extra_turns
  PathDynamics path = {};
};
using MoveCircularAbsolute = MoveCircular<false>;
using MoveCircularRelative = MoveCircular<true>;

template <class C, class F>
requires requires(C& c) {
  c.path;
}
constexpr void each_field(C& c, F f) {
  each_target(c.to, C::relative, f);
  if constexpr (requires { c.via; }) {
    for (auto& coordinate : c.via)
      f(Field{"via", Quantity::position, ranges::coordinate}, coordinate);
    for (auto& coordinate : c.center)
      f(Field{"center", Quantity::position, ranges::coordinate}, coordinate);
    f(Field{"radius", Quantity::position, ranges::coordinate}, c.radius);
    f(Field{"clockwise", Quantity::none, ranges::flag}, c.clockwise);
    f(Field{"turns", Quantity::none, ranges::count}, c.turns);
  }
  each_field(c.path, f);
  if constexpr (requires { c.fast; }) f(Field{"fast", Quantity::none, ranges::flag}, c.fast);
}

/// Lets a group rest at the end of its last command (SMC_GroupWait). The duration need not be a
/// multiple of the cycle.
struct GroupWait {
  static constexpr auto kind = CommandKind::group_wait;
  double duration = 0;  ///< s, >= 0
};
template <Of<GroupWait> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"duration", Quantity::time, ranges::finite}, c.duration);
}

/// Moves a group along a straight line until the next command, or until an axis reaches the end of
/// its position range (JogGroup and JogGroupAxis of HIMC, SMC_GroupJog).
struct GroupJog {
  static constexpr auto kind = CommandKind::group_jog;
  /// Direction, of any length; a component that is not given is 0.
  Coordinates along = no_coordinates<most_coordinates>();
  MoveDynamics dynamics = {};  ///< along the path; not given: the limits of the axes
  /// True: the group stops if its sender is silent, like MoveVelocity::hold_to_run.
  bool hold_to_run = false;
};
template <Of<GroupJog> C, class F>
constexpr void each_field(C& c, F f) {
  for (auto& component : c.along)
    f(Field{"direction", Quantity::none, ranges::coordinate}, component);
  each_field(c.dynamics, f);
  f(hold_to_run, c.hold_to_run);
}

/// Switches the compensation of a disabled axis on (EnableComp of HIMC).
struct EnableCompensation {
  static constexpr auto kind = CommandKind::enable_compensation;
};
/// Switches the compensation of a disabled axis off (DisableComp of HIMC).
struct DisableCompensation {
  static constexpr auto kind = CommandKind::disable_compensation;
};
/// Sets the frame of the following single commands of a group: the position and orientation of the
/// part in the machine (MC_SetCoordinateTransform, G54). The coordinates in these commands then
/// count in the frame of the part. Nothing moves. The frame applies until the next
/// SetCoordinateTransform, or until the group is disabled. Without values, the coordinates count in
/// the frame of the machine again.
struct SetCoordinateTransform {
  static constexpr auto kind = CommandKind::set_coordinate_transform;
  /// Origin of the part in the machine, u; a coordinate that is not given is 0.
  Coordinates offset = no_coordinates<most_coordinates>();
  /// Rotation about the third axis, from the first axis towards the second, deg; not given: 0.
  double rotation = as_configured;
  /// Three rotations instead of `rotation`: about Z, the new Y, and the new Z, deg.
  std::array<double, 3> zyz = no_coordinates<3>();
};
template <Of<SetCoordinateTransform> C, class F>
constexpr void each_field(C& c, F f) {
  for (auto& coordinate : c.offset)
    f(Field{"offset", Quantity::position, ranges::coordinate}, coordinate);
  f(Field{"rotation", Quantity::none, ranges::given}, c.rotation);
  for (auto& angle : c.zyz) f(Field{"angle", Quantity::none, ranges::coordinate}, angle);
}

/// Gives the end of the last command of a group new coordinates, without motion
/// (MC_GroupSetPosition, G92): shifts the frame of the following single commands. The axes keep
/// their positions. The shift applies as long as the frame of SetCoordinateTransform.
struct GroupSetPosition {
  static constexpr auto kind = CommandKind::group_set_position;
  /// New coordinates, u; or, if `relative`, values that are added. A coordinate that is not given
  /// stays.
  Coordinates to = no_coordinates<most_coordinates>();
  bool relative = false;  ///< true: adds `to` to the present coordinates
};
template <Of<GroupSetPosition> C, class F>
constexpr void each_field(C& c, F f) {
  each_target(c.to, false, f);
  f(Field{"relative", Quantity::none, ranges::flag}, c.relative);
}

/// Sets further limits of a group: along its path (SMC_GroupSetAncillaryPathLimits), or of one of
/// its axes (SMC_GroupSetAncillaryAxisLimits). These limits apply in addition to the configured
/// limits, until the group is disabled. A value that is not given removes the limit.
struct GroupSetLimits {
  static constexpr auto kind = CommandKind::group_set_limits;
  MoveDynamics dynamics = {};  ///< the limits; an axis has no separate deceleration
  std::int32_t axis = 0;       ///< number of the axis in the group, from 1; 0: along the path
  /// True: the limits apply to the commands after this one (mcQueued). False: they also apply to
  /// the present motion, whose speed is reduced (mcImmediately).
  bool queued = false;
};
template <Of<GroupSetLimits> C, class F>
constexpr void each_field(C& c, F f) {
  each_field(c.dynamics, f);
  f(Field{"axis", Quantity::none, ranges::count}, c.axis);
  f(Field{"queued", Quantity::none, ranges::flag}, c.queued);
}

/// An M word with a handshake: the group comes to rest at the end of its last command, sends an
/// event with the number, and continues after a GroupAcknowledge.
struct GroupMWord {
  static constexpr auto kind = CommandKind::group_m_word;
  std::int32_t number = 0;  ///< number of the M word
  double timeout = 0;       ///< greatest wait for the acknowledgment, s; after it, the group drops
                            ///< the commands that follow; 0: no limit
};
template <Of<GroupMWord> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"M word", Quantity::none, ranges::count}, c.number);
  f(Field{"timeout", Quantity::time, ranges::not_negative}, c.timeout);
}
/// Acknowledges the M word at which a group waits, or begins the next command in single step.
struct GroupAcknowledge {
  static constexpr auto kind = CommandKind::group_acknowledge;
  std::int32_t m_word = 0;  ///< number of the M word; 0: any, or a single step
};
template <Of<GroupAcknowledge> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"M word", Quantity::none, ranges::count}, c.m_word);
}
/// Makes the group rest before each of the commands that follow, until a GroupAcknowledge
/// (SingleStep of the PMC600).
struct GroupSingleStep {
  static constexpr auto kind = CommandKind::group_single_step;
  bool on = false;  ///< false: the commands that follow need no acknowledgment
};
template <Of<GroupSingleStep> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"on", Quantity::none, ranges::flag}, c.on);
}

/// Multiplies the velocity, and reduces the acceleration and the jerk of the axes of a group
/// (MC_GroupSetOverride).
struct GroupSetOverride {
  static constexpr auto kind = CommandKind::group_set_override;
  double velocity = 1;      ///< 0 to 2, as command::Override
  double acceleration = 1;  ///< share of the limits that the axes may use, > 0, at most 1
  double jerk = 1;          ///< share of the limits that the axes may use, > 0, at most 1
};
template <Of<GroupSetOverride> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"velocity factor", Quantity::none, ranges::factor}, c.velocity);
  f(Field{"acceleration factor", Quantity::none, ranges::share}, c.acceleration);
  f(Field{"jerk factor", Quantity::none, ranges::share}, c.jerk);
}

/// Captures the position of the axis at the edges of a trigger input. A new command for the same
/// input replaces the previous one.
struct TouchProbe {
  static constexpr auto kind = CommandKind::touch_probe;
  int input = 1;  ///< 1 to 4: trigger input of the drive; 5: home switch; 6: index of the encoder
  ProbeEdge edge = ProbeEdge::rising;  ///< edge to capture
  int count = 1;                       ///< number of captures; 0: until AbortTrigger
  /// Window of the positions to capture, u. NaN: no bound. On a modulo axis, the window may extend
  /// beyond the end of the turn: the first position is then greater than the last one.
  double first_position = as_configured;
  double last_position = as_configured;  ///< see first_position
};
inline constexpr Field trigger_input{
    "input", Quantity::none, {.least = 1, .most = probe_inputs, .whole = true, .words = "1 to 6"}};
template <Of<TouchProbe> C, class F>
constexpr void each_field(C& c, F f) {
  f(trigger_input, c.input);
  f(Field{"edge", Quantity::none, {.least = 0, .most = 2, .whole = true, .words = "0 to 2"}},
    c.edge);
  f(Field{"count", Quantity::none, ranges::count}, c.count);
  f(Field{"first position", Quantity::position, ranges::given}, c.first_position);
  f(Field{"last position", Quantity::position, ranges::given}, c.last_position);
}

/// Ends the touch probe of an input.
struct AbortTrigger {
  static constexpr auto kind = CommandKind::abort_trigger;
  int input = 1;  ///< see TouchProbe
};
template <Of<AbortTrigger> C, class F>
constexpr void each_field(C& c, F f) {
  f(trigger_input, c.input);
}

}  // namespace jounce::command

namespace jounce {

/// Adds alternatives to a variant.
template <class Variant, class... More>
struct Extended;
template <class... Commands, class... More>
struct Extended<std::variant<Commands...>, More...> {
  /// The variant with `More` at the end.
  using type = std::variant<Commands..., More...>;
  /// The variant with `More` at the beginning.
  using after = std::variant<More..., Commands...>;
};

/// The commands that an axis executes in the same form in which a client sends them.
using SharedCommand =
    std::variant<command::Enable, command::Disable, command::Reset, command::SetPosition,
                 command::Home, command::Hold, command::Resume, command::Override,
                 command::MoveAbsolute, command::MoveRelative, command::MoveAdditive,
                 command::MoveSuperimposed, command::MoveVelocity, command::Halt, command::GearOut,
                 command::CamOut, command::Finish, command::MoveRepetitive, command::ChangeVelocity,
                 command::PhasingAbsolute, command::PhasingRelative, command::Cut, command::Park,
                 command::TouchProbe, command::AbortTrigger, command::EnableCompensation,
                 command::DisableCompensation>;

/// A command that a client sends to an axis.
///
///     ClientCommand move = command::MoveAbsolute{.position = 120, .dynamics = {.velocity = 200}};
using ClientCommand =
    Extended<SharedCommand, command::GearIn, command::GearInPos, command::QueueSwitch,
             command::QueueClear, command::QueueEnd, command::StartTable,
             command::MoveLinearAbsolute, command::MoveLinearRelative,
             command::MoveCircularAbsolute, command::MoveCircularRelative,
             command::MoveDirectAbsolute, command::MoveDirectRelative, command::GroupWait,
             command::GroupJog, command::CombineAxes, command::SetCoordinateTransform,
             command::GroupSetPosition, command::GroupSetLimits, command::GroupMWord,
             command::GroupSetOverride, command::GroupAcknowledge, command::GroupSingleStep>::type;
static_assert(std::is_trivially_copyable_v<ClientCommand>);

/// Returns the kind of a command in any variant of commands.
template <class... Commands>
CommandKind kind_of(const std::variant<Commands...>& command) {
  return std::visit([](const auto& each) { return each.kind; }, command);
}

/// Returns the command of this kind with the defaults of its fields; nullopt if the variant has no
/// such command.
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

/// True if the command is a hold-to-run jog: its motion ends if the sender sends no heartbeats.
inline bool holds_to_run(const ClientCommand& command) {
  return std::visit(
      [](const auto& what) {
        if constexpr (requires { what.hold_to_run; }) return what.hold_to_run;
        return false;
      },
      command);
}

/// True for the kinds of the single commands of a group, which the executor takes one after another
/// (group_queue.hpp).
constexpr bool is_path_kind(CommandKind kind) {
  switch (kind) {
    case CommandKind::move_linear_absolute:
    case CommandKind::move_linear_relative:
    case CommandKind::move_circular_absolute:
    case CommandKind::move_circular_relative:
    case CommandKind::move_direct_absolute:
    case CommandKind::move_direct_relative:
    case CommandKind::group_wait:
    case CommandKind::group_jog:
    case CommandKind::set_coordinate_transform:
    case CommandKind::group_set_position:
    case CommandKind::group_set_limits:
    case CommandKind::group_m_word:
      return true;
    default:
      return false;
  }
}

/// True if C is a single command of a group: is_path_kind().
template <class C>
inline constexpr bool is_path_command = is_path_kind(C::kind);

/// Returns the fields of the command C, in the order of the wire.
template <class C>
constexpr Fields fields_of() {
  Fields all;
  C command{};
  command::each_field(
      command, [&](const Field& field, const auto& /*member*/) { all.field[all.count++] = field; });
  return all;
}

}  // namespace jounce
