// SPDX-License-Identifier: Apache-2.0
// Single commands of a group: lines, arcs and waits that arrive one after another while it moves. The
// judge (judged_plotter.hpp) has the limits of the axes and the requested lines and arcs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/path/direct.hpp"

#include "executor/group/judged_plotter.hpp"
#include "executor/src/group/group_queue.hpp"
#include "support/random.hpp"

namespace jounce::group_commands_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using namespace std::chrono_literals;
using ::testing::AnyOf;
using ::testing::HasSubstr;

TEST(GroupCommands, ALineMovesBothAxesAndRestsAtItsEnd) {
  Judged site;
  const CallOutcome outcome = site.line(30, 40, {.along = {.velocity = 100}});
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  site.advance(200ms);
  EXPECT_NEAR(std::hypot(site.last(x).velocity, site.last(y).velocity), 100, 1e-9);
  site.advance(1s);
  EXPECT_EQ(site.last(x).position, 30);
  EXPECT_EQ(site.last(y).position, 40);
  EXPECT_EQ(site.last(group).finished, 1U);
  EXPECT_EQ(site.last(group).state, State::standstill);
}

TEST(GroupCommands, TheAnswerNamesAVelocityThatTheLimitsLower) {
  Judged site;  // 200 u/s for each axis
  const CallOutcome outcome = site.line(30, 40, {.along = {.velocity = 500}});
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_THAT(outcome.reason, HasSubstr("lower the velocity from 500 "));
  EXPECT_THAT(outcome.reason, HasSubstr(" to 250 ")) << "200 of 4 parts in 5";
  site.advance(2s);
  EXPECT_EQ(site.line(0, 0, {.along = {.velocity = 250}}).reason, "");
  site.advance(2s);
  EXPECT_THAT(site.order("plotter", command::GroupWait{-1}).reason,
              HasSubstr("VALUE = -1 s: must be from 0 s to 1e6 s"));
}

/// A line of many corners.
std::vector<std::array<double, 2>> zigzag(int points) {
  std::vector<std::array<double, 2>> all;
  for (int k = 1; k <= points; ++k)
    all.push_back({10.0 * k, (k % 2 == 0 ? 4.0 : 0.0) + 3.0 * (k % 5)});
  return all;
}

/// The plan of the same commands as one program.
Plan whole(const std::vector<std::array<double, 2>>& points, double wait, double velocity,
           double deviation) {
  Program program(2);
  program.dwell(wait);
  program.set({.velocity = velocity, .corner = Corner::deviation, .value = deviation});
  for (const auto& [px, py] : points) program.line({px, py});
  return plan(program, {.axes = std::vector<Limits>(2, limits(200, 2000, 1e5))});
}

TEST(GroupCommands, ALongEnoughQueuePlaysThePlanOfTheWholeProgram) {
  const auto points = zigzag(120);
  Judged site;
  ASSERT_TRUE(site.order("plotter", command::GroupWait{0.1}).ok());
  const Plan expected = whole(points, 0.1, 150, 0.2);
  std::array<Motion, 2> motion;
  double worst = 0;
  std::int64_t start = -1;
  std::int64_t end = -1;
  const auto judge = site.each_tick;
  site.each_tick = [&] {
    judge();
    if (site.last(group).job == 0) return;
    end = site.last(group).tick;
    if (start < 0) start = end;
    expected.at(std::min(static_cast<double>(end - start) * 1e-3, expected.duration()), motion);
    worst = std::max({worst, std::abs(site.last(x).position - motion[0].position),
                      std::abs(site.last(y).position - motion[1].position)});
  };
  // 20 commands are sent ahead; then one for each that has ended.
  const std::size_t ahead = 20;
  std::size_t sent = 0;
  for (int i = 0; i < 20000 && (sent < points.size() || site.last(group).job != 0); ++i) {
    const wire::Status status = site.dispatcher.server(group).status();
    EXPECT_EQ(status.queue_capacity, GroupQueue::most_commands);
    if (sent < points.size() && status.queue_rows < ahead) {
      const auto& [px, py] = points[sent++];
      const CallOutcome outcome = site.line(px, py, blending(150, 0.2));
      ASSERT_TRUE(outcome.ok()) << sent << ": " << outcome.reason;
    } else {
      site.turn();
    }
  }
  EXPECT_EQ(site.last(group).finished, 1U) << "one motion without a rest";
  EXPECT_NEAR(static_cast<double>(end - start) * 1e-3, expected.duration(), 2e-3);
  EXPECT_LT(worst, 1e-9);
}

