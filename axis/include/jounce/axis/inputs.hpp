// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "jounce/axis/live_compensation.hpp"
#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Greatest accepted magnitude of an input number; it is also the bound of move_to()
/// (moves/move.hpp).
inline constexpr double most_magnitude = 1e50;

/// A switch or an index of the machine, as a drive reports it for one cycle.
struct Sensor {
  bool wired = false;  ///< true if the machine has this sensor
  bool on = false;     ///< state at the end of the cycle; unused for an index
  /// Position that the drive has latched, u, in the coordinate of the drive: for a switch, the
  /// first change of its state since the previous cycle; for an index, the mark. NaN: no change.
  double edge = std::numeric_limits<double>::quiet_NaN();
};

/// The position sensors of a machine. CiA 402: objects 60FDh (states) and 60BAh (latched
/// positions).
struct Sensors {
  Sensor home = {};      ///< home switch
  Sensor negative = {};  ///< negative limit switch
  Sensor positive = {};  ///< positive limit switch
  Sensor index = {};     ///< index mark of the encoder
};

/// A change at a trigger input of a drive, as the drive reports it.
struct TriggerChange {
  std::uint8_t input = 0;  ///< number of the input, from 1
  bool rising = true;      ///< true: the input went on
  /// Time from the change to the instant of this cycle, s, >= 0. NaN: the drive gives no time
  /// stamp; the change counts as at the instant of this cycle.
  double age = std::numeric_limits<double>::quiet_NaN();
  /// Actual position that the drive has latched, u, in the coordinate of the drive. NaN: the drive
  /// latches no position.
  double position = std::numeric_limits<double>::quiet_NaN();
};

/// The trigger inputs of a drive in one cycle (touch probe). CiA 402: objects 60B8h to 60BDh, and
/// 60D1h to 60D4h for the time stamps.
struct Triggers {
  static constexpr int most_inputs = 4;           ///< greatest number of inputs
  static constexpr std::size_t most_changes = 4;  ///< greatest number of changes in one cycle

  std::uint8_t wired = 0;  ///< bit k - 1: the drive has the input k
  std::uint8_t on = 0;     ///< bit k - 1: the input k is on
  std::uint8_t count = 0;  ///< number of changes that are reported in this cycle
  std::array<TriggerChange, most_changes> change{};  ///< the changes, in chronological order

  [[nodiscard]] std::span<const TriggerChange> changes() const { return {change.data(), count}; }
};

/// State of the other axes that start together with this one (machine.hpp), for the start of the
/// armed movement of this axis. For a group of the machine (AxisGroup) and for each of its axes:
/// the present relation between group and axes. The numbers are part of the record of an executor.
enum class Peers : std::uint8_t {
  ready,    ///< the other axes, if any, each have an accepted start for the same tick
  missing,  ///< an axis has no start, or a start for another tick
  broken,   ///< an axis was stopped, has failed, or rejected its start

  // For an axis of a group:
  grouped,  ///< its group is enabled: the axis accepts no motion of its own
  led,      ///< its group moves: Inputs::master is the setpoint of this axis, u, u/s, u/s^2, u/s^3
  landing,  ///< led, and the group has come to rest in this tick

  // For a group:
  together,  ///< every axis can follow, and stands at its place on the path
  /// Every axis can follow, but one stands elsewhere, or there is no path. Inputs::master: position
  /// of this axis, its place on the path, u, and its number in the group, from 1.
  away,
  /// An axis cannot follow: it is disabled, has a fault, or moves alone. Inputs::master: as for
  /// away.
  failed,
};

/// True for the inputs of a group of the machine.
inline bool is_of_group(Peers peers) noexcept {
  return peers >= Peers::together;
}
/// True for the inputs of an axis whose group is enabled.
inline bool is_of_member(Peers peers) noexcept {
  return peers >= Peers::grouped && peers <= Peers::landing;
}

/// Feedback of a drive in one cycle. NaN: the drive does not report the value. Unit u: the unit of
/// the axis.
struct Feedback {
  /// Actual position, u, in the coordinate of the drive.
  double position = std::numeric_limits<double>::quiet_NaN();
  double velocity = std::numeric_limits<double>::quiet_NaN();  ///< actual velocity, u/s
  /// Torque as a share of the rated torque.
  double torque = std::numeric_limits<double>::quiet_NaN();
  bool ready = true;       ///< true if the drive follows setpoints (CiA 402: operation enabled)
  bool fault = false;      ///< true if the drive has failed (CiA 402: fault)
  Sensors sensors = {};    ///< states of the position sensors
  Triggers triggers = {};  ///< trigger inputs
};

/// Inputs of an axis in one cycle, besides commands. The axis stays within its limits for all
/// inputs. The master counts as lost if one of its numbers is not finite or exceeds 1e50. The drive
/// counts as failed (`drive_fault`) if it reports an infinite number, a magnitude above 1e50, or a
/// position that the axis could not reach in 2^40 ticks. m is the unit of the master.
struct Inputs {
  /// The master: position, m, and its derivatives, m/s, m/s^2, m/s^3. NaN: no master, or a lost
  /// one.
  Jet master = {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};
  /// Sum of all changes of the master by set_position so far, m. An active coupling uses the
  /// coordinate in which it was engaged.
  double master_offset = 0;
  /// The second master of the axis, for command::CombineAxes: like `master`.
  Jet second_master = {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};
  double second_offset = 0;  ///< like master_offset, for the second master
  Feedback feedback = {};    ///< feedback of the drive
  /// True if the positive limit switch is active. The axis also uses the switches in
  /// feedback.sensors.
  bool positive_switch = false;
  bool negative_switch = false;  ///< true if the negative limit switch is active
  /// Number of the last change of the queues that the axis may use (HandedOver::number); the
  /// greatest value means all changes.
  std::uint64_t rows = std::numeric_limits<std::uint64_t>::max();
  /// True if another motion of the same group was stopped or failed: the axis stops.
  bool group_broken = false;
  Peers peers = Peers::ready;  ///< state of the other axes, for the start of the armed movement
  /// True if the communication thread of the executor does not respond: the axis stops.
  bool watchdog = false;
  /// True if the active compensation of another axis refers to this axis: the axis then keeps its
  /// coordinate.
  bool referenced = false;
  /// Setpoints of the references of the compensation in this tick, for MotionAxis::compensate().
  References references{};
};

}  // namespace jounce
