// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "jounce/command/command_values.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/record/record_wire.hpp"

// The sources of movements: tables, jobs, gears, queues and their rows.

namespace jounce::record_wire {

namespace {

/// The existing columns: x, p, v, a.
template <class C>
auto columns_of(C& c) {
  return std::array{&c.x, &c.p, &c.v, &c.a};
}

}  // namespace

table_t on_wire(const RecordedTable& t) {
  table_t w{};
  std::copy(t.hash.begin(), t.hash.end(), w.hash);
  put_text(t.units.x, w.x_unit);
  put_text(t.units.position, w.position_unit);
  w.over = static_cast<std::int8_t>(t.over);
  w.rule = static_cast<std::int8_t>(t.rule);
  w.outside = static_cast<std::int8_t>(t.outside);
  w.knots = static_cast<std::int64_t>(t.knots);
  w.first = static_cast<std::int64_t>(t.first);
  w.count = static_cast<std::int32_t>(t.columns.x.size());
  const auto columns = columns_of(t.columns);
  for (std::size_t k = 0; k < columns.size() && !columns[k]->empty(); ++k) {
    w.columns = static_cast<std::int8_t>(k + 1);
    std::copy(columns[k]->begin(), columns[k]->end(), w.value[k]);
  }
  return w;
}

RecordedTable ours(const table_t& w) {
  if (w.count < 1 || w.count > static_cast<int>(knots_an_event) || w.first < 0 ||
      w.knots < w.first + w.count || w.knots > 1'000'000'000)
    throw InputError("knots",
                     std::to_string(w.first) + " and " + std::to_string(w.count) + " of " +
                         std::to_string(w.knots),
                     "is not a part of a table");
  if (w.columns < 2 || w.columns > 4)
    throw InputError("columns", std::to_string(w.columns), "must be 2, 3 or 4");
  RecordedTable t{.units = {get_text(w.x_unit), get_text(w.position_unit)},
                  .knots = static_cast<std::size_t>(w.knots),
                  .first = static_cast<std::size_t>(w.first)};
  std::copy(std::begin(w.hash), std::end(w.hash), t.hash.begin());
  Get{}("over", t.over, w.over);
  Get{}("rule", t.rule, w.rule);
  Get{}("outside", t.outside, w.outside);
  const auto columns = columns_of(t.columns);
  for (std::size_t k = 0; k < static_cast<std::size_t>(w.columns); ++k)
    columns[k]->assign(w.value[k], w.value[k] + w.count);
  return t;
}

job_t on_wire(const RecordedJob& j) {
  job_t w{};
  w.axis = static_cast<std::int16_t>(j.axis);
  w.id = static_cast<std::int64_t>(j.id);
  std::copy(j.time.begin(), j.time.end(), w.time);
  if (j.cam) std::copy(j.cam->begin(), j.cam->end(), w.cam);
  w.live = j.live ? j.cuts ? 2 : 1 : 0;
  w.tick = j.tick;
  w.position = j.position;
  each_coupling(j.coupling, w, Put{});
  w.end = static_cast<std::int8_t>(j.end);
  return w;
}

RecordedJob ours(const job_t& w) {
  RecordedJob j{.axis = static_cast<std::size_t>(w.axis),
                .id = static_cast<std::uint64_t>(w.id),
                .live = w.live != 0,
                .cuts = w.live == 2,
                .tick = w.tick,
                .position = w.position};
  std::copy(std::begin(w.time), std::end(w.time), j.time.begin());
  if (std::any_of(std::begin(w.cam), std::end(w.cam), [](std::uint8_t b) { return b != 0; })) {
    j.cam.emplace();
    std::copy(std::begin(w.cam), std::end(w.cam), j.cam->begin());
  }
  each_coupling(j.coupling, w, Get{});
  Get{}("end", j.end, w.end);
  return j;
}

gear_t on_wire(const RecordedGear& g) {
  gear_t w{};
  w.axis = static_cast<std::int16_t>(g.axis);
  w.id = static_cast<std::int64_t>(g.id);
  const CommandValues values = values_of(g.gear);
  w.kind = info(kind_of(g.gear)).number;
  std::copy_n(values.begin(), std::size(w.value), w.value);
  w.position = g.position;
  return w;
}

RecordedGear ours(const gear_t& w) {
  RecordedGear g{.axis = static_cast<std::size_t>(w.axis),
                 .id = static_cast<std::uint64_t>(w.id),
                 .position = w.position};
  const auto kind = kind_of_number(w.kind);
  if (kind != CommandKind::gear_in && kind != CommandKind::gear_in_pos &&
      kind != CommandKind::combine_axes)
    throw InputError("kind", std::to_string(w.kind), "is not a gear command");
  CommandValues values{};
  std::copy(std::begin(w.value), std::end(w.value), values.begin());
  if (const std::string rule = contradiction(*kind, values); !rule.empty())
    throw InputError("gear", std::to_string(w.id), rule);
  g.gear = command_of(*kind, values);
  return g;
}

queue_t on_wire(const RecordedQueue& q) {
  queue_t w{};
  w.axis = static_cast<std::int16_t>(q.axis);
  w.id = static_cast<std::int64_t>(q.id);
  w.over = wire::variable_number(q.queue);
  w.mode = static_cast<std::int8_t>(q.queue.mode);
  w.capacity = q.queue.capacity;
  w.loops = q.queue.loops;
  w.event = static_cast<std::int8_t>(q.queue.event);
  w.event_position = q.queue.event_position;
  w.event_direction = q.queue.event_direction;
  w.relative = q.queue.relative ? 1 : 0;
  w.origin = q.queue.origin;
  w.lowest = q.queue.lowest;
  w.highest = q.queue.highest;
  return w;
}

RecordedQueue ours(const queue_t& w) {
  RecordedQueue q{.axis = static_cast<std::size_t>(w.axis), .id = static_cast<std::uint64_t>(w.id)};
  if (!wire::set_variable(w.over, q.queue))
    throw InputError("over", std::to_string(w.over), "is not a value of this field");
  Get{}("mode", q.queue.mode, w.mode);
  Get{}("event", q.queue.event, w.event);
  if (w.capacity < 1 || w.capacity > 1'000'000)
    throw InputError("capacity", std::to_string(w.capacity), "must be from 1 to 1e6 rows");
  q.queue.capacity = static_cast<std::uint32_t>(w.capacity);
  q.queue.loops = static_cast<std::int32_t>(w.loops);
  q.queue.event_position = w.event_position;
  q.queue.event_direction = static_cast<std::int8_t>(w.event_direction);
  q.queue.relative = w.relative != 0;
  q.queue.origin = w.origin;
  q.queue.lowest = w.lowest;
  q.queue.highest = w.highest;
  return q;
}

rows_t on_wire(const RecordedRows& r) {
  rows_t w{};
  w.axis = static_cast<std::int16_t>(r.axis);
  w.id = static_cast<std::int64_t>(r.what.movement);
  w.number = static_cast<std::int64_t>(r.what.number);
  w.kind = static_cast<std::int8_t>(r.what.kind);
  w.bank = static_cast<std::int8_t>(r.what.bank);
  w.count = static_cast<std::int32_t>(r.what.rows.size());
  for (std::size_t i = 0; i < r.what.rows.size(); ++i) {
    const SegmentRow& row = r.what.rows[i];
    const std::array value{row.x_end, row.p_end, row.v_start, row.v_end, row.a_start, row.a_end};
    std::copy(value.begin(), value.end(), w.value[i]);
    w.degree[i] = static_cast<std::int8_t>(row.degree);
    w.last[i] = row.last ? 1 : 0;
  }
  return w;
}

RecordedRows ours(const rows_t& w) {
  RecordedRows r{.axis = static_cast<std::size_t>(w.axis)};
  r.what.movement = static_cast<std::uint64_t>(w.id);
  r.what.number = static_cast<std::uint64_t>(w.number);
  Get{}("kind", r.what.kind, w.kind);
  if (w.bank < 0 || w.bank > 1) throw InputError("bank", std::to_string(w.bank), "must be 0 or 1");
  if (w.count < 0 || w.count > static_cast<int>(HandedOver::most_rows))
    throw InputError("count", std::to_string(w.count), "must be from 0 to 32 rows");
  r.what.bank = w.bank;
  for (int i = 0; i < w.count; ++i) {
    const auto& v = w.value[i];
    r.what.rows.push_back({v[0], v[1], v[2], v[3], v[4], v[5], w.degree[i], w.last[i] != 0});
  }
  return r;
}

}  // namespace jounce::record_wire