TEST(GroupCommands, ACommandThatArrivesBeforeTheGroupBrakesIsJoinedWithoutARest) {
  Judged site;
  ASSERT_TRUE(site.line(6, 0, blending(200)).ok());
  // The group speeds up for 65 ms, to a peak that a longer path would exceed.
  site.advance(30ms);
  ASSERT_TRUE(site.line(40, 0, blending(200)).ok());
  site.advance(1s);
  EXPECT_EQ(site.last(x).position, 40);
  EXPECT_EQ(site.last(group).finished, 1U);
}

TEST(GroupCommands, AnEndlessMotionHasABoundedProgram) {
  Judged site;
  Client client(site.link, "plotter", {}, site.clock);  // a session for all: it sends faster
  ASSERT_TRUE(client.command(command::GroupWait{2}).ok());
  constexpr double radius = 40;
  constexpr int count = 3 * static_cast<int>(GroupQueue::most_commands);
  const std::size_t ahead = 80;  // the group brakes only between rounded corners: on 50 mm
  for (int sent = 0; sent < count;) {
    if (site.dispatcher.server(group).status().queue_rows >= ahead) {
      site.advance(5ms);
      continue;
    }
    const auto [x0, y0] = site.from();
    const double angle = 2.0 / radius * ++sent;
    const double px = radius * std::sin(angle);
    const double py = radius - radius * std::cos(angle);
    site.requested.lines.push_back({x0, y0, px, py});
    site.requested.tolerance = 0.02;
    const CallOutcome outcome =
        client.command(command::MoveLinearAbsolute{at(px, py), blending(100, 0.02)});
    ASSERT_TRUE(outcome.ok()) << sent << ": " << outcome.reason;
    site.accept({px, py});
  }
  ASSERT_TRUE(client.release().ok());  // a silent session would stop the group
  site.advance(3s);
  EXPECT_EQ(site.last(group).finished, 1U) << "without a rest";
  EXPECT_NEAR(site.last(group).position, 2.0 * count, 1) << "the length of the whole path";
}

TEST(GroupCommands, ADrainedQueueComesToRestOnThePath) {
  Judged site;
  int rests = 0;
  const auto judge = site.each_tick;
  bool rested = true;
  site.each_tick = [&] {
    judge();
    const bool now = site.last(group).job == 0;
    rests += now && !rested ? 1 : 0;
    rested = now;
  };
  for (const auto& [px, py] : zigzag(12)) {
    const CallOutcome outcome = site.line(px, py, blending(150, 0.2));
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
    site.advance(Nanos(static_cast<std::int64_t>(1e6 * px * 3)));  // later and later
  }
  site.advance(1s);
  EXPECT_GT(rests, 3);
  EXPECT_EQ(site.last(x).position, 120);
  EXPECT_EQ(site.last(group).fault, Cause::none);
}

TEST(GroupCommands, AFullQueueRejectsWithItsLimit) {
  Judged site;
  ASSERT_TRUE(site.line(1, 0, {.along = {.velocity = 0.1}}).ok());
  ASSERT_TRUE(site.order("plotter", command::Hold{}).ok());
  std::string reason;
  std::size_t accepted = 1;
  for (int k = 2; k < 600 && reason.empty(); ++k) {
    const CallOutcome outcome =
        site.line(k, k % 2, {.along = {.velocity = 50}, .buffer = PathBuffer::buffered});
    if (outcome.ok())
      ++accepted;
    else
      reason = outcome.reason;
  }
  EXPECT_EQ(accepted, GroupQueue::most_commands);
  EXPECT_THAT(reason, HasSubstr("512 commands wait (limit 512)"));
}

