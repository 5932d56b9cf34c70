// SPDX-License-Identifier: Apache-2.0
// Queue, Rows, QueueAck.
#include <limits>

#include "jounce/profiles/error.hpp"

#include "stream/src/message/fields.hpp"
#include "stream/src/message/lcm_body.hpp"

namespace jounce::wire {
namespace {

constexpr std::size_t columns = 8;
constexpr auto most_rows = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());

void put_row(const Row& from, double* to) {
  const double row[columns] = {from.x_end,
                               from.p_end,
                               from.v_start,
                               from.v_end,
                               from.a_start,
                               from.a_end,
                               static_cast<double>(from.order),
                               from.last ? 1.0 : 0.0};
  std::copy(row, row + columns, to);
}

bool get_row(const double* from, Row& to) {
  const double order = from[6];
  if ((order != 1 && order != 2 && order != 3 && order != 5) || (!is_zero(from[7]) && from[7] != 1))
    return false;
  to = {from[0],     from[1], from[2], from[3], from[4], from[5], static_cast<RowOrder>(order),
        from[7] == 1};
  return true;
}

bool get_queue(std::int32_t number, std::uint32_t& queue) {
  return get_count(number, queue) && queue >= first_queue && queue <= last_queue;
}

}  // namespace

void put(const Queue& from, jounce_lcm::queue_t& to) {
  to.queue = put_count("queue", from.queue);
  to.axis = variable_number(from);
  to.mode = number_of(from.mode);
  put_unit("unit of x", from.units.x, to.unit_x);
  put_unit("unit of position", from.units.position, to.unit_position);
  to.capacity = put_count("capacity", from.capacity);
  to.loops = from.loops;
  to.event = number_of(from.event);
  to.event_position = from.event_position;
  to.event_direction = from.event_direction;
  to.prefill = put_count("prefill", from.prefill);
  to.relative = from.relative ? 1 : 0;
  to.origin = from.origin;
  to.lowest = from.lowest;
  to.highest = from.highest;
}

bool get(const jounce_lcm::queue_t& from, Queue& to) {
  to.loops = from.loops;
  to.event_position = from.event_position;
  to.event_direction = from.event_direction;
  to.relative = from.relative != 0;
  to.origin = from.origin;
  to.lowest = from.lowest;
  to.highest = from.highest;
  if (from.relative != 0 && from.relative != 1) return false;
  return get_queue(from.queue, to.queue) && set_variable(from.axis, to) &&
         get_enum(from.mode, to.mode) && get_text(from.unit_x, unit_bytes, to.units.x) &&
         get_text(from.unit_position, unit_bytes, to.units.position) &&
         get_count(from.capacity, to.capacity) && get_enum(from.event, to.event) &&
         get_count(from.prefill, to.prefill);
}

void put(const Rows& from, jounce_lcm::rows_t& to) {
  if (from.rows.empty() || from.rows.size() > rows_each) {
    throw InputError("rows", std::to_string(from.rows.size()),
                     "must be 1 to " + std::to_string(rows_each));
  }
  if (from.first_row > most_rows)
    throw InputError("first_row", std::to_string(from.first_row), "must fit 63 bits");
  to.queue = put_count("queue", from.queue);
  to.bank = static_cast<std::int8_t>(from.bank);
  to.seq = put_count("seq", from.seq);
  to.first_row = static_cast<std::int64_t>(from.first_row);
  to.count = static_cast<std::int32_t>(from.rows.size());
  for (std::size_t i = 0; i < from.rows.size(); ++i) put_row(from.rows[i], to.values + columns * i);
}

bool get(const jounce_lcm::rows_t& from, Rows& to) {
  if (!get_queue(from.queue, to.queue) || !get_bank(from.bank, to.bank) ||
      !get_count(from.seq, to.seq) || from.first_row < 0 || from.count < 1 ||
      from.count > static_cast<std::int32_t>(rows_each))
    return false;
  to.first_row = static_cast<std::uint64_t>(from.first_row);
  to.rows.resize(static_cast<std::size_t>(from.count));
  const double* value = from.values;
  for (Row& row : to.rows) {
    if (!get_row(value, row)) return false;
    value += columns;
  }
  return std::all_of(value, from.values + message_values, is_zero);
}

void put(const QueueAck& from, jounce_lcm::queue_ack_t& to) {
  to.boot = from.boot;
  to.queue = put_count("queue", from.queue);
  for (std::size_t bank = 0; bank < 2; ++bank) {
    to.next[bank] = put_count("next", from.next[bank]);
    to.mask[bank] = std::bit_cast<std::int64_t>(from.mask[bank]);
    to.space[bank] = put_count("space", from.space[bank]);
  }
  to.played = from.played;
  to.progress = number_of(from.progress);
  to.refusal = number_of(from.refusal);
  to.row = from.row;
  put_text(from.reason, to.reason, reason_bytes);
}

bool get(const jounce_lcm::queue_ack_t& from, QueueAck& to) {
  to.boot = from.boot;
  to.played = from.played;
  to.row = from.row;
  for (std::size_t bank = 0; bank < 2; ++bank) {
    to.mask[bank] = std::bit_cast<std::uint64_t>(from.mask[bank]);
    if (!get_count(from.next[bank], to.next[bank]) || !get_count(from.space[bank], to.space[bank]))
      return false;
  }
  return to.boot >= 1 && get_queue(from.queue, to.queue) && to.played >= 0 && to.row >= -1 &&
         get_enum(from.progress, to.progress) && get_enum(from.refusal, to.refusal) &&
         get_text(from.reason, reason_bytes, to.reason);
}

}  // namespace jounce::wire
