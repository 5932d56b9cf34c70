#include "jounce/stream/lcm_transport.hpp"

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/wire.hpp"

#include "stream/harness.hpp"
#include "stream/samples.hpp"

namespace jounce {
namespace {

using namespace std::chrono_literals;

TEST(LcmTransport, CarriesEveryMessage) {
  LcmTransport link("memq://");
  for (const auto lane : {wire::Lane::table, wire::Lane::command, wire::Lane::reply,
                          wire::Lane::status, wire::Lane::masters})
    link.subscribe(wire::channel("feeder_2-B", lane), 10);
  link.subscribe(wire::channel("feeder_2-B", wire::Lane::event), 10);
  link.subscribe(wire::channel("line", wire::Lane::master), 10);
  for (const wire::Message& message : test::samples()) {
    send_message(link, message);
    Rejects rejects;
    const auto back = next_message(link, 1s, rejects);
    ASSERT_TRUE(back.has_value()) << message.body.index();
    EXPECT_EQ(test::text(*back), test::text(message));
    EXPECT_EQ(back->executor, message.executor);
    EXPECT_EQ(back->session, message.session);
  }
  EXPECT_FALSE(link.receive(Nanos{}).has_value());
}

TEST(LcmTransport, TakesAChannelForItsNameNotForAPattern) {
  LcmTransport link("memq://");
  link.subscribe("JOUNCE2.a_-b.table", 10);
  const std::byte byte{1};
  link.send("JOUNCE2xa_-bxtable", {&byte, 1});
  link.send("JOUNCE2.a_-b.tables", {&byte, 1});
  link.send("JOUNCE2.a_-b.table", {&byte, 1});
  const auto packet = link.receive(1s);
  ASSERT_TRUE(packet.has_value());
  EXPECT_EQ(packet->channel, "JOUNCE2.a_-b.table");
  EXPECT_FALSE(link.receive(Nanos{}).has_value());
}

TEST(LcmTransport, HearsAllOfAKindByAStarAndOneThingOnce) {
  LcmTransport link("memq://");
  link.subscribe(wire::channel("*", wire::Lane::status), 10);
  link.subscribe(wire::channel("*", wire::Lane::status), 10);
  const std::byte byte{1};
  for (const char* channel :
       {"JOUNCE2.a_-b.status", "JOUNCE2.a.b.status", "JOUNCE2.knife.reply", "JOUNCE2.knife.status"})
    link.send(channel, {&byte, 1});
  for (const char* heard : {"JOUNCE2.a_-b.status", "JOUNCE2.knife.status"}) {
    const auto packet = link.receive(1s);
    ASSERT_TRUE(packet.has_value());
    EXPECT_EQ(packet->channel, heard);
  }
  EXPECT_FALSE(link.receive(Nanos{}).has_value());
}

TEST(LcmTransport, AWholeStreamRunsThroughIt) {
  // Streamer and executor share one link: memq:// is private to its object.
  LcmTransport link("memq://");
  Nanos now{};
  test::Executor executor(
      link, [&] { return now; }, 9);
  link.subscribe(wire::channel("feeder", wire::Lane::reply), 64);
  const Table table = test::sine_table(20'000, Rule::quintic_hermite);
  Sender sender(test::plan_of(table), 1);
  for (int i = 0; i < 1000 && !sender.ended(); ++i, now += 1ms) {
    for (const auto& message : sender.poll(now)) send_message(link, message);
    Rejects rejects;
    while (const auto message = next_message(link, Nanos{}, rejects)) {
      executor.pump.receiver().receive(*message, now);
      sender.receive(*message, now);
    }
    executor.turn();
    if (sender.at_goal()) sender.release();
  }
  EXPECT_TRUE(sender.outcome().started) << sender.outcome().reason;
  EXPECT_TRUE(executor.pump.receiver().store().find(content_hash(table, test::move_units)));
}

TEST(LcmTransport, WantsAnExplicitUrl) {
  EXPECT_THROW(LcmTransport(""), InputError);
  EXPECT_THROW(LcmTransport("tcpq://"), InputError);
}

TEST(LcmTransport, SaysWhatIsWrongWithTheNetwork) {
  // No multicast group, so LCM refuses it whatever the network is like.
  try {
    LcmTransport link("udpm://127.0.0.1:7667");
    FAIL() << "must not be usable";
  } catch (const TransportError& error) {
    EXPECT_NE(std::string(error.what()).find("ip route add 224.0.0.0/4 dev lo"), std::string::npos);
  }
}

}  // namespace
}  // namespace jounce
