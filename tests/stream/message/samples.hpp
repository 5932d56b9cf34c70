// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce::test {

/// One message of each kind; no two fields of one are equal.
inline std::vector<wire::Message> samples() {
  Sha256 one{}, two{};
  for (std::size_t i = 0; i < one.size(); ++i) {
    one[i] = static_cast<std::uint8_t>(i + 1);
    two[i] = static_cast<std::uint8_t>(0xF0 - i);
  }
  std::vector<double> values;
  for (int i = 0; i < 1599; ++i) values.push_back(0.1 * i - 30);
  const CouplingSpec coupling{2.5, -3.5, 0.5, 7,   false, true, StartMode::ramp_in_neg,
                              100, 200,  300, 400, 500,   360};
  std::vector<wire::Row> rows;
  for (int i = 1; i <= 199; ++i)
    rows.push_back({0.1 * i, 0.2 * i, 3.0 * i, 4.0 * i, -5.0 * i, -6.0 * i, wire::RowOrder::quintic,
                    i == 199});
  wire::Histogram lateness{}, computing{};
  for (int i = 0; i < 16; ++i) {
    lateness[static_cast<std::size_t>(i)] = 1000 + i;
    computing[static_cast<std::size_t>(i)] = 2000 + i;
  }
  const std::string name = "feeder_2-B";
  return {
      {name, 11,
       wire::Header{3,
                    one,
                    Domain::master,
                    Interpolation::quintic_hermite,
                    Extrapolation::wrap,
                    {"deg", "µm"},
                    1000,
                    4,
                    250,
                    5}},
      {name, 12, wire::Chunk{4, 1, 533, 533, 3, values}},
      {name, 13, wire::Arm{2, wire::ArmMode::follow_table, one, two, coupling}},
      {name, 13,
       wire::Arm{
           .command = 2, .mode = wire::ArmMode::follow_input, .slave = one, .end = CamEnd::extend}},
      {name, 13, wire::Arm{.command = 3, .mode = wire::ArmMode::queue, .queue = 65, .bank = 1}},
      {name, 13, wire::Arm{.command = 4, .mode = wire::ArmMode::path, .slave = one}},
      {name, 14, wire::Start{3, 1'234'567'890'123}, 141},
      {name, 14, wire::Start{4, -1, StartAt::master_position, 90.5}, 142},
      {name, 15, wire::Stop{4, wire::StopMode::abort}},
      {name, 16, wire::Heartbeat{5, true}},
      {name, 17,
       wire::Ack{987, 3, 77, 0x8000'0000'0000'0005, 8, true, wire::Refusal::bad_table, "why"}},
      {name, 18,
       wire::Reply{986, 6, wire::Outcome::refused, wire::Refusal::axis, 41, "start_position"}},
      {name, 19,
       wire::Status{State::synchronized_motion,
                    wire::Next::armed,
                    100,
                    1'000'000,
                    1.25,
                    -2.5,
                    1e-9,
                    {1, 2, 3, 4, 5, 6, 7, 8},
                    3,
                    17,
                    5,
                    9,
                    -2.25,
                    -0.25,
                    0.375,
                    0.5,
                    wire::Progress::starving,
                    31,
                    77,
                    2048,
                    0x80000001,
                    985,
                    12,
                    11,
                    lateness,
                    computing,
                    {"rev", "µm"},
                    7,
                    wire::StartOutcome::dropped,
                    55,
                    "would_reverse",
                    true,
                    true,
                    5}},
      {name, 20,
       wire::Command{7, CommandKind::move_absolute, 4000, {120, 200, 1000, 2000, 3e4, -1}}, 200},
      {name, 21,
       wire::Queue{66,
                   Domain::master,
                   {"deg", "mm"},
                   wire::QueueMode::static_,
                   512,
                   -3,
                   wire::QueueEvent::pass,
                   12.5,
                   -1,
                   100,
                   false,
                   -7.5,
                   -2,
                   wire::Queue::no_bound},
       201},
      {name, 22, wire::Rows{67, 1, 5, 1000, rows}, 202},
      {name, 23,
       wire::QueueAck{984,
                      68,
                      {3, 4},
                      {0x8000'0000'0000'0001, 2},
                      {100, 200},
                      321,
                      wire::Progress::running,
                      wire::Refusal::bad_row,
                      322,
                      "row 323"},
       203},
      {"line", 0, wire::Master{9, 1'700'000'000'123'456'789, 2, true, 359.5, -7.25, "mm"}},
      {name, 0, wire::Event{983, 44, wire::EventKind::track, 31, true, 5000, 0.000412, 88.5}, 204},
      {name, 0, wire::MasterStatus{983, "line", "mm", 5000, false, 359.25, -7.5, 0.004, 1234, 56}},
      {name, 0, wire::Claim{983, 982, true}},
      {name, 0,
       wire::GroupStatus{983,
                         5001,
                         {"x", "y"},
                         {1.5, -2.5},
                         true,
                         17,
                         3,
                         true,
                         12.5,
                         400,
                         80,
                         4.25,
                         380,
                         {"mm", "deg"}}},
  };
}

/// Every field of a message in words, to compare and to print.
struct Text {
  std::ostringstream out;

  template <class... Fields>
  void fields(const Fields&... values) {
    out.precision(17);
    ((out << values << ' '), ...);
  }
  void operator()(const wire::Header& m) {
    fields("header", m.table, hex(m.hash), name(m.axis), name(m.rule), name(m.outside), m.units.x,
           m.units.position, m.knots, m.columns, m.per_chunk, m.chunks);
  }
  void operator()(const wire::Chunk& m) {
    fields("chunk", m.table, m.seq, m.first_knot, m.knots, m.columns);
    for (const double value : m.values) fields(value);
  }
  void operator()(const wire::Arm& m) {
    const CouplingSpec& c = m.coupling;
    fields("arm", m.command, name(m.mode), m.queue, static_cast<int>(m.bank), hex(m.slave),
           hex(m.master), name(c.start), c.master_absolute, c.slave_absolute, c.master_scaling,
           c.master_offset, c.slave_scaling, c.slave_offset, static_cast<int>(m.end));
    for (const auto& magnitude :
         {c.velocity_diff, c.acceleration, c.deceleration, c.jerk, c.distance, c.slave_period})
      fields(magnitude.value_or(-1));
  }
  void operator()(const wire::Start& m) {
    fields("start", m.command, m.tick, static_cast<int>(m.when), m.position);
  }
  void operator()(const wire::Stop& m) { fields("stop", m.command, static_cast<int>(m.mode)); }
  void operator()(const wire::Heartbeat& m) { fields("heartbeat", m.command, m.release); }
  void operator()(const wire::Ack& m) {
    fields("ack", m.boot, m.table, m.next, m.mask, m.credit, m.complete, name(m.refusal), m.reason);
  }
  void operator()(const wire::Reply& m) {
    fields("reply", m.boot, m.command, static_cast<int>(m.outcome), name(m.refusal), m.cause,
           m.reason);
  }
  void operator()(const wire::Status& m) {
    fields("status", name(m.state), name(m.next), m.tick, m.cycle_ns, m.master_position,
           m.slave_position, m.slave_velocity, m.last_error, m.late_ticks, m.finished, m.stopped,
           m.actual_position, m.following_error, m.torque, m.override_, name(m.progress), m.reason,
           m.units.x, m.units.position, m.queue_rows, m.queue_capacity, m.outputs, m.boot,
           m.rejected, m.not_authentic, m.start_command, static_cast<int>(m.start), m.start_cause,
           m.start_reason, m.held, m.homed, static_cast<int>(m.unwritten), name(m.gear),
           m.gear_master, m.ratio, m.correction);
    for (const unsigned byte : m.table) fields(byte);
    for (const int count : m.lateness) fields(count);
    for (const int count : m.computing) fields(count);
  }
  void operator()(const wire::Command& m) {
    fields("order", m.command, name(m.kind), m.at);
    for (const double value : m.value) fields(value);
  }
  void operator()(const wire::Queue& m) {
    fields("queue", m.queue, name(m.axis), m.units.x, m.units.position, static_cast<int>(m.mode),
           m.capacity, m.loops, static_cast<int>(m.event), m.event_position,
           static_cast<int>(m.event_direction), m.prefill, m.relative, m.origin, m.lowest,
           m.highest);
  }
  void operator()(const wire::Rows& m) {
    fields("rows", m.queue, static_cast<int>(m.bank), m.seq, m.first_row);
    for (const wire::Row& row : m.rows)
      fields(row.x_end, row.p_end, row.v_start, row.v_end, row.a_start, row.a_end,
             static_cast<int>(row.order), row.last);
  }
  void operator()(const wire::QueueAck& m) {
    fields("queue_ack", m.boot, m.queue, m.next[0], m.next[1], m.mask[0], m.mask[1], m.space[0],
           m.space[1], m.played, name(m.progress), name(m.refusal), m.row, m.reason);
  }
  void operator()(const wire::Master& m) {
    fields("master", m.seq, m.stamp_ns, m.clock, m.valid, m.position, m.velocity, m.unit);
  }
  void operator()(const wire::MasterStatus& m) {
    fields("master_status", m.boot, m.master, m.unit, m.tick, m.lost, m.position, m.velocity,
           m.age_s, m.taken, m.refused);
  }
  void operator()(const wire::GroupStatus& m) {
    fields("group_status", m.boot, m.tick, m.framed, m.line, m.commands, m.estimated, m.position,
           m.length, m.feed, m.remaining_s, m.look_ahead);
    for (const std::string& axis : m.axes) fields(axis);
    for (const double place : m.place) fields(place);
    for (const std::string& unit : m.units) fields(unit);
  }
  void operator()(const wire::Claim& m) { fields("claim", m.boot, m.rival, m.up); }
  void operator()(const wire::Event& m) {
    fields("event", m.boot, m.count, name(m.kind), m.number, m.on, m.tick, m.offset_s, m.position);
  }
};

inline std::string text(const wire::Message& message) {
  Text text;
  text.fields(message.challenge);
  std::visit(text, message.body);
  return text.out.str();
}

}  // namespace jounce::test
