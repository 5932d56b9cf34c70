#pragma once

#include <cstdint>
#include <limits>

#include "jounce/profiles/jet.hpp"

namespace jounce {

/// Numbers beyond this are none of a machine; move_to() has the same bound.
inline constexpr double most_magnitude = 1e50;

/// A switch or an index of the machine, as a drive reports it for one cycle.
struct Sensor {
  bool wired = false;  ///< the machine has it
  bool on = false;     ///< at the end of the cycle; of an index nothing
  /// u, as the drive counts: where it changed first since the cycle before (an index: where it was
  /// passed), latched by the drive; NaN: nowhere.
  double edge = std::numeric_limits<double>::quiet_NaN();
};

/// The sensors that say where a machine is: CiA 402, objects 60FDh (levels) and 60BAh (latches).
struct Sensors {
  Sensor home;      ///< home switch
  Sensor negative;  ///< limit switches
  Sensor positive;
  Sensor index;  ///< of the encoder
};

/// The other axes of a group, before the start for which this axis waits (machine.hpp).
enum class Peers : std::uint8_t {
  ready,    ///< each of them has a start accepted for the same tick, or there are none
  missing,  ///< one of them has none, or one for another tick
  broken,   ///< one was stopped, failed, or refused its start
};

/// What a drive says in one cycle. NaN: it does not tell.
struct Feedback {
  double position = std::numeric_limits<double>::quiet_NaN();  ///< actual, u, as the drive counts
  double velocity = std::numeric_limits<double>::quiet_NaN();  ///< actual, u/s
  double torque = std::numeric_limits<double>::quiet_NaN();    ///< share of the rated one
  bool ready = true;   ///< it follows setpoints (CiA 402: operation enabled)
  bool fault = false;  ///< it has failed (CiA 402: fault)
  Sensors sensors = {};
};

/// What an axis sees in one cycle besides commands. Whatever it is, the axis stays within its limits:
/// a master with a number that is not finite or beyond 1e50 is lost, and a drive that reports one, or
/// a position that the axis could not reach in 2^40 ticks, has failed (`drive_fault`).
struct Inputs {
  Jet master = {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};  ///< NaN: none, or lost
  /// m: what set_position of the master has added to its count so far. What is coupled goes on in the
  /// count in which it was coupled.
  double master_offset = 0;
  Feedback feedback = {};
  bool positive_switch = false;  ///< limit switches: the axis stands on it; also the drive's
  bool negative_switch = false;
  /// Rows of its queues are there up to this number; the greatest: all that were handed over.
  std::uint64_t rows = std::numeric_limits<std::uint64_t>::max();
  bool group_broken = false;  ///< what began together with its motion was stopped, or failed: stop
  Peers peers = Peers::ready;  ///< the armed movement may begin, or not
  bool watchdog = false;  ///< whoever had to give a sign of life has not: stop
};

}  // namespace jounce
