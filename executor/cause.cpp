#include "jounce/executor/cause.hpp"

#include <algorithm>
#include <array>

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
    Entry{Cause::not_enabled, "not_enabled", "The axis is disabled."},
    Entry{Cause::in_error, "in_error", "A fault is latched; reset the axis first."},
    Entry{Cause::in_motion, "in_motion", "The axis moves; this needs a standstill."},
    Entry{Cause::not_armed, "not_armed", "Nothing is armed, so there is nothing to start."},
    Entry{Cause::not_at_start, "not_at_start",
          "The axis does not stand where the armed table begins."},
    Entry{Cause::too_late, "too_late", "The tick at which it should start is over."},
    Entry{Cause::no_value, "no_value", "The command lacks its table or its number."},
    Entry{Cause::leaving, "leaving", "The executor is about to end and arms nothing any more."},
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
    Entry{Cause::position_limit, "position_limit", "The table leaves the position range."},
    Entry{Cause::velocity_limit, "velocity_limit", "The table is faster than the axis may be."},
    Entry{Cause::acceleration_limit, "acceleration_limit",
          "The table accelerates more than the axis may."},
    Entry{Cause::jerk_limit, "jerk_limit", "The table has more jerk than the axis may have."},
    Entry{Cause::position_step, "position_step", "The position jumps."},
    Entry{Cause::velocity_step, "velocity_step",
          "The velocity jumps by more than the acceleration limit makes in one tick."},
    Entry{Cause::acceleration_step, "acceleration_step",
          "The acceleration jumps by more than the jerk limit makes in one tick."},
    Entry{Cause::wrong_unit, "wrong_unit", "The table counts in another unit than the axis."},
    Entry{Cause::no_master_input, "no_master_input",
          "This executor has no master input; send the master as a table over time."},
    Entry{Cause::would_reverse, "would_reverse",
          "The axis could reach its cam only against the direction that its start mode allows."},
    Entry{Cause::master_stands, "master_stands",
          "A ramp over a distance of the master begins while the cam moves without it."},
    Entry{Cause::no_ramp, "no_ramp", "No ramp within its limits brings the axis onto its cam."},
    Entry{Cause::not_in_sync, "not_in_sync", "The master ends before the axis is on its cam."},
};

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

}  // namespace jounce
