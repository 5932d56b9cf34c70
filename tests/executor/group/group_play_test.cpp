// SPDX-License-Identifier: Apache-2.0
// A group from the client's commands to the setpoints of its axes, its record, and its cycle.
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/axis/detail/group_path.hpp"
#include "jounce/executor/detail/cycle.hpp"
#include "jounce/executor/detail/recorder.hpp"
#include "jounce/stream/sender/client.hpp"

#include "axis/group/group_rig.hpp"
#include "executor/group/plotter_site.hpp"
#include "executor/hooks.hpp"

namespace jounce::group_play_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

void expect_on_path(const Site& site) {
  const auto [px, py] = contour_at(site.last(group).position);
  ASSERT_NEAR(site.last(x).position, px, 1e-12);
  ASSERT_NEAR(site.last(y).position, py, 1e-12);
}

TEST(GroupPlay, IsStartedHeldAndContinuedByCommands) {
  PlotterSite site;
  site.advance(10ms);
  EXPECT_THAT(site.order("plotter", command::StartTable{}).reason,
              HasSubstr("the group is disabled"));
  ASSERT_TRUE(site.order("plotter", command::Enable{}).ok());
  site.each_tick = [&] { expect_on_path(site); };
  const CallOutcome start = site.order("plotter", command::StartTable{});
  ASSERT_TRUE(start.ok()) << start.reason;
  EXPECT_THAT(site.order("x", command::MoveAbsolute{.position = 5}).reason, HasSubstr("in_group"));
  ASSERT_TRUE(site.order("plotter", command::Override{0.5}).ok());
  site.advance(500ms);
  EXPECT_THAT(site.order("plotter", command::StartTable{}).reason, HasSubstr("in_motion"));
  ASSERT_TRUE(site.order("plotter", command::Hold{}).ok());
  site.advance(500ms);
  EXPECT_EQ(site.last(x).velocity, 0);
  EXPECT_EQ(site.last(x).state, State::standstill);
  ASSERT_TRUE(site.order("plotter", command::Resume{}).ok());
  ASSERT_TRUE(site.order("plotter", command::Override{1}).ok());
  site.advance(6s);
  EXPECT_EQ(site.last(group).finished, 1U);
  EXPECT_EQ(site.last(group).state, State::standstill);
  const CallOutcome again = site.order("plotter", command::StartTable{});
  EXPECT_TRUE(again.ok()) << "it ends where it begins: " << again.reason;
  site.advance(300ms);
  EXPECT_GT(site.last(group).position, 1);
}

TEST(GroupPlay, AStartElsewhereIsRejectedWithTheNumbers) {
  PlotterSite site;
  site.advance(10ms);
  ASSERT_TRUE(site.order("x", command::SetPosition{2.5}).ok());
  ASSERT_TRUE(site.order("plotter", command::Enable{}).ok());
  EXPECT_THAT(site.order("plotter", command::StartTable{}).reason,
              HasSubstr("x is at 2.5 mm instead of 0 mm"));
  EXPECT_EQ(site.last(group).state, State::standstill);
}

TEST(GroupPlay, AStopByAnOperatorAndTheEndOfTheExecutorStayOnThePath) {
  for (const bool leaves : {false, true}) {
    PlotterSite site;
    site.advance(10ms);
    ASSERT_TRUE(site.order("plotter", command::Enable{}).ok());
    ASSERT_TRUE(site.order("plotter", command::StartTable{}).ok());
    site.advance(700ms);
    site.each_tick = [&] { expect_on_path(site); };
    if (leaves)
      site.dispatcher.retire();
    else
      ASSERT_TRUE(Client(site.link, "y", {}, site.clock).stop().ok());
    site.advance(1s);
    EXPECT_TRUE(site.dispatcher.settled());
    EXPECT_EQ(site.last(group).stopped, 1U);
    for (const std::size_t i : {x, y}) EXPECT_EQ(site.last(i).fault, Cause::none);
  }
}

TEST(GroupPlay, ARecordIsReplayedToTheLastBit) {
  PlotterSite site(true);
  site.advance(10ms);
  ASSERT_TRUE(site.order("plotter", command::Enable{}).ok());
  ASSERT_TRUE(site.order("plotter", command::StartTable{}).ok());
  site.advance(700ms);
  ASSERT_TRUE(site.order("plotter", command::Hold{}).ok());
  site.advance(300ms);
  ASSERT_TRUE(site.order("plotter", command::Resume{}).ok());
  ASSERT_TRUE(site.order("plotter", command::Override{0.4}).ok());
  site.advance(500ms);
  ASSERT_TRUE(site.order("y", command::Disable{}).ok());
  site.advance(500ms);
  EXPECT_EQ(site.last(group).fault, Cause::axis_fault);
  const Replay replay = site.replayed();
  EXPECT_TRUE(replay.same()) << replay.shorter
                             << (replay.difference ? replay.difference->what.field : "");
  EXPECT_GT(replay.compared, 3000);
}

TEST(GroupPlay, ItsCycleNeitherAllocatesNorLocksNorWrites) {
  Plotter rig;
  VirtualPacer pacer;
  MachineExchange exchange(3);
  const auto buffer = std::make_unique<RecordBuffer>();
  Cycle cycle(rig.machine, pacer, exchange, {.drives = {}, .record = buffer.get()});
  Noise noise{};
  Tick last;
  const auto order = [&](std::size_t axis, Command command, int cycles) {
    command.id = 1;
    exchange.axes[axis]->commands.push(command);
    for (int i = 0; i < cycles; ++i) {
      const Noise before = test::noise();
      cycle.once();
      const Noise now = test::noise() - before;
      noise = {noise.heap + now.heap, noise.locks + now.locks, noise.writes + now.writes};
      for (auto& each : exchange.axes) {
        while (each->ticks.pop(last)) continue;
        for (Answer answer; each->answers.pop(answer);) continue;
      }
    }
  };
  for (const std::size_t i : {x, y, group}) order(i, {command::Enable{}}, 1);
  order(group, {command::Arm{&rig.path}}, 1);
  order(group, {command::Start{}}, 500);
  GroupPath same(8, rig.program);
  order(group, {command::Extend{&same, 0, 0, rig.plan->duration()}}, 100);
  order(group, {command::Override{0.5}}, 300);
  order(group, {command::Hold{}}, 300);
  order(group, {command::Resume{}}, 300);
  order(y, {command::Abort{}}, 500);
  EXPECT_EQ(last.fault, Cause::axis_fault);
  EXPECT_EQ(noise, Noise{});
}

}  // namespace
}  // namespace jounce::group_play_test
