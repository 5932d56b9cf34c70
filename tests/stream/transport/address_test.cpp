// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/address.hpp"

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/transport/open_transport.hpp"

namespace jounce::address_test {
namespace {

using namespace std::chrono_literals;

TEST(Address, StaysOnThisMachineUnlessATtlIsGiven) {
  const MulticastAddress address = multicast_address("udpm://239.255.76.67:7667");
  EXPECT_EQ(address.group, "239.255.76.67");
  EXPECT_EQ(address.port, 7667);
  EXPECT_TRUE(address.is_local());
  EXPECT_TRUE(is_local("udpm://239.255.76.67:7667?ttl=0"));
  EXPECT_TRUE(is_local("memq://"));
  EXPECT_TRUE(is_local("unix:///run/jounce"));
  EXPECT_FALSE(is_local("udpm://239.255.76.67:7667?ttl=1"));
}

TEST(Address, HasAPortATtlAnInterfaceAndABuffer) {
  const MulticastAddress address =
      multicast_address("udpm://239.1.2.3:7700?recv_buf_size=4194304&ttl=2&interface=eth1");
  EXPECT_EQ(address.group, "239.1.2.3");
  EXPECT_EQ(address.port, 7700);
  EXPECT_EQ(address.ttl, 2);
  EXPECT_EQ(address.interface, "eth1");
  EXPECT_EQ(address.receive_buffer, 4194304);
  EXPECT_EQ(multicast_address("udpm://239.1.2.3").port, 7667);
}

TEST(Address, IsRejectedWithItsRule) {
  for (const char* const url :
       {"", "tcpq://", "udpm://", "udpm://:7667", "udpm://127.0.0.1:7667", "udpm://10.0.0.1:7667",
        "udpm://239.255.76.67:0", "udpm://239.255.76.67:65536", "udpm://239.255.76.67:x",
        "udpm://239.255.76.67:7667?ttl",
        "udpm://239.255.76.67:7667?ttl=", "udpm://239.1.1.1?ttl=256",
        "udpm://239.255.76.67:7667?ttl=-1", "udpm://239.255.76.67:7667?ttl=1x",
        "udpm://239.255.76.67:7667?tll=1", "udpm://239.255.76.67:7667?interface=eth1",
        "udpm://239.255.76.67:7667?ttl=1&interface=", "udpm://239.1.1.1?ttl=0&interface=eth1"}) {
    EXPECT_THROW(open_transport(url), InputError) << url;
    EXPECT_THROW(static_cast<void>(is_local(url)), InputError) << url;
  }
}

TEST(Address, OfMemoryReachesItselfAlone) {
  const auto one = open_transport("memq://");
  const auto other = open_transport("memq://");
  const std::byte byte{1};
  one->subscribe("a", 1);
  other->subscribe("a", 1);
  one->send("a", {&byte, 1});
  EXPECT_TRUE(one->receive(0ns));
  EXPECT_FALSE(other->receive(1ms));
}

}  // namespace
}  // namespace jounce::address_test
