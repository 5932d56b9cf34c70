// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <utility>

#include "stream/src/message/field_copy.hpp"
#include "stream/src/message/lcm_body.hpp"

/// The fields of the reports of executors and masters: see body_fields.hpp.
namespace jounce::wire {

inline bool has_counts(const Histogram& histogram) {
  return std::all_of(histogram.begin(), histogram.end(),
                     [](std::int32_t count) { return count >= 0; });
}

template <Is<Status> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("state", m.state, w.state);
  f("next", m.next, w.next);
  f("tick", m.tick, w.tick);
  f("cycle_ns", m.cycle_ns, w.cycle_ns);
  f.require(m.tick >= 0 && m.cycle_ns > 0);
  f("master_position", m.master_position, w.master_position);
  f("slave_position", m.slave_position, w.slave_position);
  f("slave_velocity", m.slave_velocity, w.slave_velocity);
  f("table_prefix", m.table, w.table_prefix);
  f("last_error", m.last_error, w.last_error);
  f("late_ticks", m.late_ticks, w.late_ticks);
  f("finished", m.finished, w.finished);
  f("stopped", m.stopped, w.stopped);
  f.require(m.late_ticks >= 0 && m.finished >= 0 && m.stopped >= 0);
  f("actual_position", m.actual_position, w.actual_position);
  f("following_error", m.following_error, w.following_error);
  f("torque", m.torque, w.torque);
  f("override", m.override_, w.override);
  f.require(m.override_ >= 0 && m.override_ <= 2);
  f("progress", m.progress, w.progress);
  f("reason", m.reason, w.reason);
  f("queue_rows", m.queue_rows, w.queue_rows);
  f("queue_capacity", m.queue_capacity, w.queue_capacity);
  f.bits(m.outputs, w.outputs);
  f("boot", m.boot, w.boot);
  f("rejected", m.rejected, w.rejected);
  f("not_authentic", m.not_authentic, w.not_authentic);
  f.require(m.boot >= 0 && m.rejected >= 0 && m.not_authentic >= 0);
  f("lateness", m.lateness, w.lateness);
  f("computing", m.computing, w.computing);
  f.require(has_counts(m.lateness) && has_counts(m.computing));
  f.unit("unit of x", m.units.x, w.unit_x);
  f.unit("unit of position", m.units.position, w.unit_position);
  f("start_command", m.start_command, w.start_command);
  f.require(m.start_command >= 0);
  f("start_outcome", m.start, w.start_outcome);
  f("start_cause", m.start_cause, w.start_cause);
  f("start_reason", m.start_reason, w.start_reason);
  f("held", m.held, w.held);
  f("homed", m.homed, w.homed);
  f("unwritten", m.unwritten, w.unwritten);
  f.require(m.unwritten <= 7);
  f("gear", m.gear, w.gear);
  f("gear_master", m.gear_master, w.gear_master);
  f("ratio", m.ratio, w.ratio);
  f("correction", m.correction, w.correction);
}

template <Is<Event> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("boot", m.boot, w.boot);
  f("count", m.count, w.count);
  f.require(m.boot >= 1 && m.count >= 1);
  f("kind", m.kind, w.kind);
  f("number", m.number, w.number);
  f.require(m.number >= 1 || m.kind == EventKind::m_word);
  f("on", m.on, w.on);
  f("tick", m.tick, w.tick);
  f.require(m.tick >= 0);
  f("offset_s", m.offset_s, w.offset_s);
  f.require(m.offset_s >= 0 && std::isfinite(m.offset_s));
  f("position", m.position, w.position);
}

template <Is<Master> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  constexpr std::int64_t latest = std::int64_t{1} << 62;  // 146 years: differences stay in range
  f("seq", m.seq, w.seq);
  f("stamp_ns", m.stamp_ns, w.stamp_ns);
  f("clock", m.clock, w.clock);
  f.require(m.seq >= 0 && m.stamp_ns >= 0 && m.stamp_ns <= latest && m.clock >= 0);
  f("valid", m.valid, w.valid);
  f("position", m.position, w.position);
  f("velocity", m.velocity, w.velocity);
  f.require(std::isfinite(m.position) && !std::isinf(m.velocity));
  f.unit("unit", m.unit, w.unit);
  f.require(!m.unit.empty());
}

