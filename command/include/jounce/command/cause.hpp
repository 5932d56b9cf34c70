// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace jounce {

/// Reason why an axis is in the state error_stop, rejected a command, did not admit a table, or
/// ended its last motion. meaning() returns a sentence for each cause; docs/reference/messages.md
/// lists all causes. The numbers are part of the wire format: append new numbers to their block.
enum class Cause : std::uint8_t {
  none = 0,

  // Faults: latched in the axis until a reset.
  aborted = 1,
  disabled_in_motion = 2,
  stalled = 3,
  overspeed = 4,
  out_of_range = 5,
  following_error = 6,
  positive_soft_limit = 7,
  negative_soft_limit = 8,
  positive_switch = 9,
  negative_switch = 10,
  underrun = 11,
  watchdog = 12,
  drive_fault = 13,
  drive_not_ready = 14,
  master_lost = 15,
  jump = 16,
  master_reversed = 17,
  axis_fault = 18,
  marks_lost = 19,

  // Rejected commands; the axis continues unchanged.
  not_enabled = 20,
  in_error = 21,
  in_motion = 22,
  not_armed = 23,
  not_at_start = 24,
  too_late = 25,
  no_value = 26,
  leaving = 27,
  synchronized = 28,
  stopping = 29,
  not_on_path = 30,
  no_movement = 31,
  not_synchronized = 32,
  direction_blocked = 33,
  rate_changing = 34,
  no_such_move = 35,
  halting = 36,
  buffer_full = 37,
  not_positive = 38,
  no_reserve = 39,

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

  // Homing: faults, then rejected commands.
  home_timeout = 60,
  home_not_found = 61,
  index_not_found = 62,
  both_switches = 63,
  search_distance = 64,

  // Faults of a follower.
  overacceleration = 65,

  not_homed = 66,
  no_such_method = 67,
  no_sensor = 68,

  // Groups: rejected commands.
  in_group = 70,
  single_axis = 71,
  axis_not_ready = 72,
  axis_away = 73,
  not_a_group = 74,

  // Touch probes: rejected commands.
  no_trigger_input = 76,
  no_touch_probe = 77,
  probe_window = 78,

  // Moves and jogs: rejected commands.
  not_a_move = 79,

  // Cuts: rejected commands.
  no_cut_plan = 90,
  cut_length = 91,
  cut_position = 92,
  cut_pending = 93,
  web_stands = 94,
  cutter_away = 95,

  // Compensation: rejected commands.
  no_compensation = 96,
  compensation_active = 97,
  compensation_inactive = 98,
  enabled = 99,

  // Reasons why the last motion ended without a fault; none: it reached its end.
  stopped = 80,
  halted = 81,
  pass_ended = 82,
  replaced = 83,
  released = 84,
  group_stopped = 85,
  range_end = 106,
  reach_end = 107,
  singular_end = 108,
  awaits_acknowledge = 109,
  no_acknowledge = 110,

  // Groups: rejected commands.
  no_handshake = 111,

  // Rejected commands of axes and groups.
  no_start_tick = 114,
  nothing_to_start = 115,
  start_jump = 116,

  // Cuts: rejected commands.
  cut_too_far = 117,
  in_cut_plan = 118,
};

/// Returns the word for logs, messages and docs/reference/messages.md: "aborted", "not_armed", ...
const char* name(Cause cause);

/// Returns one sentence that states what happened.
const char* meaning(Cause cause);

/// True if the cause is a fault, which stays latched until a reset.
constexpr bool is_fault(Cause cause) {
  return (cause >= Cause::aborted && cause <= Cause::marks_lost) ||
         (cause >= Cause::home_timeout && cause <= Cause::overacceleration);
}

/// The reason for rejecting a command or a movement, with numbers in the units of the axis.
struct Refusal {
  Cause cause = Cause::none;  ///< the reason
  double value = 0;           ///< the number that breaks the rule
  double limit = 0;           ///< the bound that `value` exceeds
  /// Time of the movement at which the value exceeds the bound, s; NaN: no particular time. Some
  /// causes have other numbers:
  /// - axis_not_ready, axis_away: number of the axis in the group, from 1. axis_not_ready also has
  ///   the bits of all axes that are not ready, in `limit`.
  /// - no_reserve: the limit without remainder, 1: velocity, 2: acceleration or deceleration, 3:
  ///   jerk; for a move, 4: acceleration, 5: deceleration.
  /// - no_trigger_input: NaN; the input is in `value`, and the bits of those that the drive has are
  ///   in `limit`.
  double where = std::numeric_limits<double>::quiet_NaN();

  /// Returns a sentence: "velocity_limit: The motion exceeds the velocity limit of the axis: 678.45
  /// at 0.61 s, limit 500." The time is omitted if it is NaN, and the numbers if no bound was
  /// exceeded.
  [[nodiscard]] std::string text() const;
};

}  // namespace jounce
