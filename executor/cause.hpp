#pragma once

#include <cstdint>

namespace jounce {

/// Why an axis is in ErrorStop, why it did not obey a command, or why a table was not admitted. The
/// numbers are part of the wire format: new ones go to the end of their block.
enum class Cause : std::uint8_t {
  none = 0,

  // Faults: latched in the axis until it is reset.
  aborted = 1,
  disabled_in_motion = 2,
  stalled = 3,
  overspeed = 4,
  out_of_range = 5,

  // Commands that were not obeyed; the axis goes on as before.
  not_enabled = 20,
  in_error = 21,
  in_motion = 22,
  not_armed = 23,
  not_at_start = 24,
  too_late = 25,
  no_value = 26,
  leaving = 27,

  // Tables that were not admitted.
  bad_table = 40,
  start_position = 41,
  start_velocity = 42,
  end_velocity = 43,
  not_closed = 44,
  master_outside_cam = 45,
  position_limit = 46,
  velocity_limit = 47,
  acceleration_limit = 48,
  jerk_limit = 49,
  position_step = 50,
  velocity_step = 51,
  acceleration_step = 52,
  wrong_unit = 53,
  no_master_input = 54,
  would_reverse = 55,
  master_stands = 56,
  no_ramp = 57,
  not_in_sync = 58,
};

/// "aborted", "not_armed", ...: the words of the log, of messages and of docs/executor.md.
const char* name(Cause cause);

/// One sentence: what happened.
const char* meaning(Cause cause);

/// Whether it is a fault, which stays latched until a reset.
constexpr bool is_fault(Cause cause) {
  return cause >= Cause::aborted && cause <= Cause::out_of_range;
}

}  // namespace jounce
