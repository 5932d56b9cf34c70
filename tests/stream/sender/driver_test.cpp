// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/driver.hpp"

#include <functional>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/sender/client.hpp"

#include "stream/harness.hpp"

namespace jounce::driver_test {
namespace {

using namespace std::chrono_literals;
using test::World;
using testing::ElementsAre;

TEST(Driver, CountsAndDropsWhatIsNoMessage) {
  MemoryNetwork network;
  MemoryTransport link(network);
  link.subscribe("a", 10);
  auto bytes = wire::encode({"feeder", 1, wire::Start{.command = 1}});
  link.send("a", bytes);
  bytes.back() ^= std::byte{1};
  link.send("a", bytes);
  link.send("a", {});
  Rejects rejects;
  EXPECT_TRUE(next_message(link, Nanos{}, rejects).has_value());
  EXPECT_FALSE(next_message(link, Nanos{}, rejects).has_value());
  EXPECT_FALSE(next_message(link, Nanos{}, rejects).has_value());
  EXPECT_EQ(rejects[wire::Reject::wrong_checksum], 1U);
  EXPECT_EQ(rejects[wire::Reject::too_short], 1U);
  EXPECT_EQ(rejects.total(), 2U);
}

TEST(Driver, NoiseDoesNotHideAMessageBehindIt) {
  World world;
  const std::vector<std::byte> noise(100);
  for (int i = 0; i < 20; ++i) world.link.send("JOUNCE2.feeder.table", noise);
  for (auto message : test::messages_of(test::sine_table(5), 1)) {
    message.challenge = world.executor->pump.receiver().challenge();
    send_message(world.link, message);
  }
  world.executor->turn();
  EXPECT_THAT(world.executor->log, ElementsAre("ready 1"));
  EXPECT_EQ(world.executor->pump.rejects()[wire::Reject::wrong_magic], 20U);
}

TEST(Driver, AFloodOfStrangersIsAnsweredWithinBounds) {
  World world;
  wire::Message owner = test::messages_of(test::sine_table(5), 1).front();
  owner.challenge = world.executor->pump.receiver().challenge();
  send_message(world.link, owner);
  world.executor->turn();
  MemoryTransport ear(world.network);
  ear.subscribe("JOUNCE2.feeder.reply", 1000);
  for (std::int64_t session = 2; session < 66;
       ++session) {  // the greatest number that may wait on a channel
    send_message(world.link, {"feeder", session, owner.body});
    send_message(world.link, {"feeder", session, wire::Heartbeat{.command = 1}});
  }
  world.executor->turn();
  Rejects rejects;
  int answers = 0;
  while (next_message(ear, Nanos{}, rejects)) ++answers;
  EXPECT_GT(answers, 0);
  EXPECT_LE(answers, 64) << "in one turn";
}

/// A link whose sends fail, as with a full buffer of the system (ENOBUFS).
class FailingTransport : public Transport {
 public:
  FailingTransport(Transport& link, std::function<bool()> fails)
      : link_(link), fails_(std::move(fails)) {}
  void subscribe(const std::string& channel, int capacity) override {
    link_.subscribe(channel, capacity);
  }
  void send(const std::string& channel, std::span<const std::byte> bytes) override {
    if (fails_()) throw TransportError("No buffer space available");
    link_.send(channel, bytes);
  }
  std::optional<Packet> receive(Nanos timeout) override { return link_.receive(timeout); }

