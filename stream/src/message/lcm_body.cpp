// SPDX-License-Identifier: Apache-2.0
#include "stream/src/message/lcm_body.hpp"

#include <bit>
#include <cmath>
#include <optional>

#include "jounce/profiles/error.hpp"

#include "stream/src/message/fields.hpp"

namespace jounce::wire {
namespace {

double put_magnitude(const std::optional<double>& value) {
  return value.value_or(0);
}

bool get_magnitude(double number, std::optional<double>& value) {
  if (number != 0) value = number;
  return number >= 0;
}

void put(const CouplingSpec& from, jounce_lcm::coupling_t& to) {
  to.start = number_of(from.start);
  to.master_absolute = from.master_absolute ? 1 : 0;
  to.slave_absolute = from.slave_absolute ? 1 : 0;
  to.master_scaling = from.master_scaling;
  to.master_offset = from.master_offset;
  to.slave_scaling = from.slave_scaling;
  to.slave_offset = from.slave_offset;
  to.velocity_diff = put_magnitude(from.velocity_diff);
  to.acceleration = put_magnitude(from.acceleration);
  to.deceleration = put_magnitude(from.deceleration);
  to.jerk = put_magnitude(from.jerk);
  to.distance = put_magnitude(from.distance);
  to.slave_period = put_magnitude(from.slave_period);
}

/// True if the coupling is complete and valid.
bool get(const jounce_lcm::coupling_t& from, CouplingSpec& to) {
  to.master_scaling = from.master_scaling;
  to.master_offset = from.master_offset;
  to.slave_scaling = from.slave_scaling;
  to.slave_offset = from.slave_offset;
  if (!get_enum(from.start, to.start) || !get_flag(from.master_absolute, to.master_absolute) ||
      !get_flag(from.slave_absolute, to.slave_absolute) ||
      !get_magnitude(from.velocity_diff, to.velocity_diff) ||
      !get_magnitude(from.acceleration, to.acceleration) ||
      !get_magnitude(from.deceleration, to.deceleration) || !get_magnitude(from.jerk, to.jerk) ||
      !get_magnitude(from.distance, to.distance) ||
      !get_magnitude(from.slave_period, to.slave_period))
    return false;
  try {
    require_valid(to);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace

void put(const Header& from, jounce_lcm::header_t& to) {
  to.table = put_count("table", from.table);
  put_bytes(from.hash, to.hash);
  to.axis = number_of(from.axis);
  to.rule = number_of(from.rule);
  to.outside = number_of(from.outside);
  put_unit("unit of x", from.units.x, to.unit_x);
  put_unit("unit of position", from.units.position, to.unit_position);
  to.knots = put_count("knots", from.knots);
  to.columns = put_count("columns", from.columns);
  to.per_chunk = put_count("per_chunk", from.per_chunk);
  to.chunks = put_count("chunks", from.chunks);
}

bool get(const jounce_lcm::header_t& from, Header& to) {
  return get_count(from.table, to.table) && to.table < most_tables &&
         get_bytes(from.hash, to.hash) && get_enum(from.axis, to.axis) &&
         get_enum(from.rule, to.rule) && get_enum(from.outside, to.outside) &&
         get_text(from.unit_x, unit_bytes, to.units.x) &&
         get_text(from.unit_position, unit_bytes, to.units.position) &&
         get_count(from.knots, to.knots) && get_count(from.columns, to.columns) &&
         get_count(from.per_chunk, to.per_chunk) && get_count(from.chunks, to.chunks);
}

/// All fields except the values, which go directly onto the wire: see chunk_bytes.hpp.
void put(const Chunk& from, jounce_lcm::chunk_t& to) {
  if (from.values.size() > chunk_values) {
    throw InputError("values", std::to_string(from.values.size()),
                     "a chunk holds at most " + std::to_string(chunk_values));
  }
  to.table = put_count("table", from.table);
  to.seq = put_count("seq", from.seq);
  to.first_knot = put_count("first_knot", from.first_knot);
  to.knots = put_count("knots", from.knots);
  to.columns = put_count("columns", from.columns);
}

bool get(const jounce_lcm::chunk_t& from, Chunk& to) {
  return get_count(from.table, to.table) && to.table < most_tables && get_count(from.seq, to.seq) &&
         get_count(from.first_knot, to.first_knot) && get_count(from.knots, to.knots) &&
         get_count(from.columns, to.columns) && to.columns >= 2 && to.columns <= 4 &&
         to.knots >= 1 && to.values.size() == std::size_t{to.knots} * to.columns;
}

void put(const Arm& from, jounce_lcm::arm_t& to) {
  to.command = from.command;
  to.mode = number_of(from.mode);
  put_bytes(from.slave, to.slave_hash);
  put_bytes(from.master, to.master_hash);
  require_valid(from.coupling);
  put(from.coupling, to.coupling);
  to.queue = put_count("queue", from.queue);
  to.bank = static_cast<std::int8_t>(from.bank);
  to.end = number_of(from.end);
}

/// True if the message names a queue exactly if its mode needs one.
bool names_queue(const Arm& arm) {
  if (arm.mode != ArmMode::queue) return arm.queue == 0 && arm.bank == 0;
  return arm.queue >= first_queue && arm.queue <= last_queue && arm.bank <= 1;
}

bool get(const jounce_lcm::arm_t& from, Arm& to) {
  return get_command(from.command, to.command) && get_enum(from.mode, to.mode) &&
         get_bytes(from.slave_hash, to.slave) && get_bytes(from.master_hash, to.master) &&
         get(from.coupling, to.coupling) && get_count(from.queue, to.queue) &&
         get_bank(from.bank, to.bank) && names_queue(to) && get_enum(from.end, to.end) &&
         (to.end == CamEnd::brake || to.mode == ArmMode::follow_input);
}

void put(const Start& from, jounce_lcm::start_t& to) {
  to.command = from.command;
  to.start_tick = from.tick;
  to.when = number_of(from.when);
  to.position = from.position;
}

bool get(const jounce_lcm::start_t& from, Start& to) {
  to.tick = from.start_tick;
  to.position = from.position;
  return get_command(from.command, to.command) && get_enum(from.when, to.when) && to.tick >= -1 &&
         (to.when == StartAt::tick || to.tick == -1) && std::isfinite(to.position) &&
         (to.when == StartAt::master_position || is_zero(to.position));
}

void put(const Stop& from, jounce_lcm::stop_t& to) {
  to.command = from.command;
  to.stop_mode = number_of(from.mode);
}

bool get(const jounce_lcm::stop_t& from, Stop& to) {
  return get_command(from.command, to.command) && get_enum(from.stop_mode, to.mode);
}

void put(const Heartbeat& from, jounce_lcm::heartbeat_t& to) {
  to.command = from.command;
  to.release = from.release ? 1 : 0;
}

bool get(const jounce_lcm::heartbeat_t& from, Heartbeat& to) {
  return get_command(from.command, to.command) && get_flag(from.release, to.release);
}

void put(const Ack& from, jounce_lcm::ack_t& to) {
  to.boot = from.boot;
  to.table = put_count("table", from.table);
  to.next = put_count("next", from.next);
  to.mask = std::bit_cast<std::int64_t>(from.mask);
  to.credit = put_count("credit", from.credit);
  to.complete = from.complete ? 1 : 0;
  to.refusal = number_of(from.refusal);
  put_text(from.reason, to.reason, reason_bytes);
}

bool get(const jounce_lcm::ack_t& from, Ack& to) {
  to.boot = from.boot;
  to.mask = std::bit_cast<std::uint64_t>(from.mask);
  return to.boot >= 1 && get_count(from.table, to.table) && to.table < most_tables &&
         get_count(from.next, to.next) && get_count(from.credit, to.credit) &&
         get_flag(from.complete, to.complete) && get_enum(from.refusal, to.refusal) &&
         get_text(from.reason, reason_bytes, to.reason);
}

void put(const Reply& from, jounce_lcm::reply_t& to) {
  to.boot = from.boot;
  to.command = from.command;
  to.outcome = number_of(from.outcome);
  to.refusal = number_of(from.refusal);
  to.cause = from.cause;
  put_text(from.reason, to.reason, reason_bytes);
}

bool get(const jounce_lcm::reply_t& from, Reply& to) {
  to.boot = from.boot;
  to.cause = from.cause;
  return to.boot >= 1 && get_command(from.command, to.command) &&
         get_enum(from.outcome, to.outcome) && get_enum(from.refusal, to.refusal) &&
         get_text(from.reason, reason_bytes, to.reason);
}

}  // namespace jounce::wire
