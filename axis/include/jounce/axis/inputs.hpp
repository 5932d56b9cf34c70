// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Greatest accepted magnitude of a number; move_to() has the same bound.
inline constexpr double most_magnitude = 1e50;

/// A switch or an index of the machine, as a drive reports it for one cycle.
struct Sensor {
  bool wired = false;  ///< the machine has this sensor
  bool on = false;     ///< state at the end of the cycle; unused for an index
  /// u, in the drive's coordinate: position of the first change since the previous cycle (for an
  /// index: position of the mark), latched by the drive; NaN: no change.
  double edge = std::numeric_limits<double>::quiet_NaN();
};

/// The position sensors of a machine: CiA 402, objects 60FDh (levels) and 60BAh (latches).
struct Sensors {
  Sensor home;      ///< home switch
  Sensor negative;  ///< limit switches
  Sensor positive;
  Sensor index;  ///< index mark of the encoder
};

/// State of the other axes of a group before the start for which this axis waits (machine.hpp).
enum class Peers : std::uint8_t {
  ready,    ///< each of them has a start accepted for the same tick, or there are none
  missing,  ///< one of them has no start, or a start for another tick
  broken,   ///< one was stopped, failed, or rejected its start
};

/// Feedback of a drive in one cycle. NaN: not available.
struct Feedback {
  double position = std::numeric_limits<double>::quiet_NaN();  ///< actual, u, of the drive
  double velocity = std::numeric_limits<double>::quiet_NaN();  ///< actual, u/s
  double torque = std::numeric_limits<double>::quiet_NaN();    ///< relative to the rated torque
  bool ready = true;   ///< it follows setpoints (CiA 402: operation enabled)
  bool fault = false;  ///< it has failed (CiA 402: fault)
  Sensors sensors = {};
};

/// Inputs of an axis in one cycle, besides commands. The axis stays within its limits for all
/// inputs. A master is lost if one of its numbers is not finite or exceeds 1e50. A drive has failed
/// (`drive_fault`) if it reports such a number, or a position that the axis could not reach in 2^40
/// ticks.
struct Inputs {
  Jet master = {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};  ///< NaN: none, or lost
  /// m: sum of the set_position changes of the master so far. An active coupling keeps the
  /// coordinate in which it was engaged.
  double master_offset = 0;
  Feedback feedback = {};
  bool positive_switch = false;  ///< limit switch active; OR-ed with feedback.sensors
  bool negative_switch = false;
  /// Number of the last available row of its queues; the greatest value: all rows.
  std::uint64_t rows = std::numeric_limits<std::uint64_t>::max();
  bool group_broken = false;   ///< another motion of the same start was stopped or failed: stop
  Peers peers = Peers::ready;  ///< permission for the armed movement to begin
  bool watchdog = false;       ///< a heartbeat is missing: stop
};

}  // namespace jounce
