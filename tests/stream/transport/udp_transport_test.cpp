// SPDX-License-Identifier: Apache-2.0
// Over multicast on the loopback interface, which leaves this machine nowhere and needs no route.
#include "stream/src/transport/udp_transport.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/message/wire.hpp"

#include "stream/harness.hpp"
#include "stream/message/samples.hpp"

namespace jounce::udp_transport_test {
namespace {

using namespace std::chrono_literals;

/// A port that no other test of this machine uses at the same time.
MulticastAddress place() {
  return {.group = "239.255.76.67", .port = static_cast<std::uint16_t>(20'000 + getpid() % 40'000)};
}

/// The next packet; a loopback that delivers does so within the time.
std::optional<Packet> next(Transport& link) {
  return link.receive(5s);
}

TEST(UdpTransport, CarriesEveryMessage) {
  UdpTransport link(place());
  UdpTransport other(place());
  for (const auto lane :
       {wire::Lane::table, wire::Lane::command, wire::Lane::reply, wire::Lane::status,
        wire::Lane::masters, wire::Lane::event, wire::Lane::claim, wire::Lane::group})
    link.subscribe(wire::channel("feeder_2-B", lane), 10);
  link.subscribe(wire::channel("line", wire::Lane::master), 10);
  for (const wire::Message& message : test::samples()) {
    send_message(other, message);
    Rejects rejects;
    const auto back = next_message(link, 5s, rejects);
    ASSERT_TRUE(back.has_value()) << message.body.index();
    EXPECT_EQ(test::text(*back), test::text(message));
    EXPECT_EQ(back->executor, message.executor);
    EXPECT_EQ(back->session, message.session);
  }
  EXPECT_FALSE(link.receive(Nanos{}).has_value());
}

TEST(UdpTransport, TakesAChannelForItsNameNotForAPattern) {
  UdpTransport link(place());
  link.subscribe("JOUNCE2.a_-b.table", 10);
  const std::byte byte{1};
  link.send("JOUNCE2xa_-bxtable", {&byte, 1});
  link.send("JOUNCE2.a_-b.tables", {&byte, 1});
  link.send("JOUNCE2.a_-b.tabl", {&byte, 1});
  link.send("JOUNCE2.a_-b.table", {&byte, 1});
  const auto packet = next(link);
  ASSERT_TRUE(packet.has_value());
  EXPECT_EQ(packet->channel, "JOUNCE2.a_-b.table");
  EXPECT_EQ(packet->bytes, std::vector{byte});
  EXPECT_FALSE(link.receive(Nanos{}).has_value());
}

TEST(UdpTransport, ReceivesAllOfAKindByAStarAndOneThingOnce) {
  UdpTransport link(place());
  link.subscribe(wire::channel("*", wire::Lane::status), 10);
  link.subscribe(wire::channel("*", wire::Lane::status), 10);
  const std::byte byte{1};
  for (const char* channel :
       {"JOUNCE2.a_-b.status", "JOUNCE2.a.b.status", "JOUNCE2.knife.reply", "JOUNCE2.knife.status"})
    link.send(channel, {&byte, 1});
  for (const char* heard : {"JOUNCE2.a_-b.status", "JOUNCE2.knife.status"}) {
    const auto packet = next(link);
    ASSERT_TRUE(packet.has_value());
    EXPECT_EQ(packet->channel, heard);
  }
  EXPECT_FALSE(link.receive(Nanos{}).has_value());
}

TEST(UdpTransport, KeepsTheOldestOfEachChannel) {
  UdpTransport link(place());
  link.subscribe("few", 2);
  link.subscribe("many", 10);
  for (int i = 0; i < 5; ++i) {
    const auto byte = static_cast<std::byte>(i);
    link.send("few", {&byte, 1});
    link.send("many", {&byte, 1});
  }
  std::vector<int> few, many;
  while (const auto packet = link.receive(many.size() < 5 ? Nanos(5s) : Nanos{}))
    (packet->channel == "few" ? few : many).push_back(std::to_integer<int>(packet->bytes[0]));
  EXPECT_EQ(few, (std::vector{0, 1}));
  EXPECT_EQ(many, (std::vector{0, 1, 2, 3, 4}));
}

TEST(UdpTransport, AnotherPortIsAnotherBus) {
  UdpTransport link(place());
  MulticastAddress elsewhere = place();
  ++elsewhere.port;
  UdpTransport other(elsewhere);
  link.subscribe("a", 1);
  const std::byte byte{1};
  other.send("a", {&byte, 1});
  EXPECT_FALSE(link.receive(50ms).has_value());
}

TEST(UdpTransport, AWholeStreamRunsThroughIt) {
  UdpTransport link(place());
  UdpTransport executors(place());
  Nanos now{};
  test::Executor executor(
      executors, [&] { return now; }, 9);
  link.subscribe(wire::channel("feeder", wire::Lane::reply), 64);
  const Table table = test::sine_table(20'000, Interpolation::quintic_hermite);
  Sender sender(test::plan_of(table), 1);
  for (int i = 0; i < 5000 && !sender.ended(); ++i, now += 1ms) {
    for (const auto& message : sender.poll(now)) send_message(link, message);
    executor.turn();
    Rejects rejects;
    while (const auto message = next_message(link, Nanos{}, rejects)) sender.receive(*message, now);
    if (sender.at_goal()) sender.release();
  }
  EXPECT_TRUE(sender.outcome().started) << sender.outcome().reason;
  EXPECT_TRUE(executor.pump.receiver().store().find(content_hash(table, test::move_units)));
}

TEST(UdpTransport, NamesAnInterfaceThatIsNotThere) {
  MulticastAddress address = place();
  address.ttl = 1;
  address.interface = "jounce-none0";
  try {
    UdpTransport link(address);
    FAIL() << "it must not be usable";
  } catch (const TransportError& error) {
    EXPECT_NE(std::string(error.what()).find("no network interface jounce-none0"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace jounce::udp_transport_test
