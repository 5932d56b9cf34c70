// SPDX-License-Identifier: Apache-2.0
// The reports of executors and masters (Status, Event, Master), and Command.
#include <cmath>

#include "jounce/command/command_table.hpp"
#include "jounce/profiles/error.hpp"

#include "stream/src/message/fields.hpp"
#include "stream/src/message/lcm_body.hpp"

namespace jounce::wire {
namespace {

bool get_histogram(const std::int32_t (&from)[16], Histogram& to) {
  std::copy(from, from + 16, to.begin());
  return std::all_of(to.begin(), to.end(), [](std::int32_t count) { return count >= 0; });
}

}  // namespace

void put(const Status& from, jounce_lcm::status_t& to) {
  to.state = number_of(from.state);
  to.next = number_of(from.next);
  to.tick = from.tick;
  to.cycle_ns = from.cycle_ns;
  to.master_position = from.master_position;
  to.slave_position = from.slave_position;
  to.slave_velocity = from.slave_velocity;
  put_bytes(from.table, to.table_prefix);
  to.last_error = from.last_error;
  to.late_ticks = from.late_ticks;
  to.finished = from.finished;
  to.stopped = from.stopped;
  to.actual_position = from.actual_position;
  to.following_error = from.following_error;
  to.torque = from.torque;
  to.override = from.override_;
  to.progress = number_of(from.progress);
  to.reason = from.reason;
  to.queue_rows = put_count("queue_rows", from.queue_rows);
  to.queue_capacity = put_count("queue_capacity", from.queue_capacity);
  to.outputs = std::bit_cast<std::int32_t>(from.outputs);
  to.boot = from.boot;
  to.rejected = from.rejected;
  to.not_authentic = from.not_authentic;
  std::copy(from.lateness.begin(), from.lateness.end(), to.lateness);
  std::copy(from.computing.begin(), from.computing.end(), to.computing);
  put_unit("unit of x", from.units.x, to.unit_x);
  put_unit("unit of position", from.units.position, to.unit_position);
  to.start_command = from.start_command;
  to.start_outcome = number_of(from.start);
  to.start_cause = from.start_cause;
  put_text(from.start_reason, to.start_reason, reason_bytes);
  to.held = from.held ? 1 : 0;
  to.homed = from.homed ? 1 : 0;
  to.unwritten = static_cast<std::int8_t>(from.unwritten);
  to.gear = number_of(from.gear);
  to.gear_master = from.gear_master ? 1 : 0;
  to.ratio = from.ratio;
  to.correction = from.correction;
}

bool get(const jounce_lcm::status_t& from, Status& to) {
  to.tick = from.tick;
  to.cycle_ns = from.cycle_ns;
  to.master_position = from.master_position;
  to.slave_position = from.slave_position;
  to.slave_velocity = from.slave_velocity;
  to.last_error = from.last_error;
  to.late_ticks = from.late_ticks;
  to.finished = from.finished;
  to.stopped = from.stopped;
  to.actual_position = from.actual_position;
  to.following_error = from.following_error;
  to.torque = from.torque;
  to.override_ = from.override;
  to.reason = from.reason;
  to.outputs = std::bit_cast<std::uint32_t>(from.outputs);
  to.boot = from.boot;
  to.rejected = from.rejected;
  to.not_authentic = from.not_authentic;
  to.start_command = from.start_command;
  to.start_cause = from.start_cause;
  to.unwritten = static_cast<std::uint8_t>(from.unwritten);
  to.ratio = from.ratio;
  to.correction = from.correction;
  return get_enum(from.state, to.state) && get_enum(from.next, to.next) && to.tick >= 0 &&
         to.cycle_ns > 0 && to.late_ticks >= 0 && to.finished >= 0 && to.stopped >= 0 &&
         get_bytes(from.table_prefix, to.table) && to.override_ >= 0 && to.override_ <= 2 &&
         get_enum(from.progress, to.progress) && get_count(from.queue_rows, to.queue_rows) &&
         get_count(from.queue_capacity, to.queue_capacity) && to.boot >= 0 && to.rejected >= 0 &&
         to.not_authentic >= 0 && get_histogram(from.lateness, to.lateness) &&
         get_histogram(from.computing, to.computing) &&
         get_text(from.unit_x, unit_bytes, to.units.x) &&
         get_text(from.unit_position, unit_bytes, to.units.position) && to.start_command >= 0 &&
         get_enum(from.start_outcome, to.start) &&
         get_text(from.start_reason, reason_bytes, to.start_reason) &&
         get_flag(from.held, to.held) && get_flag(from.homed, to.homed) && to.unwritten <= 7 &&
         get_enum(from.gear, to.gear) && get_flag(from.gear_master, to.gear_master);
}

void put(const Event& from, jounce_lcm::event_t& to) {
  to.boot = from.boot;
  to.count = from.count;
  to.kind = number_of(from.kind);
  to.number = put_count("number", from.number);
  to.on = from.on ? 1 : 0;
  to.tick = from.tick;
  to.offset_s = from.offset_s;
  to.position = from.position;
}

bool get(const jounce_lcm::event_t& from, Event& to) {
  to.boot = from.boot;
  to.count = from.count;
  to.tick = from.tick;
  to.offset_s = from.offset_s;
  to.position = from.position;
  return to.boot >= 1 && to.count >= 1 && get_enum(from.kind, to.kind) &&
         get_count(from.number, to.number) && (to.number >= 1 || to.kind == EventKind::m_word) &&
         get_flag(from.on, to.on) && to.tick >= 0 && to.offset_s >= 0 && std::isfinite(to.offset_s);
}

void put(const Master& from, jounce_lcm::master_t& to) {
  to.seq = from.seq;
  to.stamp_ns = from.stamp_ns;
  to.clock = from.clock;
  to.valid = from.valid ? 1 : 0;
  to.position = from.position;
  to.velocity = from.velocity;
  put_unit("unit", from.unit, to.unit);
}

bool get(const jounce_lcm::master_t& from, Master& to) {
  to.seq = from.seq;
  to.stamp_ns = from.stamp_ns;
  to.clock = from.clock;
  to.position = from.position;
  to.velocity = from.velocity;
  constexpr std::int64_t latest = std::int64_t{1} << 62;  // 146 years: differences stay in range
  return to.seq >= 0 && to.stamp_ns >= 0 && to.stamp_ns <= latest && to.clock >= 0 &&
         get_flag(from.valid, to.valid) && std::isfinite(to.position) && !std::isinf(to.velocity) &&
         get_text(from.unit, unit_bytes, to.unit) && !to.unit.empty();
}

void put(const MasterStatus& from, jounce_lcm::master_status_t& to) {
  to.boot = from.boot;
  put_text(from.master, to.master, executor_bytes);
  put_unit("unit", from.unit, to.unit);
  to.tick = from.tick;
  to.lost = from.lost ? 1 : 0;
  to.position = from.position;
  to.velocity = from.velocity;
  to.age_s = from.age_s;
  to.taken = from.taken;
  to.refused = from.refused;
}

bool get(const jounce_lcm::master_status_t& from, MasterStatus& to) {
  to.boot = from.boot;
  to.tick = from.tick;
  to.position = from.position;
  to.velocity = from.velocity;
  to.age_s = from.age_s;
  to.taken = from.taken;
  to.refused = from.refused;
  return to.boot >= 1 && get_text(from.master, executor_bytes, to.master) &&
         is_executor_name(to.master) && get_text(from.unit, unit_bytes, to.unit) &&
         !to.unit.empty() && to.tick >= 0 && get_flag(from.lost, to.lost) &&
         std::isfinite(to.position) != to.lost && std::isfinite(to.velocity) != to.lost &&
         !(to.age_s < 0) && !std::isinf(to.age_s) && to.taken >= 0 && to.refused >= 0;
}

void put(const GroupStatus& from, jounce_lcm::group_status_t& to) {
  if (from.axes.empty() || from.axes.size() > GroupStatus::most_axes)
    throw InputError("axes", std::to_string(from.axes.size()), "must be 1 to 9");
  if (from.units.size() > from.axes.size())
    throw InputError("units", std::to_string(from.units.size()),
                     "must be at most one for each axis");
  to.boot = from.boot;
  to.tick = from.tick;
  to.axes = static_cast<std::int32_t>(from.axes.size());
  for (std::size_t k = 0; k < from.axes.size(); ++k)
    put_text(from.axes[k], to.names + k * executor_bytes, executor_bytes);
  for (std::size_t k = 0; k < GroupStatus::most_axes; ++k)
    to.place[k] = k < from.place.size() && k < from.axes.size() ? from.place[k] : Status::unknown;
  to.framed = from.framed ? 1 : 0;
  to.line = from.line;
  to.commands = put_count("commands", from.commands);
  to.estimated = from.estimated ? 1 : 0;
  to.position = from.position;
  to.length = from.length;
  to.feed = from.feed;
  to.remaining_s = from.remaining_s;
  to.look_ahead = from.look_ahead;
  for (std::size_t k = 0; k < from.units.size(); ++k)
    put_unit("units", from.units[k], to.units + k * unit_bytes);
}

bool get(const jounce_lcm::group_status_t& from, GroupStatus& to) {
  static_assert(sizeof from.names == GroupStatus::most_axes * executor_bytes);
  static_assert(sizeof from.units == GroupStatus::most_axes * unit_bytes);
  const auto counts = [](double value) { return std::isfinite(value) && value >= 0; };
  const auto is_known = [](double value) { return !std::isinf(value) && !(value < 0); };
  to.boot = from.boot;
  to.tick = from.tick;
  to.line = from.line;
  to.position = from.position;
  to.length = from.length;
  to.feed = from.feed;
  to.remaining_s = from.remaining_s;
  to.look_ahead = from.look_ahead;
  if (from.axes < 1 || from.axes > static_cast<int>(GroupStatus::most_axes)) return false;
  for (std::size_t k = 0; k < GroupStatus::most_axes; ++k) {
    std::string axis;
    if (!get_text(from.names + k * executor_bytes, executor_bytes, axis)) return false;
    const bool wanted = k < static_cast<std::size_t>(from.axes);
    if (wanted ? !is_executor_name(axis) : !axis.empty()) return false;
    if (wanted) to.axes.push_back(std::move(axis));
    if (wanted) to.place.push_back(from.place[k]);
    if (std::isinf(from.place[k]) || (!wanted && !std::isnan(from.place[k]))) return false;
    std::string unit;
    if (!get_text(from.units + k * unit_bytes, unit_bytes, unit)) return false;
    if (!wanted && !unit.empty()) return false;
    if (wanted) to.units.push_back(std::move(unit));
  }
  return to.boot >= 1 && to.tick >= 0 && to.line >= 0 && get_count(from.commands, to.commands) &&
         get_flag(from.framed, to.framed) && get_flag(from.estimated, to.estimated) &&
         counts(to.position) && is_known(to.length) && counts(to.feed) &&
         is_known(to.remaining_s) && is_known(to.look_ahead);
}

void put(const Claim& from, jounce_lcm::claim_t& to) {
  to.boot = from.boot;
  to.rival = from.rival;
  to.up = from.up ? 1 : 0;
}

bool get(const jounce_lcm::claim_t& from, Claim& to) {
  to.boot = from.boot;
  to.rival = from.rival;
  return to.boot >= 1 && to.rival >= 0 && get_flag(from.up, to.up);
}

namespace {

/// Values that command_t holds.
constexpr std::size_t plain_values = std::extent_v<decltype(jounce_lcm::command_t::value)>;
static_assert(std::extent_v<decltype(jounce_lcm::path_command_t::value)> == most_fields);

template <class Lcm>
void write_command(const Command& from, Lcm& to) {
  to.command = from.command;
  to.kind = info(from.kind).number;
  if (to.kind < 0) throw InputError("command", name(from.kind), "is not a command of a client");
  to.at = from.at;
  std::copy_n(from.value.begin(), std::size(to.value), to.value);
}

/// The receiver rejects values out of range, with a reason that the sender can use.
template <class Lcm>
bool read_command(const Lcm& from, Command& to) {
  const auto kind = kind_of_number(from.kind);
  if (!kind) return false;
  to.kind = *kind;
  to.at = from.at;
  std::copy_n(from.value, std::size(from.value), to.value.begin());
  return get_command(from.command, to.command) && to.at >= -1;
}

}  // namespace

bool is_path_command(const Command& command) {
  return info(command.kind).fields.size() > plain_values;
}

void put(const Command& from, jounce_lcm::command_t& to) {
  write_command(from, to);
}

void put(const PathCommand& from, jounce_lcm::path_command_t& to) {
  write_command(from, to);
}

bool get(const jounce_lcm::command_t& from, Command& to) {
  return read_command(from, to) && !is_path_command(to);
}

bool get(const jounce_lcm::path_command_t& from, PathCommand& to) {
  return read_command(from, to) && is_path_command(to);
}

}  // namespace jounce::wire