TEST(GroupCommands, AbortingRestsOnThePathAndBeginsThere) {
  Judged site;
  ASSERT_TRUE(site.line(100, 0, {.along = {.velocity = 100}}).ok());
  ASSERT_TRUE(
      site.line(100, 50, {.along = {.velocity = 100}, .buffer = PathBuffer::buffered}).ok());
  site.advance(400ms);
  // It begins at the rest: any start on the first line.
  for (double px = 0; px <= 100; px += 0.001) site.requested.lines.push_back({px, 0, 10, 30});
  const CallOutcome outcome = site.order("plotter", command::MoveLinearAbsolute{.to = at(10, 30)});
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  site.requested.tolerance = 1e-3;
  site.advance(2s);
  EXPECT_EQ(site.last(x).position, 10);
  EXPECT_EQ(site.last(y).position, 30) << "the second line was dropped";
  EXPECT_EQ(site.last(group).stopped, 1U);
}

TEST(GroupCommands, ArcsRelativeAndDirectMoves) {
  Judged site;
  site.requested.circles = {{50, 0, 50}, {100, 20, 20}};
  command::MoveCircularAbsolute half{.to = at(100, 0), .path = {.along = {.velocity = 80}}};
  half.center = {50, 0};
  half.clockwise = true;
  ASSERT_TRUE(site.order("plotter", half).ok());
  command::MoveCircularRelative quarter{.to = at(20, 20), .path = {.buffer = PathBuffer::buffered}};
  quarter.radius = 20;
  const CallOutcome second = site.order("plotter", quarter);
  ASSERT_TRUE(second.ok()) << second.reason;
  site.requested.lines.push_back({120, 20, 120, 60});
  const CallOutcome third = site.order(
      "plotter",
      command::MoveDirectRelative{.to = at(0, 40), .path = {.buffer = PathBuffer::buffered}});
  ASSERT_TRUE(third.ok()) << third.reason;
  site.advance(5s);
  EXPECT_NEAR(site.last(x).position, 120, 1e-12);
  EXPECT_NEAR(site.last(y).position, 60, 1e-12);
}

TEST(GroupCommands, AFrameMovesTheFollowingCommands) {
  Judged site;
  command::SetCoordinateTransform frame{.rotation = 90};
  frame.offset = at(100, 20);
  ASSERT_TRUE(site.order("plotter", frame).ok());
  EXPECT_EQ(site.last(group).state, State::standstill) << "nothing moves";
  // (10, 0) of the part is (100, 30) of the machine, and (10, -40) is (140, 30).
  site.requested.lines = {{0, 0, 100, 30}, {100, 30, 140, 30}, {140, 30, 140, 50}};
  ASSERT_TRUE(site.order("plotter", command::MoveLinearAbsolute{.to = at(10, 0)}).ok());
  const command::PathDynamics buffered{.buffer = PathBuffer::buffered};
  ASSERT_TRUE(
      site.order("plotter", command::MoveLinearAbsolute{at(as_configured, -40), buffered}).ok());
  ASSERT_TRUE(
      site.order("plotter", command::MoveLinearRelative{at(20, as_configured), buffered}).ok());
  site.advance(5s);
  EXPECT_NEAR(site.last(x).position, 140, 1e-9);
  EXPECT_NEAR(site.last(y).position, 50, 1e-9);
  EXPECT_THAT(site.order("plotter", command::MoveLinearAbsolute{.to = at(30, -40)}).reason,
              HasSubstr("has no length"))
      << "the group is there";
  // An arc about (30, -50) of the part, (150, 50) of the machine, and a jog along x of the part.
  site.requested.lines = {{150, 40, 150, 60}};
  site.requested.circles = {{150, 50, 10}};
  command::MoveCircularAbsolute quarter{.to = at(20, -50)};
  quarter.center = {30, -50};
  const CallOutcome outcome = site.order("plotter", quarter);
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  site.advance(3s);
  EXPECT_NEAR(site.last(x).position, 150, 1e-9);
  EXPECT_NEAR(site.last(y).position, 40, 1e-9);
  ASSERT_TRUE(
      site.order("plotter", command::GroupJog{.along = at(1, 0), .dynamics = {.velocity = 20}})
          .ok());
  site.advance(500ms);
  ASSERT_TRUE(site.order("plotter", command::Halt{}).ok());
  site.advance(1s);
  EXPECT_NEAR(site.last(x).position, 150, 1e-9);
  EXPECT_GT(site.last(y).position, 45);
  // Without values, the coordinates are those of the machine again; and after a disable.
  site.requested.circles.clear();
  site.requested.lines = {{150, 40, 150, 60}, {150, site.last(y).position, 120, 30}};
  ASSERT_TRUE(site.order("plotter", command::SetCoordinateTransform{}).ok());
  ASSERT_TRUE(site.order("plotter", command::MoveLinearAbsolute{.to = at(120, 30)}).ok());
  site.advance(3s);
  EXPECT_NEAR(site.last(x).position, 120, 1e-9);
  ASSERT_TRUE(site.order("plotter", frame).ok());
  ASSERT_TRUE(site.order("plotter", command::Disable{}).ok());
  site.advance(10ms);
  EXPECT_THAT(site.order("plotter", frame).reason, HasSubstr("the group is disabled"));
  ASSERT_TRUE(site.order("plotter", command::Enable{}).ok());
  site.requested.lines = {{120, 30, 100, 0}};
  ASSERT_TRUE(site.order("plotter", command::MoveLinearAbsolute{.to = at(100, 0)}).ok());
  site.advance(3s);
  EXPECT_NEAR(site.last(y).position, 0, 1e-9);
}

