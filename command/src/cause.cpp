// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "jounce/command/commands.hpp"
#include "jounce/command/detail/causes.hpp"
#include "jounce/command/detail/refusal_text.hpp"
#include "jounce/profiles/detail/digits_beside.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce {
namespace {

using Entry = CauseInfo;

constexpr std::array entries{
    Entry{Cause::none, "none", "Nothing is wrong.", "Nothing."},
    Entry{Cause::aborted, "aborted",
          "Aborted on request: the setpoint has stayed where it was at the abort.",
          "Remove the reason for the abort, send `jounce order NAME reset`, and then the motion "
          "again."},
    Entry{Cause::disabled_in_motion, "disabled_in_motion",
          "The axis was disabled in motion: the setpoint has stayed where it was then.",
          "Find out who disabled the axis: the drive, an operator, or a second program. Then send "
          "`jounce order NAME reset` and `jounce order NAME enable`."},
    Entry{
        Cause::stalled, "stalled",
        "During a motion, a cycle was late by longest_gap or more: the setpoint would have jumped.",
        "Run the executor with --realtime on a real-time kernel, or raise longest_gap in [axis]. "
        "Then send `jounce order NAME reset`."},
    Entry{Cause::overspeed, "overspeed",
          "The next setpoint needs a velocity above the limit of the axis.",
          "With a live master: slow the master down, or raise the velocity limit of the axis. With "
          "a table: report a defect, because the table was checked before it started."},
    Entry{Cause::out_of_range, "out_of_range",
          "The next setpoint is outside position_min and position_max.",
          "With a live master: shorten its travel, or shift the cam. With a table: report a "
          "defect, because the table was checked before it started."},
    Entry{
        Cause::following_error, "following_error",
        "The following error exceeded its limit (following_error) for longer than following_time.",
        "Check the load, the brake and the tuning of the drive; `jounce validate` shows the torque "
        "that the motion needs. Then send `jounce order NAME reset`."},
    Entry{Cause::positive_soft_limit, "positive_soft_limit",
          "The motion would have passed position_max: the axis stopped before it.",
          "Send `jounce order NAME reset`, then move the axis in the negative direction."},
    Entry{Cause::negative_soft_limit, "negative_soft_limit",
          "The motion would have passed position_min: the axis stopped before it.",
          "Send `jounce order NAME reset`, then move the axis in the positive direction."},
    Entry{Cause::positive_switch, "positive_switch", "The axis reached the positive limit switch.",
          "Send `jounce order NAME reset`, then move the axis off the switch in the negative "
          "direction."},
    Entry{Cause::negative_switch, "negative_switch", "The axis reached the negative limit switch.",
          "Send `jounce order NAME reset`, then move the axis off the switch in the positive "
          "direction."},
    Entry{
        Cause::underrun, "underrun",
        "Buffer underrun: the rows of the streamed path arrived too slowly, so the axis stopped on "
        "its path.",
        "Send `jounce order NAME reset`, then stream again, with more rows before the start "
        "(--ahead). A program that sends its own rows can also reset the axis, send more rows, and "
        "resume."},
    Entry{Cause::watchdog, "watchdog",
          "Watchdog expired: no heartbeat from the program that streams, or from the communication "
          "thread of the executor.",
          "Check that the streaming program is still running, that the network is up, and that the "
          "executor gets enough CPU time; session_timeout in [axis] and --watchdog are the limits. "
          "Then send `jounce order NAME reset`."},
    Entry{Cause::drive_fault, "drive_fault", "The drive reports a fault.",
          "Read the fault number of the drive and remove its cause. Then reset the drive, and send "
          "`jounce order NAME reset`."},
    Entry{Cause::drive_not_ready, "drive_not_ready",
          "The drive stopped following setpoints while it was enabled.",
          "Check the enable signal, the safe torque off (STO) and the bus voltage of the drive. "
          "Then send `jounce order NAME reset`."},
    Entry{
        Cause::master_lost, "master_lost", "The axis receives no valid position of its master.",
        "If the master is an axis, remove its fault and enable it. Otherwise check its encoder, or "
        "the program that sends its position, and the connection. Then send `jounce order NAME "
        "reset`."},
    Entry{
        Cause::jump, "jump",
        "The next setpoint is not a finite number, or needs more than stop_acceleration.",
        "With a live master: use a smaller gear ratio or a gentler cam, lower the acceleration of "
        "the master, or filter its measured position. With a follow table, the fault also occurs "
        "where the master reverses, or moves back beyond the beginning of a pass: reverse the "
        "master where the ratio is 0, or use a cam. With a table over time: report a defect, "
        "because the table was checked before it started."},
    Entry{Cause::overacceleration, "overacceleration",
          "The master requires an acceleration above the limit of the axis.",
          "Lower the acceleration or the velocity of the master, use a smaller gear ratio or a "
          "gentler cam, or raise acceleration in the [limits] of the axis. Then send `jounce order "
          "NAME reset`."},
    Entry{Cause::master_reversed, "master_reversed",
          "The master reversed while the slave engaged with it.",
          "Send `jounce order NAME reset`, and engage while the master moves in its normal "
          "direction."},
    Entry{
        Cause::axis_fault, "axis_fault",
        "An axis of the group has a fault, was stopped or was disabled: the group stopped on its "
        "path.",
        "Find the axis with `jounce monitor`, remove the cause, and send `jounce order AXIS reset` "
        "and `jounce order AXIS enable`. Then send `jounce order GROUP reset`; `jounce order GROUP "
        "resume` continues the path."},
    Entry{Cause::marks_lost, "marks_lost",
          "Registration lost its marks: too many products in succession had no mark in the window.",
          "Check the mark sensor and the film. If the marks drift further than expected, raise "
          "window in [registration]. Then send `jounce order NAME reset`, and start the motion "
          "again."},
    Entry{Cause::not_enabled, "not_enabled", "The axis or group is disabled.",
          "Enable it: `jounce order NAME enable`."},
    Entry{
        Cause::in_error, "in_error", "The axis or group has a fault.",
        "`jounce monitor NAME` shows the fault, and `jounce explain FAULT` its remedy. After most "
        "faults, `jounce order NAME reset` is necessary, for some before the axis can move away "
        "from the cause."},
    Entry{Cause::in_motion, "in_motion", "The axis or group is moving.",
          "Wait for standstill, or end the motion: `jounce order NAME halt`. `jounce order NAME "
          "finish` lets a table that repeats end with its present pass.",
          "Wait for standstill, or end the motion: `jounce order NAME halt`."},
    Entry{Cause::not_armed, "not_armed", "No table is armed.",
          "Send a table and arm it. After a stop, the table must be armed again."},
    Entry{Cause::not_at_start, "not_at_start",
          "The axis is not at the position where the armed table begins.",
          "The axis was moved, or its position was set, after the table was armed: move the axis "
          "to the start of the table, or arm the table again."},
    Entry{
        Cause::too_late, "too_late", "The requested start tick has passed.",
        "Give a later tick, or a time from now, such as `--at +1`. A table must arrive completely "
        "before its start tick. `jounce monitor NAME --json` shows the present tick.",
        "Give a later tick, or a time from now, such as `--at +1`."},
    Entry{Cause::no_value, "no_value",
          "The table or the number of the command is missing or not finite.",
          "Send the command with its table, or with a finite number."},
    Entry{Cause::leaving, "leaving", "The executor is shutting down and accepts no more tables.",
          "Start the executor again."},
    Entry{Cause::synchronized, "synchronized", "The axis is following a master.",
          "End the coupling: `jounce order NAME halt`. After `gear-out` and `cam-out`, the axis "
          "keeps its velocity."},
    Entry{Cause::stopping, "stopping", "A stop is in progress.", "Wait until the axis is at rest."},
    Entry{
        Cause::not_on_path, "not_on_path", "The command does not apply to the present motion.",
        "`finish` ends a table that repeats, or a repetitive move; `jounce order NAME halt` ends a "
        "move. A slave of a live master stops with `jounce stop NAME`, and slows down with its "
        "master."},
    Entry{Cause::no_movement, "no_movement",
          "The command changes a motion, but no motion is in progress.",
          "Start a motion first. With --at-next-cut, a cam must be in progress.",
          "Start a motion first.", "With --at-next-cut, a cam must be in progress."},
    Entry{Cause::not_synchronized, "not_synchronized", "The axis is not following a master.",
          "For phasing: engage the axis with its master first (`jounce order NAME gear-in 1:1`, or "
          "`jounce stream --live`). For gear-out and cam-out: nothing, the axis is not engaged."},
    Entry{Cause::direction_blocked, "direction_blocked",
          "The limit switch in the direction of the motion is active.",
          "Move the axis in the other direction, off the limit switch."},
    Entry{Cause::rate_changing, "rate_changing",
          "The axis is changing its speed on the path, after a hold, a resume or an override.",
          "Repeat the command when the speed is constant."},
    Entry{Cause::no_such_move, "no_such_move",
          "No move from the present state to that target keeps the limits and the direction.",
          "Choose the other direction, a target farther away, a lower velocity, or higher limits."},
    Entry{Cause::halting, "halting", "A halt is in progress.",
          "Send a new motion, or wait until the axis is at rest."},
    Entry{Cause::buffer_full, "buffer_full",
          "The buffer is full: at most eight moves and one command for a tick can wait.",
          "Wait until one of the waiting motions begins."},
    Entry{Cause::not_positive, "not_positive",
          "A velocity, acceleration, deceleration or jerk of the command is not greater than 0.",
          "Give a number greater than 0, or leave the option out to use the limit of the axis."},
    Entry{Cause::no_reserve, "no_reserve",
          "The present motion leaves no reserve for a superimposed move.",
          "Begin the present motion with a lower --velocity, --acceleration, --deceleration and "
          "--jerk (each is the limit of the axis by default), or wait for its end."},
    Entry{Cause::bad_table, "bad_table", "The tables do not form a motion.",
          "Send one table over time, or two tables: a cam over its master, and the master over "
          "time."},
    Entry{
        Cause::start_position, "start_position",
        "The table does not begin at the position of the axis.",
        "Move the axis to the start of the table (`jounce order NAME move --to POSITION`). A table "
        "over time also begins at the position of the axis with --rolling --relative, or at any "
        "position of an axis at rest if the executor was started with --adopt-start. With a live "
        "master, use the `cutter` of the axis with `jounce order NAME start`, or start = "
        "\"ramp_in\" with velocity_diff and acceleration in [coupling]; while the master rests, "
        "move the axis to the cam.",
        "Or start the executor with --adopt-start.", "Or start the executor with --adopt-start."},
    Entry{Cause::start_velocity, "start_velocity", "The table does not begin at rest.",
          "Add a ramp at the start. The permitted step of the velocity is the acceleration limit "
          "times one cycle."},
    Entry{Cause::end_velocity, "end_velocity", "The table does not end at rest.",
          "Add a ramp at the end. The permitted step of the velocity is the acceleration limit "
          "times one cycle."},
    Entry{Cause::not_closed, "not_closed",
          "The table repeats, but its last position differs from its first.",
          "Let the table end at the position where it begins, or use outside = \"hold\"."},
    Entry{Cause::master_outside_cam, "master_outside_cam",
          "The master leaves the range of the cam, and the cam has no values outside.",
          "Shorten the travel of the master, or give the cam outside = \"hold\", \"wrap\" or "
          "\"advance\"."},
    Entry{Cause::position_limit, "position_limit", "A position is outside the position range.",
          "Give a position inside the range, shift or shorten the motion, or widen position_min "
          "and position_max in the spec of the axis.",
          "Give a position inside the range.",
          "Shift or shorten the motion, or widen position_min and position_max in the spec of the "
          "axis."},
    Entry{Cause::start_jump, "start_jump",
          "At this start, the master requires a velocity that the axis does not have.",
          "Use start = \"ramp_in\" with velocity_diff and acceleration in [coupling], start while "
          "the master rests, or give a --start-at where the slave of the cam rests."},
    Entry{Cause::velocity_limit, "velocity_limit",
          "The motion exceeds the velocity limit of the axis.",
          "Give a lower velocity. For a table: give it more time, or a law with a lower peak "
          "velocity.",
          "Give a lower velocity.",
          "Give the motion more time (behind a live master: run it slower), or a law with a lower "
          "peak velocity."},
    Entry{Cause::acceleration_limit, "acceleration_limit",
          "The motion exceeds the acceleration limit of the axis.",
          "Give a lower acceleration. For a table: give it more time, or a law with a lower "
          "peak acceleration.",
          "Give a lower acceleration.",
          "Give the motion more time (behind a live master: run it slower), or a law with a lower "
          "peak acceleration."},
    Entry{Cause::jerk_limit, "jerk_limit", "The motion exceeds the jerk limit of the axis.",
          "Give a lower jerk. For a table: give it more time, or a law with a lower peak jerk.",
          "Give a lower jerk.", "Give the motion more time, or a law with a lower peak jerk."},
    Entry{Cause::position_step, "position_step", "The position of the table jumps.",
          "A cam that wraps must end where it begins. For a cam that gains a distance in each "
          "period, use outside = \"advance\"."},
    Entry{
        Cause::velocity_step, "velocity_step",
        "The velocity of the table jumps by more than the acceleration limit permits in one cycle.",
        "Smooth the table there: use more points, or rule = \"cubic_hermite\"."},
    Entry{Cause::acceleration_step, "acceleration_step",
          "The acceleration of the table jumps by more than the jerk limit permits in one cycle.",
          "Use a motion whose acceleration does not jump: s_curve instead of trapezoid, a law for "
          "which `jounce laws` reports no step of the acceleration, or a PVT table with "
          "accelerations."},
    Entry{Cause::wrong_unit, "wrong_unit",
          "The unit of the table differs from the unit of the axis.",
          "Change the units in the spec of the table, or in the spec of the axis: both must be the "
          "same."},
    Entry{
        Cause::no_master_input, "no_master_input",
        "The axis has no live master: its spec has no [follow], or the master sends no "
        "position in the unit that [follow] expects.",
        "Add [follow] to the spec of the axis, start the program of the master, or correct the "
        "unit of the master. Without a "
        "live master, send the motion of the master as a table over time.",
        "Add follow = { axis = \"NAME\" } to its [[axis]] in the machine spec, or [follow] to the "
        "spec of the axis, start the program of the master, or correct the unit of the master."},
    Entry{Cause::would_reverse, "would_reverse",
          "The axis can reach its cam only against the direction of its start mode.",
          "Use start = \"ramp_in\", or begin on the other side of the cam."},
    Entry{Cause::master_stands, "master_stands",
          "A ramp over a master distance cannot begin while the master is at standstill.",
          "Use start = \"ramp_in\", start where the slope of the cam is 0, or move the master "
          "first."},
    Entry{Cause::no_ramp, "no_ramp", "No ramp within the limits brings the axis onto its cam.",
          "Raise the limits of the ramp in [coupling], or slow the master down."},
    Entry{Cause::not_in_sync, "not_in_sync",
          "The master reaches its end before the axis has reached its cam.",
          "Shorten the distance of the ramp, or lengthen the travel of the master."},
    Entry{
        Cause::home_timeout, "home_timeout", "The homing took longer than its timeout.",
        "Raise the timeout or the search velocity (--timeout, --search-velocity, or [homing]), and "
        "check that the override is not 0."},
    Entry{Cause::home_not_found, "home_not_found",
          "The search reached the other limit switch before it found the switch of the homing "
          "method.",
          "Check the wiring of the switch, or choose another method."},
    Entry{
        Cause::index_not_found, "index_not_found",
        "The search for the index pulse moved its whole distance without finding it.",
        "Make this distance (--distance, or distance in [homing]) greater than one turn, and check "
        "the index of the encoder."},
    Entry{Cause::both_switches, "both_switches", "Both limit switches were on during the homing.",
          "Check the wiring and the supply of both limit switches."},
    Entry{Cause::search_distance, "search_distance",
          "The search moved its whole distance without finding the switch of the homing method.",
          "Check the wiring of the switch, or give a greater distance (--distance, or distance in "
          "[homing])."},
    Entry{Cause::not_homed, "not_homed", "The axis is not homed, and the command requires it.",
          "Enable the axis and home it: `jounce order NAME home`. A move by a distance (--by) is "
          "permitted before the homing.",
          "Home it: `jounce order NAME home`. A move by a distance (--by) is permitted before the "
          "homing.",
          "Home it: `jounce order NAME home`."},
    Entry{Cause::no_such_method, "no_such_method", "The homing method does not exist.",
          "Choose one of the methods of CiA 402: 1 to 14, 17 to 30, 33, 34, 35 or 37 (see "
          "docs/executor/homing.md)."},
    Entry{
        Cause::no_sensor, "no_sensor",
        "The drive does not report the switch or the index that the homing method needs.",
        "Choose a method for the switches that the machine has. For a simulated drive, add "
        "home_switch, negative_switch, positive_switch or index to [drive.machine] in the spec of "
        "the axis."},
    Entry{Cause::in_group, "in_group",
          "The axis belongs to an enabled group, which alone moves it.",
          "Command the group, or disable it first: `jounce order GROUP disable`."},
    Entry{
        Cause::single_axis, "single_axis", "The command applies to a single axis, not to a group.",
        "Send the command to an axis of the group, while the group is disabled. A group moves with "
        "`move-linear`, and jogs with `jog --along`. For a table: stream it to an axis while the "
        "group is disabled; a group plays a path.",
        "Send the command to an axis of the group, while the group is disabled.",
        "Stream the table to an axis of the group, while the group is disabled. A group plays a "
        "path: a spec of kind \"path\", or a G-code program."},
    Entry{Cause::axis_not_ready, "axis_not_ready", "An axis of the group is not ready.",
          "Enable, home or reset the axis, or wait for its standstill; then repeat the command."},
    Entry{Cause::axis_away, "axis_away",
          "An axis of the group is not where the path begins or continues.",
          "Before `start`, move the group there with `jounce order NAME move-linear`. Otherwise "
          "disable the group, which is not necessary after a fault of the group, move the axis "
          "there, and enable the group. Then repeat the command."},
    Entry{
        Cause::not_a_group, "not_a_group", "The name belongs to a single axis, not to a group.",
        "Use `jounce order NAME move --to POSITION`. For a table: choose one axis of the path with "
        "--axis.",
        "Send the command to a group.",
        "Choose one axis of the path with --axis, or send the path to a group."},
    Entry{
        Cause::no_trigger_input, "no_trigger_input",
        "The drive of the axis does not have this trigger input.",
        "Choose an input that the drive has, or connect this one. For a simulated drive, add "
        "[[drive.machine.marks]] (1 to 4), or home_switch or index in [drive.machine], to the spec "
        "of the axis."},
    Entry{
        Cause::no_touch_probe, "no_touch_probe", "No touch probe waits at this input.",
        "No abort-trigger is needed: the touch probe has made its captures, or was never started."},
    Entry{Cause::probe_window, "probe_window",
          "The window of the touch probe contains no position that the axis can reach.",
          "Give a first position below the last position, both within the position range of the "
          "axis. On a modulo axis, the window may extend beyond the end of the turn."},
    Entry{Cause::not_a_move, "not_a_move",
          "The command changes a move or a jog, but the axis plays another motion.",
          "Use `override` to change the speed of a table. A jog of 0 has no velocity to change."},
    Entry{Cause::stopped, "stopped", "Stopped on request.", "Nothing."},
    Entry{Cause::halted, "halted", "Halted on request.", "Nothing."},
    Entry{Cause::pass_ended, "pass_ended", "Finished at the end of the current pass, as requested.",
          "Nothing."},
    Entry{Cause::replaced, "replaced", "Another motion took its place.",
          "Nothing. To finish a motion first, send the next one with --buffered or --blend."},
    Entry{Cause::released, "released",
          "The hold-to-run command ended: the button was released, or its heartbeat is missing.",
          "Press the button again, or check the connection to the operator's device."},
    Entry{Cause::group_stopped, "group_stopped",
          "Another axis of the same start did not start, was stopped, or had a fault.",
          "Look at the other axes of this start: one of them reports the reason."},
    Entry{Cause::range_end, "range_end",
          "The jog of the group ended where an axis reaches the end of its position range.",
          "Nothing. The notices of the executor name the axis and the place."},
    Entry{Cause::reach_end, "reach_end",
          "The jog of the group ended at the last place that its joints can reach.",
          "Nothing. Jog in another direction."},
    Entry{
        Cause::singular_end, "singular_end",
        "The jog of the group ended before a singular position, where a joint limits its velocity "
        "to 1 %.",
        "Jog back, or move the joints past the position with `jounce order GROUP move-direct "
        "--fast`."},
    Entry{Cause::awaits_acknowledge, "awaits_acknowledge",
          "The group rests at an M word, or in single step, and waits for an acknowledgment.",
          "Do what the M word requires, then send `jounce order GROUP acknowledge`."},
    Entry{Cause::no_acknowledge, "no_acknowledge",
          "An M word was not acknowledged in time: the group dropped the commands after it.",
          "Check the program that acknowledges the M word, or raise its timeout. Then send the "
          "commands again."},
    Entry{Cause::no_handshake, "no_handshake", "The group does not wait for this acknowledgment.",
          "Send `acknowledge` only while the group rests in single step, or at an M word. For an M "
          "word, `jounce monitor NAME --events` shows its number."},
    Entry{Cause::no_start_tick, "no_start_tick",
          "The command takes effect at once, not at a given tick.", "Leave out --at."},
    Entry{Cause::nothing_to_start, "nothing_to_start",
          "The spec has no table, cutter or program to start.",
          "Send a table or a path with `jounce stream`."},
    Entry{Cause::no_cut_plan, "no_cut_plan", "The axis does not cut: no plan of cuts is running.",
          "Start the plan of its cutter: `jounce order NAME start`."},
    Entry{Cause::cut_length, "cut_length",
          "The cutter cannot make a piece of this length at the speed of its line.",
          "Give a possible length. For shorter pieces, run a slower line: lower the line speed in "
          "the spec of the cutter. `jounce map` computes the greatest line speed for each length."},
    Entry{Cause::cut_position, "cut_position", "The cut would be before the next possible cut.",
          "Give a later position, or leave out --position to cut at the next possible one."},
    Entry{Cause::cut_pending, "cut_pending",
          "A cut on demand waits, and would not be possible after this change.",
          "Repeat the command after this cut, or replace the cut first: `jounce order NAME cut`, "
          "with or without --position."},
    Entry{Cause::cut_too_far, "cut_too_far",
          "The cut is too far ahead: at most 1000 planned cuts may come before it.",
          "Give a nearer position."},
    Entry{Cause::in_cut_plan, "in_cut_plan",
          "The axis plays a plan of cuts: a shift would move its cutter against the web.",
          "To move all later cuts along the web, make one piece longer or shorter: `jounce order "
          "NAME cut --waste LENGTH`."},
    Entry{Cause::web_stands, "web_stands",
          "The web does not move forward, so no next cut is possible at once.",
          "Give the position of the cut (--position), or repeat the command when the web moves "
          "forward."},
    Entry{Cause::cutter_away, "cutter_away", "The cutter does not stand at its home position.",
          "Move the axis to its home position: `jounce order NAME move --to POSITION`."},
    Entry{Cause::no_compensation, "no_compensation", "The spec of the axis has no compensation.",
          "Add [compensation] with its table to the spec of the axis."},
    Entry{Cause::compensation_active, "compensation_active",
          "The compensation of the axis, or of an axis that refers to it, is active.",
          "Disable that axis, and switch its compensation off: `jounce order NAME "
          "disable-compensation`."},
    Entry{Cause::compensation_inactive, "compensation_inactive",
          "The compensation of the axis is not active.", "No disable-compensation is needed."},
    Entry{Cause::enabled, "enabled", "The command needs a disabled axis, and the axis is enabled.",
          "If the axis is not homed, home it. Then disable it, send the command, and enable it "
          "again."},
};

/// The remedy of a cause for one kind of order.
struct OrderRemedy {
  Cause cause;
  CommandKind kind;
  const char* remedy;
};

constexpr const char* other_way = "Give a shorter distance.";
constexpr const char* inside_or_wider =
    "Give a position inside the range, or widen position_min and position_max in the spec of the "
    "axis.";
constexpr const char* longer_clutch = "Give a longer --clutch, or slow the master down.";
constexpr const char* longer_start = "Give a longer --start-distance, or slow the master down.";
constexpr const char* smaller_ratio = "Give a smaller ratio, or slow the master down.";
constexpr const char* smaller_shift =
    "The axis follows its master and shifts at the same time, so the limit applies to the sum. "
    "Leave out "
    "--velocity, --acceleration and --jerk: the shift then uses what the limits leave. Or give "
    "lower "
    "values, in the unit of the master.";
constexpr const char* engage_first =
    "First engage the axis with its master: `jounce order NAME gear-in 1:1`, or `jounce "
    "stream --live`.";

constexpr const char* move_instead =
    "Move the axis: `jounce order NAME move --to POSITION`. A coordinate move needs a group.";
constexpr const char* each_axis =
    "Send the command to each axis of the group, while the group is disabled.";
constexpr const char* group_move =
    "A group moves with `move-linear`, and jogs with `jog --along`. A single axis moves while its "
    "group is disabled.";
constexpr const char* hold_of_slave = "A slave rests only with its master: hold the master.";
constexpr const char* hold_of_homing =
    "A homing cannot be held or resumed: `jounce order NAME halt` ends it.";
constexpr const char* nothing_to_hold = "Nothing moves: no hold is needed.";

constexpr std::array order_remedies{
    OrderRemedy{Cause::position_limit, CommandKind::move_velocity, "Jog in the other direction."},
    OrderRemedy{Cause::position_limit, CommandKind::move_relative, other_way},
    OrderRemedy{Cause::position_limit, CommandKind::move_additive, other_way},
    OrderRemedy{Cause::position_limit, CommandKind::move_superimposed, other_way},
    OrderRemedy{Cause::position_limit, CommandKind::home, inside_or_wider},
    OrderRemedy{Cause::position_limit, CommandKind::set_position, inside_or_wider},
    OrderRemedy{Cause::velocity_limit, CommandKind::home,
                "Give a lower search_velocity and index_velocity in [homing] of the spec of the "
                "axis, or --search-velocity and --index-velocity."},
    OrderRemedy{Cause::acceleration_limit, CommandKind::home,
                "Give a lower acceleration in [homing] of the spec of the axis, or "
                "--acceleration."},
    OrderRemedy{Cause::velocity_limit, CommandKind::gear_in, smaller_ratio},
    OrderRemedy{Cause::velocity_limit, CommandKind::gear_in_pos, smaller_ratio},
    OrderRemedy{Cause::acceleration_limit, CommandKind::gear_in, longer_clutch},
    OrderRemedy{Cause::acceleration_limit, CommandKind::gear_in_pos, longer_start},
    OrderRemedy{Cause::jerk_limit, CommandKind::gear_in, longer_clutch},
    OrderRemedy{Cause::jerk_limit, CommandKind::gear_in_pos, longer_start},
    OrderRemedy{Cause::velocity_limit, CommandKind::phasing_absolute, smaller_shift},
    OrderRemedy{Cause::velocity_limit, CommandKind::phasing_relative, smaller_shift},
    OrderRemedy{Cause::acceleration_limit, CommandKind::phasing_absolute, smaller_shift},
    OrderRemedy{Cause::acceleration_limit, CommandKind::phasing_relative, smaller_shift},
    OrderRemedy{Cause::jerk_limit, CommandKind::phasing_absolute, smaller_shift},
    OrderRemedy{Cause::jerk_limit, CommandKind::phasing_relative, smaller_shift},
    OrderRemedy{Cause::in_motion, CommandKind::move_repetitive,
                "End the present motion first: `jounce order NAME halt` ends a move, `jounce order "
                "NAME finish` ends a repetitive move or a table that repeats."},
    OrderRemedy{Cause::in_motion, CommandKind::gear_in_pos,
                "gear-in-pos needs an axis at standstill: `jounce order NAME halt` ends a coupling "
                "or a move. In motion, use `gear-in`."},
    OrderRemedy{Cause::in_motion, CommandKind::hold, hold_of_homing},
    OrderRemedy{Cause::in_motion, CommandKind::resume, hold_of_homing},
    OrderRemedy{Cause::not_on_path, CommandKind::hold, hold_of_slave},
    OrderRemedy{Cause::not_on_path, CommandKind::resume,
                "A slave moves with its master: no resume is needed."},
    OrderRemedy{
        Cause::not_on_path, CommandKind::finish,
        "`finish` ends a table that repeats, or a repetitive move. `jounce order NAME halt` "
        "ends any other motion."},
    OrderRemedy{Cause::not_homed, CommandKind::enable_compensation,
                "Enable the axis, home it (`jounce order NAME home`), disable it, and repeat the "
                "command."},
    OrderRemedy{Cause::no_movement, CommandKind::hold, nothing_to_hold},
    OrderRemedy{Cause::not_a_group, CommandKind::move_linear_absolute, move_instead},
    OrderRemedy{Cause::not_a_group, CommandKind::move_linear_relative, move_instead},
    OrderRemedy{Cause::not_a_group, CommandKind::move_circular_absolute, move_instead},
    OrderRemedy{Cause::not_a_group, CommandKind::move_circular_relative, move_instead},
    OrderRemedy{Cause::not_a_group, CommandKind::move_direct_absolute, move_instead},
    OrderRemedy{Cause::not_a_group, CommandKind::move_direct_relative, move_instead},
    OrderRemedy{Cause::not_a_group, CommandKind::group_set_override,
                "Send the command to a group, or override the axis: `jounce order NAME override "
                "50%`."},
    OrderRemedy{Cause::not_a_group, CommandKind::group_set_limits,
                "Send the command to a group. For an axis, give the limits with each move, or in "
                "[limits] of its spec."},
    OrderRemedy{Cause::not_a_group, CommandKind::group_set_position,
                "Set the position of the axis: `jounce order NAME set-position POSITION`. Only a "
                "group has --to."},
    OrderRemedy{Cause::not_a_group, CommandKind::group_jog,
                "Jog the axis: `jounce order NAME jog VELOCITY`. Only a group jogs --along."},
    OrderRemedy{Cause::single_axis, CommandKind::home, each_axis},
    OrderRemedy{Cause::single_axis, CommandKind::move_absolute, group_move},
    OrderRemedy{Cause::single_axis, CommandKind::move_relative, group_move},
    OrderRemedy{Cause::single_axis, CommandKind::move_additive, group_move},
    OrderRemedy{Cause::single_axis, CommandKind::move_superimposed, group_move},
    OrderRemedy{Cause::single_axis, CommandKind::move_velocity, group_move},
    OrderRemedy{Cause::single_axis, CommandKind::finish,
                "A group plays its path once: `jounce order NAME halt` ends it."},
    OrderRemedy{Cause::single_axis, CommandKind::change_velocity,
                "Change the speed of the group: `jounce order NAME override 50%`."},
    OrderRemedy{Cause::single_axis, CommandKind::override_,
                "Override the group: `jounce order NAME set-override --velocity-factor 50%`."},
    OrderRemedy{Cause::single_axis, CommandKind::set_position,
                "Disable the group, then send the command to one of its axes: `jounce order AXIS "
                "set-position POSITION`."},
    OrderRemedy{Cause::single_axis, CommandKind::enable_compensation, each_axis},
    OrderRemedy{Cause::single_axis, CommandKind::disable_compensation, each_axis},
    OrderRemedy{Cause::no_compensation, CommandKind::disable_compensation,
                "Nothing is compensated: no disable-compensation is needed."},
    OrderRemedy{Cause::compensation_active, CommandKind::enable_compensation,
                "No enable-compensation is needed."},
    OrderRemedy{Cause::no_movement, CommandKind::resume, "Nothing is held: no resume is needed."},
    OrderRemedy{Cause::not_synchronized, CommandKind::gear_out, "No gear-out is needed."},
    OrderRemedy{Cause::not_synchronized, CommandKind::cam_out, "No cam-out is needed."},
    OrderRemedy{Cause::not_synchronized, CommandKind::phasing_absolute, engage_first},
    OrderRemedy{Cause::not_synchronized, CommandKind::phasing_relative, engage_first}};

/// True for the rejections with a measured value and a limit.
bool is_measured(Cause cause) {
  return cause >= Cause::start_position && cause <= Cause::acceleration_step;
}

/// True for the rejections of cuts, whose numbers count in the unit of the master.
bool is_cut(Cause cause) {
  return (cause >= Cause::cut_length && cause <= Cause::cut_pending) || cause == Cause::cut_too_far;
}

/// The numbers of such a rejection.
std::string cut_text(const Refusal& refusal, const std::string& unit) {
  const auto at = [&](double number) {
    return six_digits(number) + (unit.empty() ? "" : " " + unit);
  };
  if (refusal.cause == Cause::cut_length)
    return at(refusal.value) + ", nearest possible length " + at(refusal.limit);
  if (refusal.cause == Cause::cut_pending) return "it is at " + at(refusal.limit);
  if (refusal.cause == Cause::cut_too_far)
    return "cut at " + at(refusal.value) + ", last possible cut at " + at(refusal.limit);
  return "cut at " + at(refusal.value) + ", next possible cut at " + at(refusal.limit);
}

/// " mm/s", the unit of the numbers of a rejection; "" if it is not known.
std::string unit_of(Cause cause, const std::string& unit) {
  if (unit.empty() || cause == Cause::master_outside_cam) return "";
  switch (cause) {
    case Cause::start_velocity:
    case Cause::end_velocity:
    case Cause::velocity_limit:
    case Cause::velocity_step:
    case Cause::start_jump:
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

/// "tick 120000", of any number of digits.
std::string tick_text(double tick) {
  return "tick " + std::to_string(static_cast<std::int64_t>(tick));
}

/// Predicate for an axis that was not ready, from the cause in Refusal::value.
const char* was_unready(double cause) {
  switch (static_cast<Cause>(cause)) {
    case Cause::not_enabled:
      return " was disabled";
    case Cause::in_error:
      return " had a fault";
    case Cause::not_homed:
      return " was not homed";
    case Cause::stopping:
      return " was stopped";
    default:
      return " moved";
  }
}

/// Predicate for an axis that is not ready, from the cause in Refusal::value.
const char* unready(double cause) {
  switch (static_cast<Cause>(cause)) {
    case Cause::not_enabled:
      return " is disabled (`jounce order NAME enable`)";
    case Cause::in_error:
      return " has a fault (`jounce order NAME reset`)";
    case Cause::not_homed:
      return " is not homed (`jounce order NAME home`)";
    case Cause::stopping:
      return " is stopping";
    default:
      return " is moving";
  }
}

/// The text with the name of the axis; without the part in parentheses if the name is not known.
std::string named(std::string text, const std::string& axis, bool known) {
  constexpr std::string_view placeholder = "NAME";
  const auto at = text.find(placeholder);
  if (at == std::string::npos) return text;
  if (!known) return text.substr(0, text.find(" ("));
  return text.replace(at, placeholder.size(), axis);
}

/// "; y and z are not ready either", from the bits in Refusal::limit; "" for no other axis.
std::string also_unready(const Refusal& refusal, std::size_t first,
                         std::span<const std::string> axes, bool past) {
  const auto bits = static_cast<unsigned long>(refusal.limit);
  std::string others;
  std::size_t count = 0;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (k == first || (bits >> k & 1U) == 0) continue;
    others += (others.empty() ? "" : ", ") + axes[k];
    ++count;
  }
  if (count == 0) return "";
  const char* one = past ? " was" : " is";
  const char* several = past ? " were" : " are";
  return "; " + others + (count == 1 ? one : several) + " not ready either";
}

/// The axis of a group that prevents a motion; Refusal::where is its number. `past`: its state when it
/// stopped the group.
std::string of_group_axis(const Refusal& refusal, const std::string& unit,
                          std::span<const std::string> axes, bool past = false) {
  if (!(refusal.where >= 1)) return "";
  const auto index = static_cast<std::size_t>(refusal.where) - 1;
  const std::string axis =
      index < axes.size() ? axes[index] : "Axis " + six_digits(refusal.where) + " of the group";
  if (refusal.cause == Cause::axis_not_ready)
    return " " + axis +
           (past ? was_unready(refusal.value)
                 : named(unready(refusal.value), axis, index < axes.size())) +
           also_unready(refusal, index, axes, past) + ".";
  return " " + axis + " is at " + six_digits(refusal.value) + unit_of(refusal.cause, unit) +
         " instead of " + place_text(refusal.limit) + unit_of(refusal.cause, unit) + ".";
}

/// The value of a rejection, with as many digits as show that it is not its limit.
std::string value_text(const Refusal& refusal) {
  return refusal.value == refusal.limit ? six_digits(refusal.value)
                                        : digits_beside(refusal.value, six_digits(refusal.limit));
}

/// The limit that a motion uses up, from the number of the limit in Refusal::where.
std::string used_up(const Refusal& refusal, const std::string& unit) {
  struct Used {
    Cause limit;
    const char* name;
  };
  constexpr std::array limits{Used{Cause::velocity_limit, "velocity"},
                              Used{Cause::acceleration_limit, "acceleration or deceleration"},
                              Used{Cause::jerk_limit, "jerk"},
                              Used{Cause::acceleration_limit, "acceleration"},
                              Used{Cause::acceleration_limit, "deceleration"}};
  const auto index = static_cast<std::size_t>(refusal.where) - 1;
  if (index >= limits.size()) return ".";
  const bool is_default = index >= 3 && refusal.value == refusal.limit;
  const std::string of = unit_of(limits[index].limit, unit);
  return std::string(": ") + limits[index].name + " " + value_text(refusal) + of + ", limit " +
         six_digits(refusal.limit) + of + (is_default ? ", which is the default." : ".");
}

std::string input_name(int input) {
  if (input == home_switch_input) return "home";
  return input == index_input ? "index" : std::to_string(input);
}

/// The inputs of the drive, from the bits in Refusal::limit.
std::string other_inputs(const Refusal& refusal) {
  std::string inputs;
  for (int input = 1; input <= probe_inputs; ++input)
    if ((static_cast<unsigned>(refusal.limit) >> static_cast<unsigned>(input - 1) & 1U) != 0)
      inputs += (inputs.empty() ? "" : ", ") + input_name(input);
  return input_name(static_cast<int>(refusal.value)) + "; it has " +
         (inputs.empty() ? "none" : inputs);
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

std::string remedy_of_order(Cause cause, CommandKind kind) {
  for (const OrderRemedy& one : order_remedies)
    if (one.cause == cause && one.kind == kind) return one.remedy;
  const Entry& found = entry(cause);
  return found.of_order != nullptr ? found.of_order : found.remedy;
}

std::string remedy_of_table(Cause cause) {
  const Entry& found = entry(cause);
  return found.of_table != nullptr ? found.of_table : found.remedy;
}

const char* name(Cause cause) {
  return entry(cause).name;
}

const char* meaning(Cause cause) {
  return entry(cause).meaning;
}

std::string text(const Refusal& refusal, const std::string& unit, const std::string& master_unit,
                 std::span<const std::string> axes) {
  const Cause cause = refusal.cause;
  std::string words = std::string(name(cause)) + ": " + meaning(cause);
  if (cause == Cause::axis_away || cause == Cause::axis_not_ready)
    return words + of_group_axis(refusal, unit, axes);
  words.pop_back();  // the full stop: the numbers follow
  if (cause == Cause::no_reserve) return words + used_up(refusal, unit);
  if (cause == Cause::too_late)
    return words + ": " + tick_text(refusal.value) + "; the axis is at " +
           tick_text(refusal.limit) + ".";
  if (cause == Cause::no_trigger_input && refusal.value >= 1)
    return words + ": " + other_inputs(refusal) + ".";
  if (cause == Cause::no_such_move && !std::isnan(refusal.where))
    return words + ": " + six_digits(refusal.value) + unit_of(cause, unit) +
           " is not in this direction from " + six_digits(refusal.limit) + unit_of(cause, unit) +
           ".";
  if (is_cut(cause)) return words + ": " + cut_text(refusal, master_unit) + ".";
  if (!is_measured(cause) && cause != Cause::cutter_away && cause != Cause::start_jump)
    return words + ".";
  // A table may begin at 1e-32: rounding.
  constexpr double rounding = 1e-12;
  const double scale = std::max(1.0, std::abs(refusal.limit));
  const auto shown = [&](double number) {
    return six_digits(std::abs(number) < rounding * scale ? 0 : number) + unit_of(cause, unit);
  };
  if (cause == Cause::position_limit && refusal.value == refusal.limit)  // a jog
    return std::string(name(cause)) + ": The axis is at the end of its position range, " +
           shown(refusal.limit) + ", and cannot move further in this direction.";
  if (cause == Cause::cutter_away)
    return words + ": home is at " + shown(refusal.value) + ", the axis at " +
           shown(refusal.limit) + ".";
  if (cause == Cause::start_jump)
    return words + ": " + shown(refusal.value) + "; the axis moves at " + shown(refusal.limit) +
           ".";
  if (cause == Cause::start_position) {
    const bool close = shown(refusal.value) == shown(refusal.limit);
    const auto place = [&](double number) {
      return close ? place_text(number) + unit_of(cause, unit) : shown(number);
    };
    return words + ": " +
           (std::isnan(refusal.value) ? "" : "it begins at " + place(refusal.value) + "; ") +
           "the axis would start it at " + place(refusal.limit) + ".";
  }
  const std::string instant =
      std::isnan(refusal.where) ? "" : " at " + six_digits(refusal.where) + " s";
  const bool is_near_zero = std::abs(refusal.value) < rounding * scale;
  const std::string value =
      is_near_zero ? shown(refusal.value) : value_text(refusal) + unit_of(cause, unit);
  return words + ": " + value + instant + ", limit " + shown(refusal.limit) + ".";
}

std::string place_text(double place) {
  std::array<char, 32> digits{};
  const auto [end, bad] = std::to_chars(digits.data(), digits.data() + digits.size(), place,
                                        std::chars_format::general, 12);
  return bad == std::errc() ? std::string(digits.data(), end) : six_digits(place);
}

std::optional<double> refused_value(const std::string& text) {
  const std::size_t limit = text.rfind(", limit ");
  const std::size_t colon = text.rfind(": ", limit);
  if (limit == std::string::npos || colon == std::string::npos) return std::nullopt;
  double value = 0;
  const char* const begin = text.data() + colon + 2;
  const auto [end, bad] = std::from_chars(begin, text.data() + limit, value);
  return bad == std::errc() && end != begin ? std::optional(value) : std::nullopt;
}

std::string unready_axis_text(const Refusal& refusal, std::span<const std::string> axes) {
  const std::string words = of_group_axis(refusal, "", axes, true);
  return words.empty() ? words : words.substr(1);
}

std::string Refusal::text() const {
  return jounce::text(*this, "");
}

}  // namespace jounce
