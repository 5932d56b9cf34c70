// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/executor/detail/record.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/record/command_fields.hpp"

/// The fields that the types of record.hpp ("ours") and the LCM types in executor/lcm ("theirs")
/// have in common. There is one list for each type, for all purposes: each_input(ours, theirs,
/// Put{}) writes, Get{} reads, and other functions compare.
namespace jounce::record_fields {

template <class Ours, class Theirs, class F>
void each_sensor(Ours& s, Theirs& w, F f) {
  std::size_t k = 0;
  for (auto* sensor : {&s.home, &s.negative, &s.positive, &s.index}) {
    f("sensor_wired", sensor->wired, w.sensor_wired[k]);
    f("sensor_on", sensor->on, w.sensor_on[k]);
    f("sensor_edge", sensor->edge, w.sensor_edge[k]);
    ++k;
  }
}

/// Calls f(name, ours, theirs) for every field.
template <class Ours, class Theirs, class F>
void each_command(Ours& c, Theirs& w, F f) {
  f("id", c.id, w.id);
  f("command", c.kind, w.command);
  f("at", c.at, w.at);
  f("group", c.group, w.group);
  for (std::size_t k = 0; k < c.values.size(); ++k)
    f("command_values", c.values[k], w.command_values[k]);
}

template <class Ours, class Theirs, class F>
void each_input(Ours& c, Theirs& w, F f) {
  f("movement", c.movement, w.movement);
  for (std::size_t k = 0; k < 4; ++k) f("live_master", c.inputs.master[k], w.live_master[k]);
  f("live_master_offset", c.inputs.master_offset, w.live_master_offset);
  for (std::size_t k = 0; k < 4; ++k)
    f("second_master", c.inputs.second_master[k], w.second_master[k]);
  f("second_offset", c.inputs.second_offset, w.second_offset);
  f("drive_position", c.inputs.feedback.position, w.drive_position);
  f("drive_velocity", c.inputs.feedback.velocity, w.drive_velocity);
  f("drive_torque", c.inputs.feedback.torque, w.drive_torque);
  f("drive_ready", c.inputs.feedback.ready, w.drive_ready);
  f("drive_fault", c.inputs.feedback.fault, w.drive_fault);
  each_sensor(c.inputs.feedback.sensors, w, f);
  f("positive_switch", c.inputs.positive_switch, w.positive_switch);
  f("negative_switch", c.inputs.negative_switch, w.negative_switch);
  f("group_broken", c.inputs.group_broken, w.group_broken);
  f("peers", c.inputs.peers, w.peers);
  f("watchdog", c.inputs.watchdog, w.watchdog);
  f("rows", c.inputs.rows, w.rows);
}

/// Reasons why the command of a tick was rejected, and why the waiting motion was dropped. The
/// cause `none` means: not rejected, or not dropped.
struct Refusals {
  Refusal refused = {};
  Refusal dropped = {};