TEST(GroupCommands, AFrameIsChecked) {
  Judged site;
  const auto reason = [&](const command::SetCoordinateTransform& frame) {
    const CallOutcome outcome = site.order("plotter", frame);
    EXPECT_FALSE(outcome.ok());
    return outcome.reason;
  };
  command::SetCoordinateTransform third;
  third.offset[2] = 5;
  EXPECT_THAT(reason(third), HasSubstr("the command has 3 coordinates, but the group has 2 axes"));
  command::SetCoordinateTransform turned{.rotation = 30};
  turned.zyz = {1, 2, 3};
  EXPECT_THAT(reason(turned), HasSubstr("--zyz: cannot be combined with --rotation"));
  turned.rotation = as_configured;
  EXPECT_THAT(reason(turned), HasSubstr("--zyz: needs a group with three path axes"));
}

/// The axis x needs 100 / 200 s at its velocity, and y is there long before.
TEST(GroupCommands, AFastMoveTakesTheShortestTimeOfEachAxis) {
  Judged site;
  site.requested.lines = {{0, 0, 100, 10}};
  site.requested.tolerance = 1e9;  // its path is not a line
  ASSERT_TRUE(
      site.order("plotter", command::MoveDirectAbsolute{.to = at(100, 10), .fast = true}).ok());
  std::int64_t begun = -1, y_there = -1, x_there = -1;
  for (int k = 0; k < 3000 && x_there < 0; ++k) {
    site.advance(1ms);
    const std::int64_t tick = site.last(group).tick;
    if (begun < 0 && site.last(group).state == State::discrete_motion)
      begun = tick - std::lround(site.last(group).path_time * 1000);
    if (y_there < 0 && std::abs(site.last(y).position - 10) < 1e-9) y_there = tick;
    if (std::abs(site.last(x).position - 100) < 1e-9) x_there = tick;
  }
  ASSERT_GE(begun, 0);
  const Limits axis = limits(200, 2000, 1e5);
  const auto time = [&](double distance) { return direct({}, {distance}, {axis})[0].end() * 1000; };
  EXPECT_NEAR(static_cast<double>(x_there - begun), time(100), 2);
  EXPECT_NEAR(static_cast<double>(y_there - begun), time(10), 2);
  EXPECT_LT(y_there + 100, x_there);
  site.advance(100ms);
  EXPECT_EQ(site.last(group).state, State::standstill);
  // A buffered fast move begins at rest, and a line after it too.
  const command::PathDynamics buffered{.buffer = PathBuffer::buffered};
  ASSERT_TRUE(site.order("plotter", command::MoveDirectAbsolute{at(0, 0), {}, true}).ok());
  ASSERT_TRUE(site.order("plotter", command::MoveLinearAbsolute{at(10, 0), buffered}).ok());
  site.advance(3s);
  EXPECT_NEAR(site.last(x).position, 10, 1e-12);
  EXPECT_THAT(
      site.order("plotter", command::MoveDirectAbsolute{at(5, 5), blending(50), true}).reason,
      HasSubstr("--fast: begins and ends at rest: leave out --blend"));
}

