// SPDX-License-Identifier: Apache-2.0
// Conditions that hold for all messages in any order, checked over random conversations.
#include <algorithm>

#include <gtest/gtest.h>

#include "jounce/stream/detail/receiver.hpp"

#include "stream/harness.hpp"
#include "support/random.hpp"

namespace jounce::receiver_property_test {
namespace {

using namespace std::chrono_literals;

/// Three streamers with nothing but random messages, some of them false, and an axis that answers
/// at random, perhaps too late.
class Conversation {
 public:
  explicit Conversation(std::uint64_t seed) : random_(seed) {
    for (const Table& table : {test::sine_table(3), test::sine_table(700)})
      for (const auto& message : test::messages_of(table, 1)) parts_.push_back(message.body);
    // The last one is false: another table than its header announces.
    auto forged = std::get<wire::Chunk>(parts_.back());
    forged.values.back() += 1;
    parts_.push_back(forged);
    for (auto& part : parts_) number_tables(part);
  }

  void step() {
    now_ += random_.below(20) == 0 ? 600ms : 1ms;
    const std::size_t what = random_.below(std::size_t{10});
    if (what < 6) {
      say(parts_[random_.below(parts_.size())]);
    } else if (what < 9) {
      say(command());
    } else {
      answer();
    }
    if (random_.below(3) == 0) static_cast<void>(receiver_.poll(now_));
    while (const auto event = receiver_.take_event())
      std::visit([&](const auto& e) { check(e); }, *event);
    ASSERT_LE(receiver_.store().bytes(), memory);
  }

  std::size_t starts = 0, tables = 0, ends = 0;

 private:
  // For the larger table of 700 knots and half of it.
  static constexpr std::size_t memory = 25'000;

  /// The small table is number 0, the large one number 1.
  static void number_tables(wire::Body& body) {
    if (auto* header = std::get_if<wire::Header>(&body)) header->table = header->knots == 3 ? 0 : 1;
    if (auto* chunk = std::get_if<wire::Chunk>(&body)) chunk->table = chunk->knots == 3 ? 0 : 1;
  }

  void say(wire::Body body) {
    const auto session = static_cast<std::int64_t>(1 + random_.below(3)) + 3 * (tick_++ / 200);
    const bool is_stop = std::holds_alternative<wire::Stop>(body);
    const bool operators = is_stop && random_.below(8) == 0;
    // Mostly the last challenge that a streamer received, now and then an old one, or none.
    if (random_.below(20) == 0) told_ = random_.below(4) == 0 ? 0 : receiver_.challenge();
    const std::int64_t challenge = random_.below(10) == 0 ? told_ : receiver_.challenge();
    receiver_.receive({"feeder", operators ? 0 : session, std::move(body),
                       operators && random_.below(2) == 0 ? 0 : challenge},
                      now_);
  }

  wire::Body command() {
    number_ += static_cast<std::int32_t>(random_.below(3));
    const auto number = std::max(1, number_ - static_cast<std::int32_t>(random_.below(3)));
    const auto& header = std::get<wire::Header>(parts_[random_.below(2) == 0 ? 0 : 2]);
    switch (random_.below(8)) {
      case 0:
        return wire::Stop{.command = number};
      case 1:
        return wire::Heartbeat{.command = number, .release = random_.below(4) == 0};
      case 2:
      case 3:
      case 4:
        return wire::Start{.command = number};
      default:
        return wire::Arm{.command = number, .slave = header.hash};
    }
  }

  void answer() {
    if (asked_.empty()) return;
    const bool in_time = random_.below(3) != 0;
    const auto [session, command] = in_time ? asked_.back() : asked_[random_.below(asked_.size())];
    if (random_.below(4) == 0) return receiver_.refuse(session, command, "no", 1);
    receiver_.accept(session, command);
    accepted_.emplace_back(session, command);
  }

  void check(const TableReady& e) {
    ++tables;
    EXPECT_EQ(content_hash(*e.table.table, e.table.units), e.table.hash);
    EXPECT_TRUE(e.table.hash == std::get<wire::Header>(parts_[0]).hash ||
                e.table.hash == std::get<wire::Header>(parts_[2]).hash);
  }
  void check(const ArmRequested& e) {
    armed_ = {e.session, e.command};
    asked_.push_back(armed_);
    EXPECT_NE(e.slave.table, nullptr);
  }
  void check(const StartRequested& e) {
    ++starts;
    EXPECT_EQ(armed_.first, e.session) << "armed by the same session, and nothing came between";
    EXPECT_NE(std::find(accepted_.begin(), accepted_.end(), armed_), accepted_.end())
        << "and the axis had agreed";
    asked_.emplace_back(e.session, e.command);
  }
  void check(const StopRequested& e) {
    armed_ = {};
    asked_.emplace_back(e.session, e.command);
  }
  template <class Other>
  void check(const Other& /*of queues and orders*/) {}
  void check(const SessionEnded& /*e*/) {
    ++ends;
    armed_ = {};
  }

  test::Random random_;
  Nanos now_{};
  std::vector<wire::Body> parts_;
  Receiver receiver_{{.executor = "feeder", .memory = memory}, 1};
  std::int32_t number_ = 1;
  std::int64_t tick_ = 0, told_ = 0;
  std::pair<std::int64_t, std::int32_t> armed_;
  std::vector<std::pair<std::int64_t, std::int32_t>> asked_, accepted_;
};

TEST(ReceiverProperty, NothingStartsThatIsNotWholeArmedAndAgreedTo) {
  std::size_t starts = 0, tables = 0, ends = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Conversation conversation(seed);
    for (int i = 0; i < 1000 && !testing::Test::HasFailure(); ++i) conversation.step();
    starts += conversation.starts;
    tables += conversation.tables;
    ends += conversation.ends;
  }
  // The conversations must get far enough for the properties to be evidence.
  EXPECT_GT(starts, 500U);
  EXPECT_GT(tables, 1000U);
  EXPECT_GT(ends, 1000U);
}

}  // namespace
}  // namespace jounce::receiver_property_test