template <Is<MasterStatus> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("boot", m.boot, w.boot);
  f.require(m.boot >= 1);
  f("master", m.master, w.master);
  f.require(is_executor_name(m.master));
  f.unit("unit", m.unit, w.unit);
  f.require(!m.unit.empty());
  f("tick", m.tick, w.tick);
  f.require(m.tick >= 0);
  f("lost", m.lost, w.lost);
  f("position", m.position, w.position);
  f("velocity", m.velocity, w.velocity);
  f.require(std::isfinite(m.position) != m.lost && std::isfinite(m.velocity) != m.lost);
  f("age_s", m.age_s, w.age_s);
  f.require(!(m.age_s < 0) && !std::isinf(m.age_s));
  f("taken", m.taken, w.taken);
  f("refused", m.refused, w.refused);
  f.require(m.taken >= 0 && m.refused >= 0);
}

/// The names, coordinates and units of the axes.
inline void axes_field(const GroupStatus& m, jounce_lcm::group_status_t& w,
                       const PutFields& /*f*/) {
  if (m.axes.empty() || m.axes.size() > GroupStatus::most_axes)
    throw InputError("axes", std::to_string(m.axes.size()), "must be 1 to 9");
  if (m.units.size() > m.axes.size())
    throw InputError("units", std::to_string(m.units.size()), "must be at most one for each axis");
  w.axes = static_cast<std::int32_t>(m.axes.size());
  for (std::size_t k = 0; k < m.axes.size(); ++k)
    put_text(m.axes[k], w.names + k * executor_bytes, executor_bytes);
  for (std::size_t k = 0; k < GroupStatus::most_axes; ++k)
    w.place[k] = k < m.place.size() && k < m.axes.size() ? m.place[k] : Status::unknown;
  for (std::size_t k = 0; k < m.units.size(); ++k)
    put_unit("units", m.units[k], w.units + k * unit_bytes);
}
inline void axes_field(GroupStatus& m, const jounce_lcm::group_status_t& w, GetFields& f) {
  static_assert(sizeof w.names == GroupStatus::most_axes * executor_bytes);
  static_assert(sizeof w.units == GroupStatus::most_axes * unit_bytes);
  f.require(w.axes >= 1 && w.axes <= static_cast<int>(GroupStatus::most_axes));
  for (int k = 0; k < static_cast<int>(GroupStatus::most_axes); ++k) {
    const bool wanted = k < w.axes;
    std::string axis;
    std::string unit;
    f.require(get_text(w.names + std::size_t(k) * executor_bytes, executor_bytes, axis) &&
              get_text(w.units + std::size_t(k) * unit_bytes, unit_bytes, unit));
    f.require(wanted ? is_executor_name(axis) : axis.empty() && unit.empty());
    f.require(!std::isinf(w.place[k]) && (wanted || std::isnan(w.place[k])));
    if (!wanted) continue;
    m.axes.push_back(std::move(axis));
    m.units.push_back(std::move(unit));
    m.place.push_back(w.place[k]);
  }
}

template <Is<GroupStatus> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  const auto counts = [](double value) { return std::isfinite(value) && value >= 0; };
  const auto is_known = [](double value) { return !std::isinf(value) && !(value < 0); };
  axes_field(m, w, f);
  f("boot", m.boot, w.boot);
  f("tick", m.tick, w.tick);
  f.require(m.boot >= 1 && m.tick >= 0);
  f("framed", m.framed, w.framed);
  f("line", m.line, w.line);
  f.require(m.line >= 0);
  f("commands", m.commands, w.commands);
  f("estimated", m.estimated, w.estimated);
  f("position", m.position, w.position);
  f("length", m.length, w.length);
  f("feed", m.feed, w.feed);
  f.require(counts(m.position) && is_known(m.length) && counts(m.feed));
  f("remaining_s", m.remaining_s, w.remaining_s);
  f("look_ahead", m.look_ahead, w.look_ahead);
  f.require(is_known(m.remaining_s) && is_known(m.look_ahead));
}

}  // namespace jounce::wire
