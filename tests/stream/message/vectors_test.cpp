// SPDX-License-Identifier: Apache-2.0
// The page's test vectors: bytes that a script made from the page alone, and their meaning. They
// are also read by lcm-gen's own code.
#include <fstream>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "jounce/stream/message/wire.hpp"

#include "stream/message/samples.hpp"
#include "stream/src/message/lcm_body.hpp"

namespace jounce::vectors_test {
namespace {

using wire::Bytes;
using wire::Message;

/// Hexadecimal digits, and (n) for n zeros.
Bytes bytes_of(const std::string& text) {
  Bytes bytes;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '(') {
      const std::size_t end = text.find(')', i);
      bytes.resize(bytes.size() + std::stoul(text.substr(i + 1, end - i - 1)));
      i = end + 1;
    } else {
      bytes.push_back(static_cast<std::byte>(std::stoi(text.substr(i, 2), nullptr, 16)));
      i += 2;
    }
  }
  return bytes;
}

/// By type and "none" or "key".
std::map<std::string, Bytes> vectors() {
  std::ifstream file(JOUNCE_SOURCE_DIR "/docs/stream-vectors.txt");
  std::map<std::string, Bytes> all;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t hex = line.rfind(' ');
    all[line.substr(0, hex)] = bytes_of(line.substr(hex + 1));
  }
  return all;
}

wire::Key the_key() {
  wire::Key key;
  std::iota(key.begin(), key.end(), std::uint8_t{0});
  return key;
}