 private:
  Transport& link_;
  std::function<bool()> fails_;
};

TEST(Driver, AFailedSendIsALostPacket) {
  World world;
  int sends = 0;
  FailingTransport link(world.link, [&] { return ++sends % 3 == 0; });
  const StreamOutcome outcome =
      stream_tables(link, test::plan_of(test::sine_table(5000)), {}, world.clock, 1);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_EQ(world.executor->log.back(), "released 1");
  Client client(link, "feeder", {}, world.clock);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(client.beat().ok()) << i;
}

TEST(Driver, ALinkThatSendsNothingHasFailed) {
  World world;
  bool fails = false;
  FailingTransport link(world.link, [&] { return fails; });
  Client client(link, "feeder", {}, world.clock);
  ASSERT_TRUE(client.beat().ok());
  fails = true;
  EXPECT_THROW(static_cast<void>(client.beat()), TransportError);
  EXPECT_THROW(static_cast<void>(
                   stream_tables(link, test::plan_of(test::sine_table(10)), {}, world.clock, 2)),
               TransportError);
  EXPECT_LT(world.now, 2s);
}

TEST(Driver, PublishesTheStatus) {
  World world;
  world.link.subscribe("JOUNCE2.feeder.status", 1);
  world.executor->pump.publish({.state = State::standstill, .tick = 7});
  Rejects rejects;
  const auto message = next_message(world.link, Nanos{}, rejects);
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(std::get<wire::Status>(message->body).tick, 7);
  EXPECT_EQ(message->session, 0);
}

TEST(Driver, ReadsTheNewestStatus) {
  World world;
  EXPECT_FALSE(next_status(world.link, "feeder", 50ms, {}, world.clock).has_value());
  EXPECT_EQ(world.now, 50ms);
  std::int64_t tick = 0;
  const auto publish = [&] { world.executor->pump.publish({.tick = ++tick}); };
  for (int i = 0; i < 5; ++i) publish();
  world.each_turn = publish;
  const auto message = next_status(world.link, "feeder", 50ms, {}, world.clock);
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(std::get<wire::Status>(message->body).tick, 6) << "1 had waited; 2 to 5 did not fit";
}

TEST(Driver, AnOperatorStopsAnyStreamer) {
  World world;
  Sender streamer(test::plan_of(test::sine_table(50'000)), 1);
  world.link.subscribe("JOUNCE2.feeder.reply", 10);
  for (int i = 0; i < 3; ++i) {
    for (const auto& message : streamer.poll(world.now)) send_message(world.link, message);
    world.pass(1ms);
    Rejects rejects;
    while (const auto answer = next_message(world.link, Nanos{}, rejects))
      streamer.receive(*answer, world.now);
  }
  ASSERT_EQ(world.executor->pump.receiver().session(), 1);
  EXPECT_TRUE(operator_stop(world.link, "feeder", wire::StopMode::abort, 1s, {}, world.clock));
  EXPECT_THAT(world.executor->log, ElementsAre("abort 0", "operator 1"));
}

TEST(Driver, AnOperatorsStopGetsThroughABadLink) {
  World world;
  LossyTransport bad(world.link, {.seed = 3, .lost = 0.5, .corrupted = 0.2}, world.clock);
  EXPECT_TRUE(operator_stop(bad, "feeder", wire::StopMode::stop, 2s, {}, world.clock));
  EXPECT_THAT(world.executor->log, ElementsAre("stop 0")) << "once";
}

TEST(Driver, AStopWithoutAnAnswerIsReported) {
  World world;
  world.shut_down();
  EXPECT_FALSE(operator_stop(world.link, "feeder", wire::StopMode::stop, 1s, {}, world.clock));
  EXPECT_LT(world.now, 1100ms);
}

TEST(Driver, RandomIdsArePositiveAndDiffer) {
  const auto a = random_id(), b = random_id();
  EXPECT_GT(a, 0);
  EXPECT_GT(b, 0);
  EXPECT_NE(a, b);
}

TEST(MemoryTransport, KeepsTheOldestOfAFullQueue) {
  MemoryNetwork network;
  MemoryTransport one(network), two(network);
  two.subscribe("state", 1);
  for (const int value : {1, 2, 3}) {
    const auto byte = static_cast<std::byte>(value);
    one.send("state", {&byte, 1});
    one.send("other", {&byte, 1});
  }
  const auto packet = two.receive(Nanos{});
  ASSERT_TRUE(packet.has_value());
  EXPECT_EQ(packet->bytes, std::vector<std::byte>{std::byte{1}});
  EXPECT_FALSE(two.receive(Nanos{}).has_value());
  EXPECT_FALSE(one.receive(Nanos{}).has_value());
}

}  // namespace
}  // namespace jounce::driver_test
