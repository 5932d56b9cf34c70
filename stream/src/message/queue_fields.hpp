// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "stream/src/message/field_copy.hpp"
#include "stream/src/message/lcm_body.hpp"

/// The fields of Queue, Rows and QueueAck: see body_fields.hpp.
namespace jounce::wire {

inline constexpr std::size_t row_columns = 8;  ///< numbers of a row on the wire

inline bool is_queue(std::uint32_t number) {
  return number >= first_queue && number <= last_queue;
}

inline void variable_field(const Queue& m, std::int8_t& number, const PutFields& /*f*/) {
  number = variable_number(m);
}
inline void variable_field(Queue& m, std::int8_t number, GetFields& f) {
  f.require(set_variable(number, m));
}

template <Is<Queue> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("queue", m.queue, w.queue);
  f.require(is_queue(m.queue));
  variable_field(m, w.axis, f);
  f("mode", m.mode, w.mode);
  f.unit("unit of x", m.units.x, w.unit_x);
  f.unit("unit of position", m.units.position, w.unit_position);
  f("capacity", m.capacity, w.capacity);
  f("loops", m.loops, w.loops);
  f("event", m.event, w.event);
  f("event_position", m.event_position, w.event_position);
  f("event_direction", m.event_direction, w.event_direction);
  f("prefill", m.prefill, w.prefill);
  f("relative", m.relative, w.relative);
  f("origin", m.origin, w.origin);
  f("lowest", m.lowest, w.lowest);
  f("highest", m.highest, w.highest);
}

inline void row_field(const Row& m, double* to, const PutFields& /*f*/) {
  const double row[row_columns] = {m.x_end,
                                   m.p_end,
                                   m.v_start,
                                   m.v_end,
                                   m.a_start,
                                   m.a_end,
                                   static_cast<double>(m.order),
                                   m.last ? 1.0 : 0.0};
  std::copy(row, row + row_columns, to);
}
inline void row_field(Row& m, const double* from, GetFields& f) {
  const double order = from[6];
  const bool is_row =
      (order == 1 || order == 2 || order == 3 || order == 5) && (is_zero(from[7]) || from[7] == 1);
  f.require(is_row);
  if (is_row)
    m = {from[0],     from[1], from[2], from[3], from[4], from[5], static_cast<RowOrder>(order),
         from[7] == 1};
}

/// The number of rows, and of the rows before them.
inline void count_field(const Rows& m, jounce_lcm::rows_t& w, const PutFields& /*f*/) {
  constexpr auto most_rows = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (m.rows.empty() || m.rows.size() > rows_each)
    throw InputError("rows", std::to_string(m.rows.size()),
                     "must be 1 to " + std::to_string(rows_each));
  if (m.first_row > most_rows)
    throw InputError("first_row", std::to_string(m.first_row), "must fit 63 bits");
  w.first_row = static_cast<std::int64_t>(m.first_row);
  w.count = static_cast<std::int32_t>(m.rows.size());
}
inline void count_field(Rows& m, const jounce_lcm::rows_t& w, GetFields& f) {
  const bool is_count = w.count >= 1 && w.count <= static_cast<std::int32_t>(rows_each);
  f.require(is_count && w.first_row >= 0);
  m.first_row = static_cast<std::uint64_t>(w.first_row);
  m.rows.resize(is_count ? static_cast<std::size_t>(w.count) : 0);
}

template <Is<Rows> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  count_field(m, w, f);
  f("queue", m.queue, w.queue);
  f.require(is_queue(m.queue));
  f("bank", m.bank, w.bank);
  f.require(m.bank <= 1);
  f("seq", m.seq, w.seq);
  auto* value = w.values;
  for (auto& row : m.rows) {
    row_field(row, value, f);
    value += row_columns;
  }
  f.require(std::all_of(value, w.values + message_values, is_zero));
}

template <Is<QueueAck> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("boot", m.boot, w.boot);
  f.require(m.boot >= 1);
  f("queue", m.queue, w.queue);
  f.require(is_queue(m.queue));
  for (std::size_t bank = 0; bank < 2; ++bank) {
    f("next", m.next[bank], w.next[bank]);
    f.bits(m.mask[bank], w.mask[bank]);
    f("space", m.space[bank], w.space[bank]);
  }
  f("played", m.played, w.played);
  f.require(m.played >= 0);
  f("progress", m.progress, w.progress);
  f("refusal", m.refusal, w.refusal);
  f("row", m.row, w.row);
  f.require(m.row >= -1);
  f("reason", m.reason, w.reason);
}

}  // namespace jounce::wire