CommandValues counted() {
  CommandValues values{};
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

/// The messages of the vectors.
std::vector<Message> messages() {
  Sha256 hash{}, reversed{};
  std::iota(hash.begin(), hash.end(), std::uint8_t{1});
  std::copy(hash.rbegin(), hash.rend(), reversed.begin());
  const CouplingSpec coupling{2.5, -3.5, 0.5, 7,   false, true, StartMode::ramp_in_neg,
                              100, 200,  300, 400, 500,   360};
  wire::Histogram lateness{}, computing{};
  std::iota(lateness.begin(), lateness.end(), 100);
  std::iota(computing.begin(), computing.end(), 200);
  const Units units{"deg", "mm"};
  wire::Status status{.state = State::synchronized_motion,
                      .next = wire::Next::waiting,
                      .tick = 5000,
                      .cycle_ns = 1'000'000,
                      .master_position = 359.5,
                      .slave_position = -2.5,
                      .slave_velocity = 1e-9,
                      .table = {1, 2, 3, 4, 5, 6, 7, 8},
                      .late_ticks = 17,
                      .finished = 5,
                      .stopped = 9,
                      .actual_position = -2.25,
                      .following_error = -0.25,
                      .override_ = 0.5,
                      .progress = wire::Progress::running,
                      .reason = 31,
                      .queue_rows = 77,
                      .queue_capacity = 2048,
                      .outputs = 0x80000001,
                      .boot = 77,
                      .rejected = 12,
                      .not_authentic = 11,
                      .lateness = lateness,
                      .computing = computing,
                      .units = units,
                      .start_command = 5,
                      .start = wire::StartOutcome::dropped,
                      .start_cause = 55,
                      .start_reason = "would_reverse",
                      .held = true,
                      .homed = true,
                      .unwritten = 6,
                      .gear = wire::GearState::in_gear,
                      .gear_master = true,
                      .ratio = -0.5,
                      .correction = 0.0125};
  const std::vector<wire::Row> rows{{0.1, 2, 0, 40, 0, 0, wire::RowOrder::cubic, false},
                                    {0.25, 9, 40, 0, 0, 0, wire::RowOrder::cubic, true}};
  const auto ours = [](wire::Body body) { return Message{"feeder", 11, std::move(body), 99}; };
  return {
      ours(wire::Header{3, hash, Domain::master, Interpolation::quintic_hermite,
                        Extrapolation::wrap, units, 401, 4, 400, 2}),
      ours(wire::Chunk{3, 1, 400, 1, 4, {360, 0.5, -0.25, 0.125}}),
      ours(wire::Arm{1, wire::ArmMode::follow_table, hash, reversed, coupling}),
      ours(wire::Start{2, -1, StartAt::master_position, 90.5}),
      {"feeder", 0, wire::Stop{123456789, wire::StopMode::abort}},
      ours(wire::Heartbeat{3, true}),
      ours(wire::Ack{77, 3, 1, 5, 8, false, wire::Refusal::bad_table, "no table"}),
      ours(wire::Reply{77, 2, wire::Outcome::refused, wire::Refusal::axis, 41, "start_position"}),
      ours(status),
      ours(wire::Command{7, CommandKind::move_absolute, 4000, {120, 200, 1000, 2000, 3e4, -1}}),
      ours(wire::Command{8, CommandKind::move_circular_absolute, -1, counted()}),
      ours(wire::Queue{64, Domain::master, units, wire::QueueMode::static_, 512, -3,
                       wire::QueueEvent::pass, 12.5, -1, 100, false, -7.5, -2,
                       wire::Queue::no_bound}),
      ours(wire::Rows{64, 1, 5, 1000, rows}),
      ours(wire::QueueAck{77,
                          64,
                          {3, 4},
                          {1, 2},
                          {100, 200},
                          321,
                          wire::Progress::starving,
                          wire::Refusal::bad_row,
                          322,
                          "row 323"}),
      {"line", 0, wire::Master{9, 1'700'000'000'123'456'789, 2, true, 359.5, -7.25, "mm"}},
      {"feeder", 0, wire::Event{77, 44, wire::EventKind::track, 31, true, 5000, 0.000412, 88.5},
       55},
      {"feeder", 0,
       wire::MasterStatus{77, "line", "mm", 5000, false, 359.25, -7.5, 0.004, 1234, 56}},
      {"feeder", 0, wire::Claim{77, 78, true}},
      {"feeder", 0,
       wire::GroupStatus{77,
                         5000,
                         {"x", "y"},
                         {10, -2.5},
                         true,
                         12,
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

/// Calls f with an empty message of the type in which a message travels.
template <class F>
void with_type_of(const Message& message, F f) {
  const auto* const command = std::get_if<wire::Command>(&message.body);
  if (command != nullptr && wire::is_path_command(*command))
    return f(typename wire::LcmOf<wire::PathCommand>::type{});
  std::visit(
      [&](const auto& body) { f(typename wire::LcmOf<std::decay_t<decltype(body)>>::type{}); },
      message.body);
}

TEST(Vectors, MatchTheCode) {
  const auto all = vectors();
  const auto said = messages();
  ASSERT_EQ(all.size(), 2 * said.size());
  ASSERT_EQ(said.size(), std::variant_size_v<wire::Body> + 1) << "commands have two types";
  for (const Message& message : said) {
    std::string type;
    with_type_of(message, [&](const auto& lcm) { type = lcm.getTypeName(); });
    SCOPED_TRACE(type);
    for (const auto& [name, key] : {std::pair{" none", std::optional<wire::Key>{}},
                                    std::pair{" key", std::optional{the_key()}}}) {
      ASSERT_TRUE(all.count(type + name));
      const Bytes& bytes = all.at(type + name);
      EXPECT_EQ(wire::encode(message, key), bytes) << name;
      const auto decoded = wire::decode(bytes, key);
      ASSERT_TRUE(std::holds_alternative<Message>(decoded)) << name;
      EXPECT_EQ(test::text(std::get<Message>(decoded)), test::text(message));
    }
  }
}

TEST(Vectors, AreReadByLcmsOwnDecoder) {
  const auto all = vectors();
  for (const Message& message : messages()) {
    with_type_of(message, [&](auto lcm) {
      const Bytes& bytes = all.at(std::string(lcm.getTypeName()) + " key");
      ASSERT_EQ(lcm.decode(bytes.data(), 0, static_cast<int>(bytes.size())),
                static_cast<int>(bytes.size()));
      EXPECT_EQ(lcm.envelope.version, 2);
      EXPECT_EQ(lcm.envelope.session, message.session);
      EXPECT_EQ(lcm.envelope.challenge, message.challenge);
      EXPECT_EQ(reinterpret_cast<const char*>(lcm.envelope.executor), message.executor);
    });
  }
}

TEST(Vectors, CountOnlyWithTheirKey) {
  wire::Key other = the_key();
  other[31] ^= 1;
  for (const auto& [name, bytes] : vectors()) {
    const bool has_key = name.ends_with(" key");
    EXPECT_EQ(std::get<wire::Reject>(wire::decode(bytes, other)), wire::Reject::not_authentic);
    EXPECT_EQ(std::holds_alternative<Message>(wire::decode(bytes)), !has_key) << name;
    EXPECT_EQ(std::holds_alternative<Message>(wire::decode(bytes, the_key())), has_key) << name;
  }
}

}  // namespace
}  // namespace jounce::vectors_test