// The target of an absolute command is checked before the group stops for it.
TEST(GroupCommands, AnAbortingCommandWithAnInvalidTargetKeepsThePresentMotion) {
  Limits axis = limits(200, 2000, 1e5);
  axis.position_min = -500;
  axis.position_max = 500;
  Judged site(false, axis);
  ASSERT_TRUE(site.line(100, 0, {.along = {.velocity = 100}}).ok());
  ASSERT_TRUE(
      site.line(100, 20, {.along = {.velocity = 100}, .buffer = PathBuffer::buffered}).ok());
  site.advance(400ms);
  command::MoveCircularAbsolute arc{.to = at(600, 0)};
  arc.radius = 400;
  command::MoveLinearAbsolute third{.to = at(1, 1)};
  third.to[2] = 5;
  for (const ClientCommand& wrong :
       {ClientCommand(command::MoveLinearAbsolute{.to = at(600, 0)}), ClientCommand(arc),
        ClientCommand(command::MoveLinearAbsolute{.to = at(as_configured, -501)}),
        ClientCommand(third), ClientCommand(command::MoveDirectAbsolute{at(0, 501), {}, true})}) {
    const CallOutcome outcome = site.order("plotter", wrong);
    EXPECT_FALSE(outcome.ok());
    EXPECT_THAT(outcome.reason, AnyOf(HasSubstr("must be at "), HasSubstr("2 axes")));
  }
  EXPECT_NEAR(site.last(x).velocity, 100, 1e-9) << "it did not brake";
  site.advance(3s);
  EXPECT_EQ(site.last(x).position, 100);
  EXPECT_EQ(site.last(y).position, 20) << "the buffered line was kept";
  EXPECT_EQ(site.last(group).stopped, 0U);
}

TEST(GroupCommands, InvalidCommandsAreRejectedAndNothingMoves) {
  Limits axis = limits(200, 2000, 1e5);
  axis.position_min = -500;
  axis.position_max = 500;
  Judged site(false, axis);
  const auto reason = [&](const ClientCommand& command) {
    const CallOutcome outcome = site.order("plotter", command);
    EXPECT_FALSE(outcome.ok());
    return outcome.reason;
  };
  EXPECT_THAT(reason(command::MoveLinearAbsolute{}),
              HasSubstr("the command has no coordinate: give at least one"));
  EXPECT_THAT(
      reason(command::MoveLinearAbsolute{.to = at(0, 0)}),
      HasSubstr("the move has no length: the path already ends at (0, 0): give another position"));
  EXPECT_THAT(reason(command::MoveLinearAbsolute{.to = at(1e9, 0)}),
              HasSubstr("x = 1000000000: must be at most position_max, 500"));
  command::MoveLinearAbsolute third{.to = at(1, 1)};
  third.to[2] = 5;
  EXPECT_THAT(reason(third), HasSubstr("3 coordinates, but the group has 2 axes"));
  EXPECT_THAT(reason(command::MoveLinearAbsolute{at(5, 5), {.deviation = 0.1}}),
              HasSubstr("needs a buffer mode that blends"));
  EXPECT_THAT(reason(command::MoveCircularAbsolute{.to = at(10, 0)}),
              HasSubstr("an arc needs exactly one of --via, --center and --radius"));
  command::MoveCircularAbsolute far{.to = at(10, 0)};
  far.radius = 2;
  EXPECT_THAT(reason(far), HasSubstr("radius"));
  EXPECT_THAT(reason(command::GearIn{.numerator = 1, .denominator = 2}), HasSubstr("single_axis"));
  EXPECT_THAT(reason(command::GroupWait{-1}), HasSubstr("VALUE = -1 s: must be"));
  EXPECT_THAT(reason(command::GroupWait{1e9}), HasSubstr("must be from 0 s to 1e6 s"));
  command::MoveCircularRelative turns{.to = at(0, 10)};
  turns.radius = 5;
  turns.turns = command::most_extra_turns + 1;
  EXPECT_THAT(reason(turns), HasSubstr("--turns = 1001: must be at most 1000"));
  EXPECT_THROW(
      static_cast<void>(site.order("plotter", command::MoveLinearAbsolute{.to = at(INFINITY, 0)})),
      InputError);
  EXPECT_THROW(static_cast<void>(site.order(
                   "plotter", command::MoveLinearAbsolute{at(1, 0), {.along = {.velocity = -5}}})),
               InputError);
  EXPECT_THAT(site.order("x", command::MoveLinearAbsolute{.to = at(1, 0)}).reason,
              HasSubstr("not_a_group"));
  EXPECT_EQ(site.moving, 0);

  ASSERT_TRUE(site.order("plotter", command::Disable{}).ok());
  EXPECT_THAT(reason(command::MoveLinearAbsolute{.to = at(1, 0)}),
              HasSubstr("the group is disabled"));
}

