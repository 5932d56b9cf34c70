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
    Entry{Cause::aborted, "aborted", "An abort came; the setpoint was frozen at once."},
    Entry{Cause::disabled_in_motion, "disabled_in_motion",
          "The axis was disabled while it moved; the setpoint was frozen at once."},
    Entry{Cause::stalled, "stalled",
          "The cycle fell so far behind during motion that the setpoint would have leapt."},
    Entry{Cause::overspeed, "overspeed",
          "The next setpoint was further away than the velocity limit allows."},
    Entry{Cause::out_of_range, "out_of_range",
          "The next setpoint was beyond a position limit of the axis."},
    Entry{Cause::following_error, "following_error",
          "The drive was further from its setpoint than is allowed, for too long."},
    Entry{Cause::positive_soft_limit, "positive_soft_limit",
          "The motion would have left the position range at its upper end."},
    Entry{Cause::negative_soft_limit, "negative_soft_limit",
          "The motion would have left the position range at its lower end."},
    Entry{Cause::positive_switch, "positive_switch", "It ran onto the positive limit switch."},
    Entry{Cause::negative_switch, "negative_switch", "It ran onto the negative limit switch."},
    Entry{Cause::underrun, "underrun",
          "What came of the path was about to end before the path did; it stopped on it."},
    Entry{Cause::watchdog, "watchdog", "Whoever had to give a sign of life did not."},
    Entry{Cause::drive_fault, "drive_fault", "The drive reports a fault."},
    Entry{Cause::drive_not_ready, "drive_not_ready",
          "The drive ceased to follow setpoints while it was enabled."},
    Entry{Cause::master_lost, "master_lost", "The master that it followed is gone."},
    Entry{Cause::jump, "jump", "The next setpoint was no finite number, or its velocity leapt."},
    Entry{Cause::master_reversed, "master_reversed",
          "The master turned round while the slave was being coupled to it."},
    Entry{Cause::not_enabled, "not_enabled", "The axis is disabled."},
    Entry{Cause::in_error, "in_error", "A fault is latched; reset the axis first."},
    Entry{Cause::in_motion, "in_motion", "The axis moves; this needs a standstill."},
    Entry{Cause::not_armed, "not_armed", "Nothing is armed, so there is nothing to start."},
    Entry{Cause::not_at_start, "not_at_start",
          "The axis does not stand where the armed table begins."},
    Entry{Cause::too_late, "too_late", "The tick at which it should start is over."},
    Entry{Cause::no_value, "no_value", "The command lacks its table or its number."},
    Entry{Cause::leaving, "leaving", "The executor is about to end and arms nothing any more."},
    Entry{Cause::synchronized, "synchronized", "The axis follows a master; leave it first."},
    Entry{Cause::stopping, "stopping", "A stop is under way, and nothing ends it."},
    Entry{Cause::not_on_path, "not_on_path",
          "It follows a master that moves as it likes: there is no path to be slower on."},
    Entry{Cause::no_movement, "no_movement", "Nothing moves that this could change."},
    Entry{Cause::not_synchronized, "not_synchronized", "The axis follows no master."},
    Entry{Cause::direction_blocked, "direction_blocked",
          "The limit switch on that side is active: move the other way."},
    Entry{Cause::rate_changing, "rate_changing",
          "The speed on the path is being changed; ask again when that is over."},
    Entry{Cause::no_such_move, "no_such_move",
          "No move from the present state to that target keeps the limits."},
    Entry{Cause::halting, "halting",
          "A halt is under way: give it another motion, or wait for its end."},
    Entry{Cause::buffer_full, "buffer_full",
          "As many wait already as have room: eight moves, one order for its tick."},
    Entry{Cause::not_positive, "not_positive",
          "A velocity, acceleration, deceleration or jerk must be greater than 0; leave it out to "
          "use the limit of the axis."},
    Entry{Cause::bad_table, "bad_table",
          "The tables do not make a motion: one over time is needed, or a master and a cam."},
    Entry{Cause::start_position, "start_position",
          "The table does not begin where the axis stands."},
    Entry{Cause::start_velocity, "start_velocity", "The table does not begin at rest."},
    Entry{Cause::end_velocity, "end_velocity", "The table does not end at rest."},
    Entry{Cause::not_closed, "not_closed",
          "The table repeats, but does not end at the position where it begins."},
    Entry{Cause::master_outside_cam, "master_outside_cam",
          "The master leaves the range of a cam that refuses to be left."},
    Entry{Cause::position_limit, "position_limit", "The motion leaves the position range."},
    Entry{Cause::velocity_limit, "velocity_limit", "The motion is faster than the axis may be."},
    Entry{Cause::acceleration_limit, "acceleration_limit",
          "The motion accelerates more than the axis may."},
    Entry{Cause::jerk_limit, "jerk_limit", "The motion has more jerk than the axis may have."},
    Entry{Cause::position_step, "position_step", "The position jumps."},
    Entry{Cause::velocity_step, "velocity_step",
          "The velocity jumps by more than the acceleration limit makes in one tick."},
    Entry{Cause::acceleration_step, "acceleration_step",
          "The acceleration jumps by more than the jerk limit makes in one tick."},
    Entry{Cause::wrong_unit, "wrong_unit", "The table counts in another unit than the axis."},
    Entry{Cause::no_master_input, "no_master_input",
          "The axis has no live master now: none is configured in [follow], or it is lost."},
    Entry{Cause::would_reverse, "would_reverse",
          "The axis could reach its cam only against the direction that its start mode allows."},
    Entry{Cause::master_stands, "master_stands",
          "A ramp over a distance of the master begins while the cam moves without it."},
    Entry{Cause::no_ramp, "no_ramp", "No ramp within its limits brings the axis onto its cam."},
    Entry{Cause::not_in_sync, "not_in_sync", "The master ends before the axis is on its cam."},
    Entry{Cause::stopped, "stopped", "A stop was asked for."},
    Entry{Cause::halted, "halted", "A halt was asked for."},
    Entry{Cause::pass_ended, "pass_ended", "It was to end with its pass."},
    Entry{Cause::replaced, "replaced", "Another motion took its place."},
    Entry{Cause::released, "released",
          "It ran only while its session held it, and that was released or fell silent."},
};

/// Whether a number broke a bound: what else is refused has neither.
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
  return words + " (" + number(value) + " at " + number(where) + " s, limit " + number(limit) + ")";
}

}  // namespace jounce
