// SPDX-License-Identifier: Apache-2.0
// The fields of the status on the wire during a motion.
#include <gtest/gtest.h>

#include "jounce/stream/sender/client.hpp"

#include "axis/bench.hpp"
#include "executor/site.hpp"

namespace jounce::status_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

struct Shown : ::testing::Test {
  void SetUp() override { ASSERT_TRUE(client.enable().ok()); }
  [[nodiscard]] wire::Status status() {
    site.advance(60ms);
    return site.dispatcher.server().status();
  }

  Site site{{axis_named("feeder", limits(1000, 1e4), {"", "mm"})}};
  Client client{site.link, "feeder", {}, site.clock};
};

TEST_F(Shown, AMoveRunsIsHeldAndRunsAgain) {
  EXPECT_EQ(status().progress, wire::Progress::none);
  ASSERT_TRUE(
      client.command(command::MoveAbsolute{.position = 300, .dynamics = {.velocity = 100}}).ok());
  EXPECT_EQ(status().progress, wire::Progress::running);
  EXPECT_FALSE(status().held);
  ASSERT_TRUE(client.hold().ok());
  site.advance(200ms);
  EXPECT_TRUE(status().held);
  EXPECT_EQ(status().slave_velocity, 0);
  EXPECT_EQ(status().progress, wire::Progress::running) << "it has not ended";
  ASSERT_TRUE(client.resume().ok());
  EXPECT_FALSE(status().held);
  ASSERT_TRUE(client.release().ok()) << "an owner that is silent stops its motion";
  site.advance(4s);
  EXPECT_EQ(status().slave_position, 300);
  EXPECT_EQ(status().progress, wire::Progress::none);
}

TEST_F(Shown, AJogRunsUntilItIsStopped) {
  ASSERT_TRUE(client.command(command::MoveVelocity{.velocity = 50}).ok());
  EXPECT_EQ(status().progress, wire::Progress::running);
  ASSERT_TRUE(client.command(command::Halt{}).ok());
  site.advance(200ms);
  EXPECT_EQ(status().progress, wire::Progress::none);
}

TEST_F(Shown, AHeldMotionThatIsStoppedIsHeldNoMore) {
  ASSERT_TRUE(
      client.command(command::MoveAbsolute{.position = 300, .dynamics = {.velocity = 100}}).ok());
  ASSERT_TRUE(client.hold().ok());
  site.advance(200ms);
  ASSERT_TRUE(client.stop().ok());
  site.advance(200ms);
  EXPECT_FALSE(status().held);
  EXPECT_EQ(status().progress, wire::Progress::none);
}

}  // namespace
}  // namespace jounce::status_test
