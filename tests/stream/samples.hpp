#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "jounce/stream/message.hpp"

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
  const std::string name = "feeder_2-B";
  return {
      {name, 11,
       wire::Header{
           3, one, Axis::master, Rule::quintic_hermite, Outside::wrap, {"deg", "µm"}, 1000, 4, 5}},
      {name, 12, wire::Chunk{4, 1, 533, 533, 3, values}},
      {name, 13, wire::Arm{2, wire::ArmMode::follow_table, one, two, coupling}},
      {name, 14, wire::Start{3, 1'234'567'890'123}},
      {name, 15, wire::Stop{4, wire::StopMode::abort}},
      {name, 16, wire::Heartbeat{5, true}},
      {name, 17,
       wire::Ack{987, 3, 77, 0x8000'0000'0000'0005, 8, true, wire::Refusal::bad_table, "why"}},
      {name, 18,
       wire::Reply{986, 6, wire::Outcome::refused, wire::Refusal::axis, 41, "start_position"}},
      {name, 19,
       wire::Status{wire::AxisState::synchronized_motion,
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
                    9}},
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
           m.units.position, m.knots, m.columns, m.chunks);
  }
  void operator()(const wire::Chunk& m) {
    fields("chunk", m.table, m.seq, m.first_knot, m.knots, m.columns);
    for (const double value : m.values) fields(value);
  }
  void operator()(const wire::Arm& m) {
    const CouplingSpec& c = m.coupling;
    fields("arm", m.command, name(m.mode), hex(m.slave), hex(m.master), name(c.start),
           c.master_absolute, c.slave_absolute, c.master_scaling, c.master_offset, c.slave_scaling,
           c.slave_offset);
    for (const auto& magnitude :
         {c.velocity_diff, c.acceleration, c.deceleration, c.jerk, c.distance, c.slave_period})
      fields(magnitude.value_or(-1));
  }
  void operator()(const wire::Start& m) { fields("start", m.command, m.tick); }
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
           m.slave_position, m.slave_velocity, m.last_error, m.late_ticks, m.finished, m.stopped);
    for (const unsigned byte : m.table) fields(byte);
  }
};

inline std::string text(const wire::Message& message) {
  Text text;
  std::visit(text, message.body);
  return text.out.str();
}

}  // namespace jounce::test
