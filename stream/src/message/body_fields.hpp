// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "stream/src/message/field_copy.hpp"
#include "stream/src/message/lcm_body.hpp"

/// The fields of the messages about tables, motions and sessions, with the conditions that a received
/// message must satisfy. `m` is the message, `w` the generated type; f is PutFields or GetFields.
namespace jounce::wire {

template <Is<Header> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("table", m.table, w.table);
  f.require(m.table < most_tables);
  f("hash", m.hash, w.hash);
  f("axis", m.axis, w.axis);
  f("rule", m.rule, w.rule);
  f("outside", m.outside, w.outside);
  f.unit("unit of x", m.units.x, w.unit_x);
  f.unit("unit of position", m.units.position, w.unit_position);
  f("knots", m.knots, w.knots);
  f("columns", m.columns, w.columns);
  f("per_chunk", m.per_chunk, w.per_chunk);
  f("chunks", m.chunks, w.chunks);
}

inline void require_fit(const Chunk& m, const PutFields& /*f*/) {
  if (m.values.size() > chunk_values)
    throw InputError("values", std::to_string(m.values.size()),
                     "a chunk holds at most " + std::to_string(chunk_values));
}
inline void require_fit(const Chunk& m, GetFields& f) {
  f.require(m.columns >= 2 && m.columns <= 4 && m.knots >= 1 &&
            m.values.size() == std::size_t{m.knots} * m.columns);
}

/// All fields except the values, which go directly onto the wire: see chunk_bytes.hpp.
template <Is<Chunk> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("table", m.table, w.table);
  f.require(m.table < most_tables);
  f("seq", m.seq, w.seq);
  f("first_knot", m.first_knot, w.first_knot);
  f("knots", m.knots, w.knots);
  f("columns", m.columns, w.columns);
  require_fit(m, f);
}

inline void require_coupling(const CouplingSpec& m, const PutFields& /*f*/) {
  require_valid(m);
}
inline void require_coupling(const CouplingSpec& m, GetFields& f) {
  try {
    require_valid(m);
  } catch (const InputError&) {
    f.require(false);
  }
}

template <Is<CouplingSpec> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("start", m.start, w.start);
  f("master_absolute", m.master_absolute, w.master_absolute);
  f("slave_absolute", m.slave_absolute, w.slave_absolute);
  f("master_scaling", m.master_scaling, w.master_scaling);
  f("master_offset", m.master_offset, w.master_offset);
  f("slave_scaling", m.slave_scaling, w.slave_scaling);
  f("slave_offset", m.slave_offset, w.slave_offset);
  f("velocity_diff", m.velocity_diff, w.velocity_diff);
  f("acceleration", m.acceleration, w.acceleration);
  f("deceleration", m.deceleration, w.deceleration);
  f("jerk", m.jerk, w.jerk);
  f("distance", m.distance, w.distance);
  f("slave_period", m.slave_period, w.slave_period);
  require_coupling(m, f);
}

/// True if the message names a queue exactly if its mode needs one.
inline bool names_queue(const Arm& arm) {
  if (arm.mode != ArmMode::queue) return arm.queue == 0 && arm.bank == 0;
  return arm.queue >= first_queue && arm.queue <= last_queue && arm.bank <= 1;
}

template <Is<Arm> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("command", m.command, w.command);
  f.require(m.command >= 1);
  f("mode", m.mode, w.mode);
  f("slave", m.slave, w.slave_hash);
  f("master", m.master, w.master_hash);
  each_field(m.coupling, w.coupling, f);
  f("queue", m.queue, w.queue);
  f("bank", m.bank, w.bank);
  f.require(names_queue(m));
  f("end", m.end, w.end);
  f.require(m.end == CamEnd::brake || m.mode == ArmMode::follow_input);
}

template <Is<Start> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("command", m.command, w.command);
  f.require(m.command >= 1);
  f("start_tick", m.tick, w.start_tick);
  f("when", m.when, w.when);
  f.require(m.tick >= -1 && (m.when == StartAt::tick || m.tick == -1));
  f("position", m.position, w.position);
  f.require(std::isfinite(m.position) &&
            (m.when == StartAt::master_position || is_zero(m.position)));
}

template <Is<Stop> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("command", m.command, w.command);
  f.require(m.command >= 1);
  f("stop_mode", m.mode, w.stop_mode);
}

template <Is<Heartbeat> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("command", m.command, w.command);
  f.require(m.command >= 1);
  f("release", m.release, w.release);
}

template <Is<Ack> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("boot", m.boot, w.boot);
  f.require(m.boot >= 1);
  f("table", m.table, w.table);
  f.require(m.table < most_tables);
  f("next", m.next, w.next);
  f.bits(m.mask, w.mask);
  f("credit", m.credit, w.credit);
  f("complete", m.complete, w.complete);
  f("refusal", m.refusal, w.refusal);
  f("reason", m.reason, w.reason);
}

template <Is<Reply> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("boot", m.boot, w.boot);
  f.require(m.boot >= 1);
  f("command", m.command, w.command);
  f.require(m.command >= 1);
  f("outcome", m.outcome, w.outcome);
  f("refusal", m.refusal, w.refusal);
  f("cause", m.cause, w.cause);
  f("reason", m.reason, w.reason);
}

template <Is<Claim> M, class W, class F>
void each_field(M& m, W& w, F& f) {
  f("boot", m.boot, w.boot);
  f.require(m.boot >= 1);
  f("rival", m.rival, w.rival);
  f.require(m.rival >= 0);
  f("up", m.up, w.up);
}

// ---- commands -----------------------------------------------------------------------------------

inline void kind_field(const Command& m, std::int8_t& number, const PutFields& /*f*/) {
  number = info(m.kind).number;
  if (number < 0) throw InputError("command", name(m.kind), "is not a command of a client");
}
inline void kind_field(Command& m, std::int8_t number, GetFields& f) {
  const auto kind = kind_of_number(number);
  f.require(kind.has_value());
  if (kind) m.kind = *kind;
}

inline void values_field(const Command& m, auto& values, const PutFields& /*f*/) {
  std::copy_n(m.value.begin(), std::size(values), values);
}
inline void values_field(Command& m, const auto& values, const GetFields& /*f*/) {
  std::copy_n(values, std::size(values), m.value.begin());
}

/// The receiver rejects values out of range, with a reason that the sender can use.
template <class M, class W, class F>
requires(Is<M, Command> || Is<M, PathCommand>)  //
    void each_field(M& m, W& w, F& f) {
  f("command", m.command, w.command);
  f.require(m.command >= 1);
  kind_field(m, w.kind, f);
  f.require(is_path_command(m) == Is<M, PathCommand>);
  f("at", m.at, w.at);
  f.require(m.at >= -1);
  values_field(m, w.value, f);
}

}  // namespace jounce::wire
