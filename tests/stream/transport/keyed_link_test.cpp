// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/transport/keyed_link.hpp"

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::keyed_link_test {
namespace {

TEST(KeyedLink, IsUnprotectedIfItLeavesTheMachineWithoutAKey) {
  const std::string network = "udpm://239.255.76.67:7667?ttl=1";
  EXPECT_TRUE(is_unprotected({.url = network}));
  EXPECT_FALSE(is_unprotected({.url = network, .key = "line.key"}));
  EXPECT_FALSE(is_unprotected({}));
}

TEST(KeyedLink, ReadsItsKeyAndLosesPackets) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("keyed_" + std::to_string(getpid()) + ".key");
  write_new_key(file);
  KeyedLink link({.url = "memq://", .key = file.string(), .lost = 1});
  EXPECT_EQ(link.key(), read_key(file));
  link.transport().subscribe("a", 4);
  link.transport().send("a", {});
  EXPECT_FALSE(link.transport().receive(Nanos{})) << "all packets are lost";
  std::filesystem::remove(file);

  KeyedLink open({.url = "memq://"});
  EXPECT_FALSE(open.key());
  open.transport().subscribe("a", 4);
  open.transport().send("a", {});
  EXPECT_TRUE(open.transport().receive(Nanos{}));
}

TEST(KeyedLink, NamesTheOptionOfAnError) {
  EXPECT_EQ(test::key_of([] { KeyedLink({.url = "memq://", .key = "/none"}); }), "key");
  EXPECT_EQ(test::key_of([] { KeyedLink({.url = "tcp://x"}); }), "url");
}

}  // namespace
}  // namespace jounce::keyed_link_test
