// SPDX-License-Identifier: Apache-2.0
#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/sender/operate.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"

// Reports of a client about a motion that was cut short.

namespace jounce::session_end_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

struct Owned : Site {
  Owned() : Site({axis_named("feeder", limits(1000, 1e4, 1e6), {"s", "mm"})}) {
    EXPECT_TRUE(client.enable().ok());
    EXPECT_TRUE(move().ok());
  }
  CallOutcome move() {
    return client.command(command::MoveAbsolute{.position = 190, .dynamics = {.velocity = 40}});
  }
  RestOutcome rest() { return await_rest(link, "feeder", client, {}, clock); }
  Client client{link, "feeder", {}, clock};
};

TEST(SessionEnd, ThatStopsAMotionIsReportedWithThePlace) {
  Owned site;
  site.advance(2500ms);
  const RestOutcome rest = site.rest();
  EXPECT_EQ(rest.error, StreamError::stopped);
  EXPECT_THAT(rest.reason, testing::StartsWith("no heartbeat of this program arrived in time"));
  EXPECT_LT(rest.position, 45) << "one second at 40 mm/s";
  EXPECT_EQ(rest.position, site.last().position);
  EXPECT_TRUE(site.move().ok()) << "reported already";
  EXPECT_TRUE(site.rest().ok());
  EXPECT_EQ(site.last().position, 190);
}

TEST(SessionEnd, ThatStopsAMotionHasToBeReportedBeforeTheNextOne) {
  Owned site;
  site.advance(2500ms);
  EXPECT_EQ(site.move().error, StreamError::stopped);
  site.advance(100ms);
  EXPECT_EQ(site.last().velocity, 0) << "it does not move on";
  EXPECT_TRUE(site.move().ok());
}

TEST(SessionEnd, AtRestIsNotReported) {
  Owned site;
  ASSERT_TRUE(site.rest().ok());
  site.advance(5s);
  EXPECT_TRUE(site.move().ok());
  EXPECT_TRUE(site.rest().ok());
}

TEST(SessionEnd, ByAStopOfAnOperatorIsReportedWithThePlace) {
  Owned site;
  site.advance(400ms);
  ASSERT_TRUE(operator_stop(site.link, "feeder", wire::StopMode::stop, 1s, {}, site.clock));
  const RestOutcome rest = site.rest();
  EXPECT_EQ(rest.error, StreamError::stopped);
  EXPECT_THAT(rest.reason,
              testing::StartsWith("another operator stopped the axis; the axis rests"));
  EXPECT_TRUE(site.move().ok()) << "reported already";
}

TEST(SessionEnd, AFaultIsReportedWithThePlace) {
  Owned site;
  site.advance(400ms);
  ASSERT_TRUE(site.client.disable().ok());
  const RestOutcome rest = site.rest();
  EXPECT_EQ(rest.error, StreamError::stopped);
  EXPECT_THAT(rest.reason, testing::HasSubstr(": disabled_in_motion: "));
  EXPECT_EQ(rest.position, site.last().position);
}

}  // namespace
}  // namespace jounce::session_end_test