  Refusals() = default;
  explicit Refusals(const Tick& tick)
      : refused(tick.refused.value_or(Refusal{})), dropped(tick.dropped.value_or(Refusal{})) {}
  /// Sets the refusals of a tick.
  void put_into(Tick& tick) const {
    if (refused.cause != Cause::none) tick.refused = refused;
    if (dropped.cause != Cause::none) tick.dropped = dropped;
  }
};

template <class TickOfOurs, class RefusalsOfOurs, class Theirs, class F>
void each_output(TickOfOurs& t, RefusalsOfOurs& r, Theirs& w, F f) {
  f("tick", t.tick, w.tick);
  f("time", t.time, w.time);
  f("state", t.state, w.state);
  f("position", t.position, w.position);
  f("velocity", t.velocity, w.velocity);
  f("acceleration", t.acceleration, w.acceleration);
  f("master", t.master, w.master);
  f("master_velocity", t.master_velocity, w.master_velocity);
  f("job", t.job, w.job);
  f("armed", t.armed, w.armed);
  f("waiting", t.waiting, w.waiting);
  f("progress", t.progress, w.progress);
  f("fault", t.fault, w.fault);
  f("skipped", t.skipped, w.skipped);
  f("finished", t.finished, w.finished);
  f("stopped", t.stopped, w.stopped);
  f("reason", t.reason, w.reason);
  f("override", t.override_, w.override_factor);
  f("rate", t.rate, w.rate);
  f("held", t.held, w.held);
  f("homed", t.homed, w.homed);
  f("power", t.power, w.power);
  f("offset", t.offset, w.offset);
  f("actual_position", t.actual_position, w.actual_position);
  f("following_error", t.following_error, w.following_error);
  f("torque", t.torque, w.torque);
  f("in_position", t.in_position, w.in_position);
  f("outputs", t.switches.outputs, w.outputs);
  f("switch_edge", t.switches.edge[0].time, w.switch_edge);
  f("compare", t.compare.output, w.compare);
  f("compare_edge", t.compare.edge[0].time, w.compare_edge);
  f("refused", r.refused.cause, w.refused);
  f("refused_value", r.refused.value, w.refused_value);
  f("refused_limit", r.refused.limit, w.refused_limit);
  f("refused_where", r.refused.where, w.refused_where);
  f("dropped", r.dropped.cause, w.dropped);
  f("dropped_value", r.dropped.value, w.dropped_value);
  f("dropped_limit", r.dropped.limit, w.dropped_limit);
  f("dropped_where", r.dropped.where, w.dropped_where);
}

template <class Ours, class Theirs, class F>
void each_number(Ours& c, Theirs& w, F f) {
  f("period", c.period, w.period);
  f("longest_gap", c.longest_gap, w.longest_gap);
  f("position", c.position, w.position);
  f("position_min", c.limits.position_min, w.position_min);
  f("position_max", c.limits.position_max, w.position_max);
  f("velocity", c.limits.velocity, w.velocity);
  f("acceleration", c.limits.acceleration, w.acceleration);
  f("jerk", c.limits.jerk, w.jerk);
  f("stop_acceleration", c.stop_acceleration, w.stop_acceleration);
  f("stop_jerk", c.stop_jerk, w.stop_jerk);
  f("abort_acceleration", c.abort_acceleration, w.abort_acceleration);
  f("limit_acceleration", c.limit_acceleration, w.limit_acceleration);
  f("modulo", c.modulo, w.modulo);
  f("following_error", c.following_error, w.following_error);
  f("following_time", c.following_time, w.following_time);
  f("in_position", c.in_position, w.in_position);
  f("in_position_time", c.in_position_time, w.in_position_time);
  f("home_method", c.homing.method, w.home_method);
  f("search_velocity", c.homing.search_velocity, w.search_velocity);
  f("index_velocity", c.homing.index_velocity, w.index_velocity);
  f("home_acceleration", c.homing.acceleration, w.home_acceleration);
  f("home_offset", c.homing.offset, w.home_offset);
  f("home_timeout", c.homing.timeout, w.home_timeout);
  f("require_home", c.require_home, w.require_home);
}

template <class Ours, class Theirs, class F>
void each_of_master(Ours& m, Theirs& w, F f) {
  f("made", m.made, w.made);
  f("velocity", m.tracker.velocity, w.velocity);
  f("acceleration", m.tracker.acceleration, w.acceleration);
  f("time_constant", m.tracker.time_constant, w.time_constant);
  f("order", m.tracker.order, w.order);
  f("settle", m.tracker.settle, w.settle);
  f("latency", m.tracker.latency, w.latency);
  f("longest_age", m.tracker.longest_age, w.longest_age);
  f("jump", m.tracker.jump, w.jump);
  f("modulo", m.tracker.modulo, w.modulo);
}

template <class Ours, class Theirs, class F>
void each_of_sample(Ours& s, Theirs& w, F f) {
  f("stamp_ns", s.stamp_ns, w.stamp_ns);
  f("clock", s.clock, w.clock);
  f("received", s.received, w.received);
  f("position", s.position, w.position);
  f("valid", s.valid, w.valid);
}

template <class Ours, class Theirs, class F>
void each_coupling(Ours& c, Theirs& w, F f) {
  f("start", c.start, w.start);
  f("master_absolute", c.master_absolute, w.master_absolute);
  f("slave_absolute", c.slave_absolute, w.slave_absolute);
  f("master_scaling", c.master_scaling, w.master_scaling);
  f("master_offset", c.master_offset, w.master_offset);
  f("slave_scaling", c.slave_scaling, w.slave_scaling);
  f("slave_offset", c.slave_offset, w.slave_offset);
  f("velocity_diff", c.velocity_diff, w.velocity_diff);
  f("acceleration", c.acceleration, w.acceleration);
  f("deceleration", c.deceleration, w.deceleration);
  f("jerk", c.jerk, w.jerk);
  f("distance", c.distance, w.distance);
  f("slave_period", c.slave_period, w.slave_period);
  f("master_jump", c.master_jump, w.master_jump);
}

template <class Ours, class Theirs, class F>
void each_of_references(Ours& r, Theirs& w, F f) {
  f("referenced", r.referenced, w.referenced);
  f("compensated", r.compensated, w.compensated);
  for (std::size_t j = 0; j < Compensation::most_references; ++j) {
    f("reference_position", r.references[j][0], w.position[j]);
    f("reference_velocity", r.references[j][1], w.velocity[j]);
    f("reference_acceleration", r.references[j][2], w.acceleration[j]);
    f("correction", r.correction[j], w.correction[j]);
  }
}

/// Number of enumerators that a record may contain.
template <class Enum>
constexpr int count_of = 0;
template <>
inline constexpr int count_of<State> = static_cast<int>(states);
template <>
inline constexpr int count_of<CommandKind> = static_cast<int>(command_kinds);
template <>
inline constexpr int count_of<StartAt> = static_cast<int>(StartAt::master_position) + 1;
template <>
inline constexpr int count_of<Peers> = static_cast<int>(Peers::failed) + 1;
template <>
inline constexpr int count_of<Progress> = static_cast<int>(Progress::broken) + 1;
template <>
inline constexpr int count_of<Direction> = static_cast<int>(Direction::fastest) + 1;
template <>
inline constexpr int count_of<RecordedOutput::Part> =
    static_cast<int>(RecordedOutput::Part::compare) + 1;
template <>
inline constexpr int count_of<RecordedMaster::Made> =
    static_cast<int>(RecordedMaster::Made::readings) + 1;
template <>
inline constexpr int count_of<SwitchesOf> = static_cast<int>(SwitchesOf::actual) + 1;
template <>
inline constexpr int count_of<AxisDirection> = static_cast<int>(AxisDirection::negative) + 1;
template <>
inline constexpr int count_of<CamSwitchMode> = static_cast<int>(CamSwitchMode::time) + 1;
template <>
inline constexpr int count_of<CompareMode> = static_cast<int>(CompareMode::fifo_level) + 1;
template <>
inline constexpr int count_of<BufferMode> = static_cast<int>(BufferMode::blending_high) + 1;
template <>
inline constexpr int count_of<ProbeEdge> = static_cast<int>(ProbeEdge::both) + 1;
template <>
inline constexpr int count_of<Cause> = 256;
template <>
inline constexpr int count_of<MarkLoss> = static_cast<int>(MarkLoss::hold) + 1;
template <>
inline constexpr int count_of<CorrectionOf> = static_cast<int>(CorrectionOf::slave) + 1;
template <>
inline constexpr int count_of<StartMode> = static_cast<int>(StartMode::ramp_in_distance) + 1;
template <>
inline constexpr int count_of<CamEnd> = static_cast<int>(CamEnd::extend) + 1;
template <>
inline constexpr int count_of<Domain> = 2;
template <>
inline constexpr int count_of<Interpolation> = 3;
template <>
inline constexpr int count_of<Extrapolation> = 4;
template <>
inline constexpr int count_of<wire::QueueMode> = 2;
template <>
inline constexpr int count_of<wire::QueueEvent> = 3;
template <>
inline constexpr int count_of<HandedOver::Kind> = static_cast<int>(HandedOver::Kind::end) + 1;

/// Copies ours to theirs.
struct Put {
  template <class Ours, class Theirs>
  void operator()(const char* /*name*/, const Ours& ours, Theirs& theirs) const {
    theirs = static_cast<Theirs>(ours);
  }
  void operator()(const char* /*name*/, const std::optional<double>& ours, double& theirs) const {
    theirs = ours.value_or(std::numeric_limits<double>::quiet_NaN());
  }
};

/// Copies theirs to ours. Throws InputError(field, value, rule) for a number without an enumerator.
struct Get {
  template <class Ours, class Theirs>
  void operator()(const char* name, Ours& ours, const Theirs& theirs) const {
    if constexpr (std::is_enum_v<Ours>)
      if (theirs < (std::is_same_v<Ours, Direction> ? -1 : 0) || theirs >= count_of<Ours>)
        throw InputError(name, std::to_string(theirs), "is not a value of this field");
    ours = static_cast<Ours>(theirs);
  }
  void operator()(const char* /*name*/, std::optional<double>& ours, double theirs) const {
    ours.reset();
    if (!std::isnan(theirs)) ours = theirs;
  }
};

/// Sets a member of a command from its number in a record. Throws InputError if the member needs a
/// whole number, or an enumerator, and the number is none.
template <class Member>
void set_member(Member& member, double number) {
  if constexpr (std::is_floating_point_v<Member>) {
    member = number;
  } else {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    constexpr double least = std::is_enum_v<Member> ? -1 : 0;
    if (!(number >= least && number <= most && std::trunc(number) == number))
      throw InputError("command_values", std::to_string(number),
                       "must be a whole number from 0 to 2147483647");
    Get{}("command_values", member, static_cast<std::int32_t>(number));
  }
}

/// Returns the command of a record, without its movement. Throws InputError for a kind that no axis
/// executes, and for a damaged number.
inline Command command_of(const CommandFields& fields) {
  const auto with_defaults = made<AxisCommand>(fields.kind);
  if (!with_defaults) throw InputError("command", name(fields.kind), "is not a command of an axis");
  Command command{.what = *with_defaults, .at = fields.at, .id = fields.id};
  const auto get = [&](auto& what) {
    std::size_t i = 0;
    each_value(what, [&](auto& member) { set_member(member, fields.values.at(i++)); });
    if constexpr (requires { what.group; }) what.group = fields.group;
    if constexpr (requires { what.tick; }) {
      what.tick = fields.at;
      command.at = -1;
    }
  };
  std::visit(get, command.what);
  return command;
}

}  // namespace jounce::record_fields
