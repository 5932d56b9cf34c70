// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/command/causes.hpp"
#include "jounce/command/refusal_text.hpp"
#include "jounce/profiles/six_digits.hpp"

namespace jounce {
namespace {

using Entry = CauseInfo;

constexpr std::array entries{
    Entry{Cause::none, "none", "Nothing is wrong.", "Nothing."},
    Entry{Cause::aborted, "aborted",
          "Aborted on request: the setpoint stays where it was in that cycle.",
          "Remove the reason for the abort, reset the axis, and send the motion again."},
    Entry{Cause::disabled_in_motion, "disabled_in_motion",
          "The axis was disabled in motion: the setpoint stays where it was in that cycle.",
          "Look for what took the enable away: the drive, an operator, or a second program."},
    Entry{Cause::stalled, "stalled",
          "A cycle was later than longest_gap during a motion: the setpoint would have jumped.",
          "Run on a real-time kernel with a priority, or permit a longer gap with longest_gap."},
    Entry{Cause::overspeed, "overspeed",
          "The next setpoint needs a velocity above the limit of the axis.",
          "With a live master: slow the master down, or raise the velocity limit of the axis. With "
          "a table: report it, the table was checked."},
    Entry{Cause::out_of_range, "out_of_range",
          "The next setpoint is outside position_min and position_max.",
          "With a live master: shorten its travel, or shift the cam. With a table: report it, the "
          "table was checked."},
    Entry{
        Cause::following_error, "following_error",
        "The following error exceeded its limit, following_error, for longer than following_time.",
        "Check the load, the brake and the tuning of the drive, and check the torque with `jounce "
        "validate`. Then reset the axis."},
    Entry{Cause::positive_soft_limit, "positive_soft_limit",
          "The motion would have passed position_max: the axis stopped before it.",
          "Reset the axis, then move it back."},
    Entry{Cause::negative_soft_limit, "negative_soft_limit",
          "The motion would have passed position_min: the axis stopped before it.",
          "Reset the axis, then move it back."},
    Entry{Cause::positive_switch, "positive_switch", "The axis reached the positive limit switch.",
          "Reset the axis, then move it off the switch in the negative direction."},
    Entry{Cause::negative_switch, "negative_switch", "The axis reached the negative limit switch.",
          "Reset the axis, then move it off the switch in the positive direction."},
    Entry{Cause::underrun, "underrun",
          "Buffer underrun: the streamed path was about to run out; the axis stopped on the path.",
          "Reset the axis, then stream the rest from the present position. Send rows earlier, or "
          "more of them before the start (--ahead)."},
    Entry{Cause::watchdog, "watchdog",
          "Watchdog expired: the heartbeat of the streamer or of the communication thread is "
          "missing.",
          "Look for the program or thread that sends no heartbeat: it has ended, hangs, or the "
          "network is down."},
    Entry{Cause::drive_fault, "drive_fault", "The drive reports a fault.",
          "Read the fault of the drive, remove its cause, reset the drive, then the axis."},
    Entry{Cause::drive_not_ready, "drive_not_ready",
          "The drive stopped following setpoints while it was enabled.",
          "Check the enable, the safe torque off and the bus voltage of the drive."},
    Entry{Cause::master_lost, "master_lost", "The master of this axis is lost.",
          "Check the encoder or the program of the master and its link."},
    Entry{Cause::jump, "jump", "The next setpoint is not finite, or its velocity jumps.",
          "With a live master: filter its position, or check its encoder. With a table: report it, "
          "the table was checked."},
    Entry{Cause::master_reversed, "master_reversed",
          "The master reversed while the slave was coupling to it.",
          "Couple while the master moves in its own direction."},
    Entry{Cause::not_enabled, "not_enabled", "The axis is disabled.",
          "Enable the axis: `jounce order NAME enable`."},
    Entry{Cause::in_error, "in_error", "A fault is latched; reset the axis first.",
          "Find the cause of the fault, then reset: `jounce order NAME reset`."},
    Entry{Cause::in_motion, "in_motion", "The axis moves; wait for standstill, or stop it first.",
          "Wait for standstill, or stop the axis: `jounce stop NAME`."},
    Entry{Cause::not_armed, "not_armed", "No table is armed; send one before the start.",
          "Send a table and arm it. After a stop, arm it again."},
    Entry{Cause::not_at_start, "not_at_start",
          "The axis is not at the position where the armed table begins; move it there first.",
          "Arm the table again: the axis was moved, or its position was set, after the arm."},
    Entry{Cause::too_late, "too_late", "The requested start tick has passed.",
          "Give a later tick: `jounce monitor NAME --json` shows the present one."},
    Entry{Cause::no_value, "no_value", "The command has no table or no value.",
          "Send the table, or the number, with the command."},
    Entry{Cause::leaving, "leaving", "The executor is shutting down and accepts no table.",
          "Start the executor again."},
    Entry{Cause::synchronized, "synchronized", "The axis follows a master; leave it first.",
          "Leave the master first: `jounce order NAME gear-out` or `cam-out`."},
    Entry{Cause::stopping, "stopping", "A stop is in progress; wait for standstill.",
          "Wait until the axis is at rest."},
    Entry{Cause::not_on_path, "not_on_path", "Not possible while the axis follows a live master.",
          "Stop the axis, or slow the master down."},
    Entry{Cause::no_movement, "no_movement",
          "This command changes a motion, but no motion is in progress.",
          "Start a motion before this command."},
    Entry{Cause::not_synchronized, "not_synchronized", "The axis follows no master.",
          "Nothing to do: the axis has no master to leave."},
    Entry{Cause::direction_blocked, "direction_blocked",
          "The limit switch on that side is active: move the other way.",
          "Move the axis off the limit switch, in the other direction."},
    Entry{Cause::rate_changing, "rate_changing",
          "The speed on the path is changing; repeat the command afterwards.",
          "Repeat the command when the rate is constant."},
    Entry{Cause::no_such_move, "no_such_move",
          "No move from the present state to that target keeps the limits.",
          "Choose a target farther away, a lower velocity, or higher limits."},
    Entry{Cause::halting, "halting",
          "A halt is in progress: send a new motion, or wait for standstill.",
          "Send another motion, or wait for the end of the halt."},
    Entry{Cause::buffer_full, "buffer_full",
          "The buffer is full: at most eight moves and one command for a tick can wait.",
          "Wait until one of the motions begins."},
    Entry{Cause::not_positive, "not_positive",
          "A velocity, acceleration, deceleration or jerk must be greater than 0; leave it out to "
          "use the limit of the axis.",
          "Give a number greater than 0, or leave the option out."},
    Entry{Cause::bad_table, "bad_table",
          "The tables do not form a motion: send one table over time, or a master table and a cam.",
          "Send one table over time, or a cam over a master and a master over time."},
    Entry{Cause::start_position, "start_position",
          "The table does not begin at the position of the axis.",
          "Move the axis to the start of the table, send the rows with --relative, or set "
          "adopt_start."},
    Entry{Cause::start_velocity, "start_velocity", "The table does not begin at rest.",
          "Add a ramp at the start. The limit is the acceleration limit times one tick."},
    Entry{Cause::end_velocity, "end_velocity", "The table does not end at rest.",
          "Add a ramp at the end. The limit is the acceleration limit times one tick."},
    Entry{Cause::not_closed, "not_closed",
          "The table repeats, but its last position differs from its first.",
          "End a repeating table where it begins, or let it hold its end."},
    Entry{Cause::master_outside_cam, "master_outside_cam",
          "The master leaves the range of a cam that has no values outside.",
          "Shorten the travel of the master, or make the cam hold, wrap or advance."},
    Entry{Cause::position_limit, "position_limit", "The motion leaves the position range.",
          "Shift or shorten the motion, or widen position_min and position_max."},
    Entry{Cause::velocity_limit, "velocity_limit",
          "The motion exceeds the velocity limit of the axis.",
          "Stretch the motion, or choose a law with a lower peak velocity."},
    Entry{Cause::acceleration_limit, "acceleration_limit",
          "The motion exceeds the acceleration limit of the axis.",
          "Stretch the motion, or choose a law with a lower peak acceleration."},
    Entry{Cause::jerk_limit, "jerk_limit", "The motion exceeds the jerk limit of the axis.",
          "Stretch the motion, or choose a law with a lower peak jerk."},
    Entry{Cause::position_step, "position_step", "The position jumps.",
          "A cam that wraps must end where it begins. For a cam that gains a distance in each "
          "period, use outside = \"advance\"."},
    Entry{Cause::velocity_step, "velocity_step",
          "The velocity jumps by more than the acceleration limit permits in one tick.",
          "Smooth the table there: use more points, or cubic interpolation."},
    Entry{Cause::acceleration_step, "acceleration_step",
          "The acceleration jumps by more than the jerk limit permits in one tick.",
          "Use a profile with limited jerk: a trapezoid has steps of the acceleration."},
    Entry{Cause::wrong_unit, "wrong_unit",
          "The unit of the table differs from the unit of the axis.",
          "Export the table in the unit of the axis."},
    Entry{Cause::no_master_input, "no_master_input",
          "The axis has no live master: [follow] names none, or the master is lost.",
          "Give the axis a master in [follow], wait until it sends, or send the master as a "
          "table over time."},
    Entry{Cause::would_reverse, "would_reverse",
          "The axis could reach its cam only against the direction of its start mode.",
          "Use start mode ramp_in, or begin on the other side of the cam."},
    Entry{
        Cause::master_stands, "master_stands",
        "A ramp over a master distance cannot begin while the master is at standstill.",
        "Use start mode ramp_in, begin where the slope of the cam is 0, or move the master first."},
    Entry{Cause::no_ramp, "no_ramp", "No ramp within the limits brings the axis onto its cam.",
          "Raise the limits of the ramp, or slow the master down."},
    Entry{Cause::not_in_sync, "not_in_sync", "The master ends before the axis has reached its cam.",
          "Give a shorter distance of the ramp, or a longer travel of the master."},
    Entry{Cause::home_timeout, "home_timeout", "The homing took longer than its timeout.",
          "Give a longer timeout or a higher search velocity; check that the override is not 0."},
    Entry{Cause::home_not_found, "home_not_found",
          "The search reached the second limit switch or its greatest distance before it found the "
          "switch of the homing method.",
          "Check the wiring of the switch, or choose another method."},
    Entry{Cause::index_not_found, "index_not_found",
          "The search for the index went further than its distance.",
          "Make the distance greater than one turn, and check the index of the encoder."},
    Entry{Cause::both_switches, "both_switches",
          "Both limit switches were on during the homing: check their wiring.",
          "Check the wiring and the supply of both limit switches."},
    Entry{Cause::not_homed, "not_homed",
          "The axis is not homed, and its spec has require_home: home it first.",
          "Home the axis: `jounce order NAME home`. A move by a distance is permitted before."},
    Entry{Cause::no_such_method, "no_such_method",
          "The homing method must be 1 to 14, 17 to 30, 33, 34, 35 or 37 (CiA 402).",
          "Choose one of the methods: see docs/executor/homing.md."},
    Entry{Cause::no_sensor, "no_sensor",
          "The drive reports no switch or index that the homing method needs: choose another "
          "method, or add [drive.machine] to the axis's spec.",
          "Choose a method for the switches that the machine has."},
    Entry{Cause::stopped, "stopped", "Stopped on request.", "Nothing."},
    Entry{Cause::halted, "halted", "Halted on request.", "Nothing."},
    Entry{Cause::pass_ended, "pass_ended",
          "Finished at the end of the current cycle, as requested.", "Nothing."},
    Entry{Cause::replaced, "replaced", "Replaced by another motion.",
          "Nothing. To keep a motion, send the next one with a buffer mode."},
    Entry{Cause::released, "released",
          "The hold-to-run command ended: the session released it, or sent no heartbeat.",
          "Press the button again, or check the link of the operator."},
    Entry{Cause::group_stopped, "group_stopped",
          "Another axis of the same start did not start, was stopped, or failed.",
          "Look at the other axes of the start: one of them has the reason."},
};

/// True for the rejections with a measured value and a limit.
bool is_measured(Cause cause) {
  return cause >= Cause::start_position && cause <= Cause::acceleration_step;
}

/// " mm/s", the unit of the numbers of a rejection; "" if it is not known.
std::string unit_of(Cause cause, const std::string& unit) {
  if (unit.empty() || cause == Cause::master_outside_cam) return "";
  switch (cause) {
    case Cause::start_velocity:
    case Cause::end_velocity:
    case Cause::velocity_limit:
    case Cause::velocity_step:
      return " " + unit + "/s";
    case Cause::acceleration_limit:
    case Cause::acceleration_step:
      return " " + unit + "/s^2";
    case Cause::jerk_limit:
      return " " + unit + "/s^3";
    default:
      return " " + unit;
  }
}

const Entry& entry(Cause cause) {
  const auto* const found = std::find_if(entries.begin(), entries.end(),
                                         [&](const Entry& e) { return e.cause == cause; });
  return found == entries.end() ? entries.front() : *found;
}

}  // namespace

std::span<const CauseInfo> all_causes() {
  return entries;
}

const char* name(Cause cause) {
  return entry(cause).name;
}

const char* meaning(Cause cause) {
  return entry(cause).meaning;
}

std::string text(const Refusal& refusal, const std::string& unit) {
  const Cause cause = refusal.cause;
  std::string words = std::string(name(cause)) + ": " + meaning(cause);
  if (!is_measured(cause)) return words;
  words.pop_back();  // the full stop: the numbers follow
  const auto shown = [&](double number) { return six_digits(number) + unit_of(cause, unit); };
  if (cause == Cause::start_position)
    return words + ": " +
           (std::isnan(refusal.value) ? "" : "it begins at " + shown(refusal.value) + ", ") +
           "the axis stands at " + shown(refusal.limit) + ".";
  const std::string instant =
      std::isnan(refusal.where) ? "" : " at " + six_digits(refusal.where) + " s";
  return words + ": " + shown(refusal.value) + instant + ", limit " + shown(refusal.limit) + ".";
}

std::string Refusal::text() const {
  return jounce::text(*this, "");
}

}  // namespace jounce
