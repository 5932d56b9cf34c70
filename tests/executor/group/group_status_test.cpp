// SPDX-License-Identifier: Apache-2.0
// The place of a group on its path, and what remains of it, in its status messages.
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/stream/sender/operate.hpp"

#include "executor/group/plotter_site.hpp"

namespace jounce::group_status_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

struct GroupShown : ::testing::Test {
  void SetUp() override {
    site.advance(10ms);
    ASSERT_TRUE(site.order("plotter", command::Enable{}).ok());
  }
  [[nodiscard]] wire::GroupStatus status() {
    const auto next = present_group(site.link, "plotter", 200ms, {}, site.clock);
    EXPECT_TRUE(next);
    return next.value_or(wire::GroupStatus{});
  }
  PlotterSite site;
};

TEST_F(GroupShown, AGroupAtRestHasNoPath) {
  const wire::GroupStatus rests = status();
  EXPECT_EQ(rests.axes, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(rests.place, (std::vector<double>{0, 0}));
  EXPECT_EQ(rests.units.size(), rests.axes.size());
  EXPECT_TRUE(std::isnan(rests.length) && std::isnan(rests.remaining_s) &&
              std::isnan(rests.look_ahead));
  EXPECT_EQ(rests.line, 0);
  EXPECT_EQ(rests.commands, 0U);
  EXPECT_FALSE(present_group(site.link, "x", 200ms, {}, site.clock)) << "a single axis";
}

/// Each status names the tick in which the motion ends.
TEST_F(GroupShown, TheRemainingTimeIsExactAtTheOriginalSpeed) {
  std::int64_t end = -1;  // the tick in which the motion has ended
  site.each_tick = [&] {
    const Tick& group = site.last(Plotter::group);
    if (end < 0 && group.finished == 1) end = group.tick;
  };
  ASSERT_TRUE(site.order("plotter", command::StartTable{}).ok());
  std::vector<wire::GroupStatus> seen;
  while (site.last(Plotter::group).finished == 0 && seen.size() < 1000) seen.push_back(status());
  ASSERT_GE(end, 0);
  int exact = 0;
  double length = 0;
  for (const wire::GroupStatus& one : seen) {
    if (std::isnan(one.length)) continue;
    EXPECT_FALSE(one.estimated);
    EXPECT_NEAR(one.length, length == 0 ? one.length : length, 1e-9);
    length = one.length;
    EXPECT_LE(one.position, one.length + 1e-9);
    ++exact;
    const double ends = static_cast<double>(one.tick) + one.remaining_s * 1000;
    EXPECT_LE(ends, static_cast<double>(end) + 1e-6);
    EXPECT_GE(ends, static_cast<double>(end) - 2) << "to the cycle";
    const wire::GroupStatus& first = seen.front();
    EXPECT_NEAR(ends, static_cast<double>(first.tick) + first.remaining_s * 1000, 1e-6)
        << "all of them name the same instant";
  }
  EXPECT_GT(exact, 10) << "statuses during the motion";
  EXPECT_NEAR(length, site.last(Plotter::group).position, 1e-9);
}

TEST_F(GroupShown, WithAnOverrideItIsAnEstimateAndInAHoldUnknown) {
  ASSERT_TRUE(site.order("plotter", command::StartTable{}).ok());
  site.advance(500ms);
  const wire::GroupStatus full = status();
  ASSERT_TRUE(site.order("plotter", command::Override{0.5}).ok());
  site.advance(500ms);
  const wire::GroupStatus half = status();
  EXPECT_TRUE(half.estimated);
  EXPECT_GT(half.remaining_s, 1.4 * full.remaining_s);
  EXPECT_LT(half.remaining_s, 2 * full.remaining_s);
  ASSERT_TRUE(site.order("plotter", command::Hold{}).ok());
  site.advance(500ms);
  const wire::GroupStatus held = status();
  EXPECT_TRUE(held.estimated);
  site.advance(500ms);
  EXPECT_EQ(status().remaining_s, held.remaining_s) << "a hold does not count";
  EXPECT_LT(held.remaining_s, half.remaining_s);
  EXPECT_GT(held.remaining_s, half.remaining_s - 1);
  EXPECT_EQ(held.feed, 0);
  EXPECT_NEAR(held.length, full.length, 1e-9);
  EXPECT_LT(held.position, held.length);
}

TEST_F(GroupShown, SingleCommandsAreCountedAndExtendThePath) {
  const auto line = [&](double px, double py) {
    command::MoveLinearAbsolute to{
        .path = {.along = {.velocity = 50}, .buffer = PathBuffer::look_ahead}};
    to.to[0] = px;
    to.to[1] = py;
    const CallOutcome outcome = site.order("plotter", to);
    EXPECT_TRUE(outcome.ok()) << outcome.reason;
  };
  line(100, 0);
  const wire::GroupStatus one = status();
  EXPECT_EQ(one.line, 1);
  EXPECT_EQ(one.commands, 1U);
  EXPECT_NEAR(one.length, 100, 1e-9);
  line(200, 0);
  line(200, 50);
  const wire::GroupStatus all = status();
  EXPECT_EQ(all.commands, 3U);
  EXPECT_NEAR(all.length, 250, 1e-9);
  EXPECT_GT(all.look_ahead, one.look_ahead + 100);
  EXPECT_LT(all.look_ahead, all.length - all.position) << "the stop at the end is not in it";
  EXPECT_NEAR(all.feed, 50, 1e-9);
  EXPECT_NEAR(all.place[0], all.position, 1e-9);
  site.advance(10s);
  EXPECT_EQ(status().commands, 0U);
  command::SetCoordinateTransform frame;
  frame.offset[0] = 150;
  ASSERT_TRUE(site.order("plotter", frame).ok());
  const wire::GroupStatus framed = status();
  EXPECT_TRUE(framed.framed);
  EXPECT_NEAR(framed.place[0], 50, 1e-9) << "x = 200 of the machine";
}

}  // namespace
}  // namespace jounce::group_status_test
