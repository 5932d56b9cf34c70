#pragma once

#include <cstdint>
#include <limits>

#include "jounce/profiles/jet.hpp"

namespace jounce {

/// Numbers beyond this are none of a machine; move_to() has the same bound.
inline constexpr double most_magnitude = 1e50;

/// What a drive says in one cycle. NaN: it does not tell.
struct Feedback {
  double position = std::numeric_limits<double>::quiet_NaN();  ///< actual, u, as the drive counts
  double velocity = std::numeric_limits<double>::quiet_NaN();  ///< actual, u/s
  double torque = std::numeric_limits<double>::quiet_NaN();    ///< share of the rated one
  bool ready = true;   ///< it follows setpoints (CiA 402: operation enabled)
  bool fault = false;  ///< it has failed (CiA 402: fault)
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
  bool positive_switch = false;  ///< limit switches: the axis stands on it
  bool negative_switch = false;
  /// Rows of its queues are there up to this number; the greatest: all that were handed over.
  std::uint64_t rows = std::numeric_limits<std::uint64_t>::max();
  bool group_broken = false;  ///< what began together with its motion was stopped, or failed: stop
  bool watchdog = false;  ///< whoever had to give a sign of life has not: stop
};

}  // namespace jounce
