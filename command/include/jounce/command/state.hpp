// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace jounce {

/// The states of an axis, after PLCopen (PMC600 manual, section 4.1, nAxisState). The numbers are
/// part of the wire format.
enum class State : std::uint8_t {
  disabled = 0,             ///< the drive does not follow setpoints
  standstill = 1,           ///< at rest, ready for a command
  discrete_motion = 2,      ///< plays a table over time, or moves to a target
  synchronized_motion = 3,  ///< follows a master
  stopping = 4,             ///< goes to rest; only a fault interrupts this
  error_stop = 5,           ///< a fault is latched: at rest, or going to rest, until a reset
  continuous_motion = 6,    ///< moves at a given velocity until the next command
  homing = 7,               ///< searches for the home position
};
inline constexpr std::size_t states = 8;  ///< number of states
/// Returns the name of a state: "standstill", ...
const char* name(State state);
/// Returns the state with this name; nullopt if there is none.
std::optional<State> state_of(std::string_view name);

}  // namespace jounce