TEST(GroupCommands, FollowAPathThatWasSentAsAWhole) {
  Judged site;
  site.each_tick = {};
  ASSERT_TRUE(site.order("plotter", command::StartTable{}).ok());
  site.advance(100ms);
  const auto reason = [&](const ClientCommand& command) {
    return site.order("plotter", command).reason;
  };
  EXPECT_THAT(reason(command::GroupWait{1}), HasSubstr("a wait needs a motion before it"));
  EXPECT_THAT(reason(command::MoveDirectAbsolute{at(5, 5), {.buffer = PathBuffer::buffered}, true}),
              HasSubstr("a fast move begins at rest"));
  const command::PathDynamics buffered{.buffer = PathBuffer::buffered};
  ASSERT_EQ(reason(command::MoveLinearAbsolute{at(100, 10), buffered}), "");
  ASSERT_EQ(reason(command::MoveLinearRelative{at(0, 20), blending(50)}), "");
  EXPECT_THAT(reason(command::MoveLinearAbsolute{at(100, 30), buffered}),
              HasSubstr("has no length"));
  EXPECT_EQ(site.last(group).finished, 0U) << "the program is still played";
  for (int k = 0; k < 100 && site.last(group).finished < 1; ++k) site.advance(100ms);
  EXPECT_EQ(site.last(group).finished, 1U);
  site.requested.lines = {{site.last(x).position, site.last(y).position, 100, 10},
                          {100, 10, 100, 30}};
  site.before = {site.last(x), site.last(y), site.last(group)};
  site.each_tick = [&] { site.judge(); };
  site.advance(3s);
  EXPECT_EQ(site.last(x).position, 100);
  EXPECT_EQ(site.last(y).position, 30);
  EXPECT_EQ(site.last(group).finished, 2U);
  EXPECT_EQ(site.last(group).state, State::standstill);
}

TEST(GroupCommands, AHaltDropsTheCommandsThatFollow) {
  Judged site;
  site.each_tick = {};
  ASSERT_TRUE(site.order("plotter", command::StartTable{}).ok());
  site.advance(100ms);
  const command::PathDynamics buffered{.buffer = PathBuffer::buffered};
  ASSERT_TRUE(site.order("plotter", command::MoveLinearAbsolute{at(100, 10), buffered}).ok());
  ASSERT_TRUE(site.order("plotter", command::Halt{}).ok());
  site.advance(2s);
  EXPECT_EQ(site.last(group).state, State::standstill);
  EXPECT_EQ(site.last(group).finished, 0U);
  EXPECT_NE(site.last(x).position, 100);
}

TEST(GroupCommands, AHeldGroupTakesCommandsAndContinues) {
  Judged site;
  ASSERT_TRUE(site.line(50, 0, blending(100)).ok());
  site.advance(200ms);
  ASSERT_TRUE(site.order("plotter", command::Hold{}).ok());
  site.advance(500ms);
  ASSERT_TRUE(site.line(50, 50, blending(100)).ok());
  ASSERT_TRUE(site.line(0, 50, blending(100)).ok());
  ASSERT_TRUE(site.order("plotter", command::Resume{}).ok());
  site.advance(3s);
  EXPECT_EQ(site.last(x).position, 0);
  EXPECT_EQ(site.last(y).position, 50);
  EXPECT_EQ(site.last(group).finished, 1U) << "one motion";
}

