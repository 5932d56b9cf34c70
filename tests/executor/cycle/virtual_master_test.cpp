// SPDX-License-Identifier: Apache-2.0
// A virtual master: an axis with a table of its own, which an order starts, and a follower in step with it.
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/receiver/static_queue.hpp"
#include "jounce/stream/sender/client.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"

namespace jounce::virtual_master_test {
namespace {

using namespace test;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

std::vector<ExecutorOptions> line_and_knife() {
  std::vector<ExecutorOptions> axes{axis_named("line", limits(1000, 10000), {"", "mm"}),
                                    axis_named("knife", limits(2000, 50000), {"mm", "mm"})};
  axes[0].table = StoredTable{{1}, {"s", "mm"}, trapezoid_table(500, 400, 1000, 1000)};
  axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
  return axes;
}

/// A line with a table of its own, and a knife behind it.
struct Line : Site {
  Line() : Site(line_and_knife()) {}
  CallOutcome order(const char* axis, CommandKind kind) {
    Client client(link, axis, {}, clock);
    const CallOutcome outcome = client.command(command_of(kind));
    static_cast<void>(client.release());
    return outcome;
  }
};

TEST(VirtualMaster, IsStartedByAnOrderHeldAndFollowed) {
  Line site;
  Client knife(site.link, "knife", {}, site.clock);
  ASSERT_TRUE(knife.command(command::GearIn{.numerator = 1, .denominator = 2}).ok());
  ASSERT_TRUE(knife.release().ok());
  const CallOutcome start = site.order("line", CommandKind::start_table);
  ASSERT_TRUE(start.ok()) << start.reason;
  site.advance(500ms);
  EXPECT_NEAR(site.last(0).velocity, 400, 1e-9);
  ASSERT_TRUE(site.order("line", CommandKind::hold).ok());
  site.advance(1s);
  EXPECT_EQ(site.last(0).velocity, 0);
  EXPECT_EQ(site.last(1).velocity, 0) << "the follower rests with it";
  ASSERT_TRUE(site.order("line", CommandKind::resume).ok());
  site.advance(3s);
  EXPECT_EQ(site.last(0).finished, 1U);
  EXPECT_EQ(site.last(0).position, 500);
  EXPECT_NEAR(site.last(1).position, 250, 1e-9);
  EXPECT_EQ(site.last(1).fault, Cause::none);
}

TEST(VirtualMaster, StartsOnlyWhereItsTableBegins) {
  Line site;
  ASSERT_TRUE(site.order("line", CommandKind::start_table).ok());
  site.advance(100ms);
  EXPECT_THAT(site.order("line", CommandKind::start_table).reason, HasSubstr("in_motion"));
  site.advance(3s);
  EXPECT_THAT(site.order("line", CommandKind::start_table).reason, HasSubstr("start_position"));
  Client line(site.link, "line", {}, site.clock);
  ASSERT_TRUE(line.command(command::SetPosition{.position = 0}).ok());
  ASSERT_TRUE(line.release().ok());
  EXPECT_TRUE(site.order("line", CommandKind::start_table).ok());
  site.advance(3s);
  EXPECT_EQ(site.last(0).finished, 2U);
}

// It is not what its owner had armed before that begins in its place.
TEST(VirtualMaster, OneThatIsRejectedStartsNothingElse) {
  Line site;
  Client line(site.link, "line", {}, site.clock);
  StaticQueue rows(line, {.units = {"s", "mm"}, .mode = wire::QueueMode::static_});
  ASSERT_TRUE(rows.open().ok());
  ASSERT_TRUE(
      rows.fill(0, {{.x_end = 1, .p_end = 5, .order = wire::RowOrder::cubic, .last = true}}).ok());
  ASSERT_TRUE(rows.arm().ok());
  ASSERT_TRUE(line.command(command::SetPosition{.position = 7}).ok());
  EXPECT_THAT(line.command(command::StartTable{}).reason, HasSubstr("start_position"));
  site.advance(500ms);
  EXPECT_EQ(site.last(0).state, State::standstill);
  EXPECT_EQ(site.last(0).position, 7);
}

TEST(VirtualMaster, AnAxisWithoutATableIsReported) {
  Line site;
  EXPECT_THAT(site.order("knife", CommandKind::start_table).reason,
              HasSubstr("no table and no cutter to start"));
}

}  // namespace
}  // namespace jounce::virtual_master_test
