// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "jounce/axis/movement.hpp"
#include "jounce/axis/probe_step.hpp"
#include "jounce/axis/profile_event.hpp"
#include "jounce/cam/switches/cam_switches.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/state.hpp"
#include "jounce/gear/live_registration.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/pvt/live_compare.hpp"

namespace jounce {

/// The group of the movement that an axis has armed, and the start of this movement. A group is a
/// set of motions of several axes that start and stop together.
struct GroupStart {
  std::int64_t group = 0;  ///< number of the group; 0: no group
  bool accepted = false;   ///< true if the start of the movement was accepted
  std::int64_t tick = -1;  ///< tick of the start; -1: no tick was given
};

/// The outputs of an axis in one tick. Units: u is the unit of the axis, m the unit of its master.
struct Tick {
  std::int64_t tick = 0;          ///< number of the tick
  double time = 0;                ///< tick * period, s
  State state = State::disabled;  ///< state of the axis
  double master = 0;              ///< position of the master, m
  double master_velocity = 0;     ///< velocity of the master, m/s
  double position = 0;            ///< commanded position (setpoint), u
  double velocity = 0;            ///< commanded velocity, u/s
  double acceleration = 0;        ///< commanded acceleration, u/s^2
  /// Id of the movement that is played; 0: none, or a move that the axis plans.
  std::uint64_t job = 0;
  std::uint64_t armed = 0;  ///< id of the armed movement; 0: none
  bool waiting = false;     ///< true if an accepted start, move or command has not begun
  std::int64_t later = -1;  ///< tick for which a command waits; -1: none
  /// Position of the master for which an accepted start waits, m; NaN: none.
  double start_position = std::numeric_limits<double>::quiet_NaN();
  /// Position and velocity of the live master, m, m/s; NaN: the axis has none, or it is lost.
  std::array<double, 2> live_master{std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::quiet_NaN()};
  Progress progress = Progress::done;  ///< progress of the motion that is played
  Cause fault = Cause::none;           ///< the latched fault; none: no fault
  /// The number that exceeded a limit at the fault: the following error (u), the velocity (u/s) of
  /// overspeed, or the acceleration (u/s^2) of overacceleration and jump. For home_timeout, the timeout
  /// (s), and for search_distance and index_not_found, the distance (u) of the search. NaN: none.
  double fault_value = std::numeric_limits<double>::quiet_NaN();
  std::int64_t skipped = 0;    ///< ticks skipped between the previous step and this one
  std::uint64_t finished = 0;  ///< number of motions that reached their end, so far
  std::uint64_t stopped = 0;   ///< number of motions that a stop brought to rest, so far
  /// Why the last motion ended: a fault, stopped, halted, ...; none: the motion reached its end.
  /// After a start with a live master that was dropped at rest: the reason of the drop.
  Cause reason = Cause::none;
  double override_ = 1;    ///< override factor in effect, 0 to 2
  double rate = 1;         ///< present rate of path time: 1 is the original speed of the path
  double path_time = 0;    ///< time of the path that is played, s; 0: no path
  bool held = false;       ///< true if the motion is held until the command resume
  bool homed = false;      ///< true after homing: the position refers to the home position
  bool power = false;      ///< request to the drive: follow the setpoints
  std::int64_t group = 0;  ///< number of the group of the motion that is played; 0: no group
  GroupStart next{};       ///< group and start of the armed movement
  /// Groups that this axis has broken; 0: none. [0]: the group of its motion, [1]: the group of its
  /// armed movement. An axis breaks a group if a stop, a halt, a fault or a rejected start ends the
  /// motion or the armed movement early. A number stays until the axis arms a movement of that
  /// group again.
  std::array<std::int64_t, 2> broken{};
  bool frozen = false;  ///< true if the velocity fell to 0 at once in this tick, without braking;
                        ///< see `fault`
  /// Sum of all changes by set_position so far, u. The position of the drive is position - offset.
  double offset = 0;
  /// Position that the drive reports, in the coordinate of the axis, u; NaN: unknown.
  double actual_position = std::numeric_limits<double>::quiet_NaN();
  /// Setpoint minus actual position, u; NaN: unknown.
  double following_error = std::numeric_limits<double>::quiet_NaN();
  /// Share of the rated torque; NaN: unknown.
  double torque = std::numeric_limits<double>::quiet_NaN();
  /// True if the axis is at standstill, and the following error has been within the window
  /// AxisConfig::in_position for AxisConfig::in_position_time.
  bool in_position = false;
  SwitchStep switches{};  ///< outputs of the cam switches, with their edges since the previous tick
  /// Output of the position compare, with its edges since the previous tick.
  CompareStep compare{};
  ProfileStep profile{};  ///< events of the cam or the follow tables on the live master
  ProbeStep probe{};      ///< captures of the touch probes in this tick
  RegistrationReading registration{};  ///< state of the registration
  bool compensated = false;            ///< true if the compensation is active
  /// Correction of the compensation and its derivatives, u, u/s, u/s^2; 0 if it is not active. The
  /// drive receives position + correction[0] - offset.
  Jet correction{};
  /// Ratio of the gear that the axis plays, u/m; 0: it plays no gear.
  double ratio = 0;

  std::optional<Refusal> refused{};  ///< reason why the command of this tick was rejected
  std::optional<Refusal> dropped{};  ///< reason why the waiting motion was dropped
  /// For the fault axis_fault: the axis of the group, as in a rejection axis_not_ready.
  std::optional<Refusal> failed_axis{};
  /// Movements that the axis no longer reads: the caller may destroy or reuse them.
  std::array<const Movement*, 3> handed_back{};
};

/// True if the axis moves now, or will move later without a further command. The motion may be a
/// movement, a move that the axis plans itself, or braking in a fault. A held motion counts; a
/// motion at rest after an underrun does not.
bool in_motion(const Tick& tick);

}  // namespace jounce