TEST(GroupCommands, DisablingAHeldGroupEndsItsMotion) {
  Judged site;
  ASSERT_TRUE(site.line(50, 0, blending(100)).ok());
  site.advance(200ms);
  ASSERT_TRUE(site.order("plotter", command::Hold{}).ok());
  site.advance(500ms);
  ASSERT_TRUE(site.order("plotter", command::Disable{}).ok());
  EXPECT_EQ(site.last(group).finished, 0U);
  EXPECT_EQ(site.last(group).stopped, 1U);
}

TEST(GroupCommands, ARecordIsReplayedToTheLastBit) {
  Judged site(true);
  for (const auto& [px, py] : zigzag(60)) {
    ASSERT_TRUE(site.line(px, py, blending(150, 0.2)).ok());
    site.advance(30ms);
  }
  ASSERT_TRUE(site.order("plotter", command::Override{0.4}).ok());
  site.advance(1s);
  ASSERT_TRUE(site.order("plotter", command::Halt{}).ok());
  site.advance(1s);
  const Replay replay = site.replayed();
  EXPECT_TRUE(replay.same()) << replay.shorter
                             << (replay.difference ? replay.difference->what.field : "");
  EXPECT_GT(replay.compared, 3000);
}

TEST(GroupCommands, AJogEndsOnItsLineWhenItIsReleasedOrSilent) {
  for (const bool silent : {false, true}) {
    Judged site;
    site.requested.lines.push_back({0, 0, 1000, 500});
    command::GroupJog jog{.dynamics = {.velocity = 50}, .hold_to_run = true};
    jog.along[0] = 2;
    jog.along[1] = 1;
    Client client(site.link, "plotter", {}, site.clock);
    const CallOutcome outcome = client.command(jog);
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
    for (int i = 0; i < 20; ++i) {
      site.advance(50ms);
      ASSERT_TRUE(client.beat().ok());
    }
    EXPECT_NEAR(std::hypot(site.last(x).velocity, site.last(y).velocity), 50, 1e-9);
    if (!silent) static_cast<void>(client.release());
    if (!silent) {  // the next command waits for the rest
      jog.along[0] = -2;
      jog.along[1] = -1;
      jog.hold_to_run = false;
      EXPECT_TRUE(site.order("plotter", jog).ok());
      site.advance(100ms);
      EXPECT_LT(site.last(x).velocity, 0);
      EXPECT_TRUE(site.order("plotter", command::Halt{}).ok());
      continue;
    }
    site.advance(1s);
    EXPECT_EQ(site.last(group).state, State::standstill);
    EXPECT_EQ(site.last(group).reason, Cause::released);
    EXPECT_GT(site.last(x).position, 40);
    EXPECT_LT(site.last(x).position, 100);
  }
}

TEST(GroupCommands, AJogRestsAtTheEndOfTheRangeAndReverses) {
  Limits axis = limits(200, 2000, 1e5);
  axis.position_min = -150;
  axis.position_max = 150;
  Judged site(false, axis);
  site.requested.lines.push_back({-150, 0, 150, 0});
  command::GroupJog jog{.dynamics = {.velocity = 100}};
  EXPECT_THAT(site.order("plotter", jog).reason,
              HasSubstr("the direction of the jog has no length"));
  jog.along[0] = 1;
  ASSERT_TRUE(site.order("plotter", jog).ok());
  site.advance(500ms);
  jog.along[0] = -1;
  const CallOutcome back = site.order("plotter", jog);
  ASSERT_TRUE(back.ok()) << back.reason;
  site.advance(5s);
  EXPECT_EQ(site.last(x).position, -150);
  EXPECT_EQ(site.last(group).fault, Cause::none);
  EXPECT_THAT(site.order("plotter", jog).reason,
              HasSubstr("the jog leads outward: x stands at the end of its range, -150"));
}

/// Limits of the path or of an axis; each of them may be omitted.
command::GroupSetLimits random_limits(Random& random) {
  const auto some = [&](double low, double high) {
    return random.below(3) == 0 ? as_configured : random.log_uniform(low, high);
  };
  return {.dynamics = {.velocity = some(5, 200),
                       .acceleration = some(100, 4000),
                       .jerk = some(2000, 2e5)},
          .axis = random.below(3),
          .queued = random.below(2) == 0};
}

