// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/cause.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

struct Entry {
  Cause cause;
  const char* name;
  const char* meaning;
};

constexpr std::array entries{
    Entry{Cause::none, "none", "Nothing is wrong."},
    Entry{Cause::aborted, "aborted",
          "Aborted on request: the setpoint stays where it was in that cycle."},
    Entry{Cause::disabled_in_motion, "disabled_in_motion",
          "The axis was disabled in motion: the setpoint stays where it was in that cycle."},
    Entry{Cause::stalled, "stalled",
          "A cycle was later than longest_gap during a motion: the setpoint would have jumped."},
    Entry{Cause::overspeed, "overspeed",
          "The next setpoint needs a velocity above the limit of the axis."},
    Entry{Cause::out_of_range, "out_of_range",
          "The next setpoint is outside position_min and position_max."},
    Entry{Cause::following_error, "following_error",
          "The following error was above following_error for longer than following_time."},
    Entry{Cause::positive_soft_limit, "positive_soft_limit",
          "The motion would have passed position_max: the axis stopped before it."},
    Entry{Cause::negative_soft_limit, "negative_soft_limit",
          "The motion would have passed position_min: the axis stopped before it."},
    Entry{Cause::positive_switch, "positive_switch", "The axis reached the positive limit switch."},
    Entry{Cause::negative_switch, "negative_switch", "The axis reached the negative limit switch."},
    Entry{Cause::underrun, "underrun",
          "Buffer underrun: the streamed path was about to run out; the axis stopped on the path."},
    Entry{Cause::watchdog, "watchdog",
          "Watchdog expired: the heartbeat of the streamer or of the communication thread is "
          "missing."},
    Entry{Cause::drive_fault, "drive_fault", "The drive reports a fault."},
    Entry{Cause::drive_not_ready, "drive_not_ready",
          "The drive stopped following setpoints while it was enabled."},
    Entry{Cause::master_lost, "master_lost", "The master of this axis is lost."},
    Entry{Cause::jump, "jump", "The next setpoint is not finite, or its velocity jumps."},
    Entry{Cause::master_reversed, "master_reversed",
          "The master reversed while the slave was coupling to it."},
    Entry{Cause::not_enabled, "not_enabled", "The axis is disabled."},
    Entry{Cause::in_error, "in_error", "A fault is latched; reset the axis first."},
    Entry{Cause::in_motion, "in_motion", "The axis moves; wait for standstill, or stop it first."},
    Entry{Cause::not_armed, "not_armed", "No table is armed; send one before the start."},
    Entry{Cause::not_at_start, "not_at_start",
          "The axis is not at the position where the armed table begins; move it there first."},
    Entry{Cause::too_late, "too_late", "The requested start tick has passed."},
    Entry{Cause::no_value, "no_value", "The command has no table or no value."},
    Entry{Cause::leaving, "leaving", "The executor is shutting down and accepts no table."},
    Entry{Cause::synchronized, "synchronized", "The axis follows a master; leave it first."},
    Entry{Cause::stopping, "stopping", "A stop is in progress; wait for standstill."},
    Entry{Cause::not_on_path, "not_on_path", "Not possible while the axis follows a live master."},
    Entry{Cause::no_movement, "no_movement",
          "No motion is in progress that this command could change."},
    Entry{Cause::not_synchronized, "not_synchronized", "The axis follows no master."},
    Entry{Cause::direction_blocked, "direction_blocked",
          "The limit switch on that side is active: move the other way."},
    Entry{Cause::rate_changing, "rate_changing",
          "The speed on the path is changing; repeat the command afterwards."},
    Entry{Cause::no_such_move, "no_such_move",
          "No move from the present state to that target keeps the limits."},
    Entry{Cause::halting, "halting",
          "A halt is in progress: send a new motion, or wait for standstill."},
    Entry{Cause::buffer_full, "buffer_full",
          "The buffer is full: at most eight moves and one command for a tick can wait."},
    Entry{Cause::not_positive, "not_positive",
          "A velocity, acceleration, deceleration or jerk must be greater than 0; leave it out to "
          "use the limit of the axis."},
    Entry{
        Cause::bad_table, "bad_table",
        "The tables do not form a motion: send one table over time, or a master table and a cam."},
    Entry{Cause::start_position, "start_position",
          "The table does not begin at the position of the axis."},
    Entry{Cause::start_velocity, "start_velocity", "The table does not begin at rest."},
    Entry{Cause::end_velocity, "end_velocity", "The table does not end at rest."},
    Entry{Cause::not_closed, "not_closed",
          "The table repeats, but its last position differs from its first."},
    Entry{Cause::master_outside_cam, "master_outside_cam",
          "The master leaves the range of a cam that has no values outside."},
    Entry{Cause::position_limit, "position_limit", "The motion leaves the position range."},
    Entry{Cause::velocity_limit, "velocity_limit",
          "The motion exceeds the velocity limit of the axis."},
    Entry{Cause::acceleration_limit, "acceleration_limit",
          "The motion exceeds the acceleration limit of the axis."},
    Entry{Cause::jerk_limit, "jerk_limit", "The motion exceeds the jerk limit of the axis."},
    Entry{Cause::position_step, "position_step", "The position jumps."},
    Entry{Cause::velocity_step, "velocity_step",
          "The velocity jumps by more than the acceleration limit permits in one tick."},
    Entry{Cause::acceleration_step, "acceleration_step",
          "The acceleration jumps by more than the jerk limit permits in one tick."},
    Entry{Cause::wrong_unit, "wrong_unit",
          "The unit of the table differs from the unit of the axis."},
    Entry{Cause::no_master_input, "no_master_input",
          "The axis has no live master: [follow] names none, or the master is lost."},
    Entry{Cause::would_reverse, "would_reverse",
          "The axis could reach its cam only against the direction of its start mode."},
    Entry{Cause::master_stands, "master_stands",
          "A ramp over a master distance cannot begin while the master is at standstill."},
    Entry{Cause::no_ramp, "no_ramp", "No ramp within the limits brings the axis onto its cam."},
    Entry{Cause::not_in_sync, "not_in_sync",
          "The master ends before the axis has reached its cam."},
    Entry{Cause::home_timeout, "home_timeout", "The homing took longer than its timeout."},
    Entry{Cause::home_not_found, "home_not_found",
          "The search reached the second limit switch or its greatest distance before it found the "
          "switch of the homing method."},
    Entry{Cause::index_not_found, "index_not_found",
          "The search for the index went further than its distance."},
    Entry{Cause::both_switches, "both_switches",
          "Both limit switches were on during the homing: check their wiring."},
    Entry{Cause::not_homed, "not_homed",
          "The axis is not homed, and its spec has require_home: home it first."},
    Entry{Cause::no_such_method, "no_such_method",
          "The homing method must be 1 to 14, 17 to 30, 33, 34, 35 or 37 (CiA 402)."},
    Entry{Cause::no_sensor, "no_sensor",
          "The drive reports no switch or index that the homing method needs: choose another "
          "method, or add [drive.machine] to the axis's spec."},
    Entry{Cause::stopped, "stopped", "Stopped on request."},
    Entry{Cause::halted, "halted", "Halted on request."},
    Entry{Cause::pass_ended, "pass_ended",
          "Finished at the end of the current cycle, as requested."},
    Entry{Cause::replaced, "replaced", "Replaced by another motion."},
    Entry{Cause::released, "released",
          "The hold-to-run command ended: the session released it, or sent no heartbeat."},
    Entry{Cause::group_stopped, "group_stopped",
          "Another axis of the same start did not start, was stopped, or failed."},
};

/// True for the refusals with a measured value and a limit.
bool is_measured(Cause cause) {
  return cause >= Cause::start_position && cause <= Cause::acceleration_step;
}

const Entry& entry(Cause cause) {
  const auto* const found = std::find_if(entries.begin(), entries.end(),
                                         [&](const Entry& e) { return e.cause == cause; });
  return found == entries.end() ? entries.front() : *found;
}

}  // namespace

const char* name(Cause cause) {
  return entry(cause).name;
}

const char* meaning(Cause cause) {
  return entry(cause).meaning;
}

std::string Refusal::text() const {
  const std::string words = std::string(name(cause)) + ": " + meaning(cause);
  if (!is_measured(cause)) return words;
  if (cause == Cause::start_position) {
    const std::string begins = std::isnan(value) ? "" : "it begins at " + number(value) + ", ";
    return words + " (" + begins + "the axis stands at " + number(limit) + ")";
  }
  const std::string instant = std::isnan(where) ? "" : " at " + number(where) + " s";
  return words + " (" + number(value) + instant + ", limit " + number(limit) + ")";
}

}  // namespace jounce
