// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace jounce {

/// The PLCopen states (PMC600 manual 4.1, nAxisState). The numbers are part of the wire format.
enum class State : std::uint8_t {
  disabled = 0,
  standstill = 1,
  discrete_motion = 2,      ///< a table over time, or a move to a target
  synchronized_motion = 3,  ///< follows a master
  stopping = 4,             ///< on its way to rest; only a fault ends that
  error_stop = 5,           ///< at rest, or on its way there, until a reset
  continuous_motion = 6,    ///< at a velocity, until the next command
  homing = 7,               ///< searches for home; for one step if home is the present position
};
inline constexpr std::size_t states = 8;
const char* name(State state);

}  // namespace jounce