/// One random command; the judge learns the path if it is accepted.
void stir(Judged& site, Random& random, int& accepted) {
  const auto random_buffer = [&] {
    return random.below(12) == 0 ? PathBuffer::aborting
                                 : static_cast<PathBuffer>(1 + random.below(6));
  };
  command::PathDynamics path{.along = {.velocity = random.uniform(5, 250)},
                             .buffer = random_buffer()};
  if (path.buffer >= PathBuffer::blending_low && random.below(2) == 0)
    (random.below(2) == 0 ? path.deviation : path.corner_distance) = random.uniform(0.01, 1);
  switch (random.below(17)) {
    case 14:
      static_cast<void>(
          site.order("plotter", command::GroupSetOverride{.velocity = random.uniform(0.2, 2),
                                                          .acceleration = random.uniform(0.05, 1),
                                                          .jerk = random.uniform(0.02, 1)}));
      return;
    case 15:
      static_cast<void>(site.order("plotter", random_limits(random)));
      return;
    case 16:
      static_cast<void>(site.order("plotter", command::GroupSetOverride{}));
      static_cast<void>(site.order("plotter", command::GroupSetLimits{.axis = random.below(3)}));
      return;
    case 0:
      static_cast<void>(site.order("plotter", command::Hold{}));
      site.advance(100ms);
      static_cast<void>(site.order("plotter", command::Resume{}));
      return;
    case 1:
      static_cast<void>(site.order("plotter", command::Override{random.uniform(0.1, 2)}));
      return;
    case 2:
      static_cast<void>(site.order("plotter", command::Override{1}));
      return;
    case 3:
      static_cast<void>(site.order("plotter", command::GroupWait{random.uniform(0, 0.05)}));
      return;
    case 4:
      if (random.below(3) != 0) return;
      static_cast<void>(site.order("plotter", command::Halt{}));
      site.advance(1s);  // so that the start of the next command is known
      return;
    default:
      break;
  }
  if (path.buffer == PathBuffer::aborting) {
    static_cast<void>(site.order("plotter", command::Halt{}));
    site.advance(1s);
  }
  const auto [x0, y0] = site.from();
  const double px = x0 + random.uniform(-15, 15);
  const double py = y0 + random.uniform(-15, 15);
  site.requested.tolerance = 1;
  if (random.below(3) != 0) {
    accepted += site.line(px, py, path).ok() ? 1 : 0;
    return;
  }
  command::MoveCircularAbsolute arc{.to = at(px, py), .path = path};
  const double cx = x0 + random.uniform(-20, 20);
  const double cy = y0 + random.uniform(-20, 20);
  arc.via = {cx, cy, as_configured};
  try {
    const Arc expected = arc_through({x0, y0}, {cx, cy}, {px, py}, 2);
    site.requested.circles.push_back({expected.center[0], expected.center[1], expected.radius});
  } catch (const InputError&) {
    return;
  }
  const CallOutcome outcome = site.order("plotter", arc);
  if (outcome.ok()) site.accept({px, py});
  accepted += outcome.ok() ? 1 : 0;
}

TEST(GroupCommands, RandomCommandsAtRandomTicksKeepThePathAndTheLimits) {
  const char* const seeds = std::getenv("JOUNCE_GROUP_SEEDS");
  const auto last_seed = seeds != nullptr ? std::strtoull(seeds, nullptr, 10) : 4;
  std::uint64_t accepted_of_all = 0;
  for (std::uint64_t seed = 1; seed <= last_seed; ++seed) {
    SCOPED_TRACE(seed);
    Judged site;
    Random random(seed);
    int accepted = 0;
    for (int k = 0; k < 150 && !testing::Test::HasFatalFailure(); ++k) {
      stir(site, random, accepted);
      // Often at once, sometimes while the group brakes or rests.
      site.advance(Nanos(random.below(3) == 0 ? random.below(400) * 1'000'000
                                              : random.below(20) * 1'000'000));
    }
    site.advance(5s);
    EXPECT_GT(accepted, 40) << seed;
    accepted_of_all += static_cast<std::uint64_t>(accepted);
    EXPECT_GT(site.moving, 5000) << seed;
    EXPECT_EQ(site.last(group).fault, Cause::none) << seed;
  }
  EXPECT_GT(accepted_of_all, 60 * last_seed);
}

}  // namespace
}  // namespace jounce::group_commands_test
