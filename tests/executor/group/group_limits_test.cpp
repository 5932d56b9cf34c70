// SPDX-License-Identifier: Apache-2.0
// The override of a group, its further limits, its shifted coordinates, and the end of its jogs. The
// limits of the plotter are 200 mm/s, 2000 mm/s^2 and 1e5 mm/s^3 for each axis.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "executor/group/judged_plotter.hpp"
#include "support/random.hpp"

namespace jounce::group_limits_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

/// The greatest magnitudes of the axis x since the last reset.
struct Seen {
  double velocity = 0, acceleration = 0, jerk = 0;
};

/// A judged plotter that remembers the greatest magnitudes of its axis x.
struct Measured : Judged {
  explicit Measured(bool recorded = false, const Limits& axis = limits(200, 2000, 1e5))
      : Judged(recorded, axis) {
    each_tick = [this] {
      const Tick last_x = before[x];
      judge();
      const Tick& now = last(x);
      if (now.tick != last_x.tick + 1) return;
      seen.velocity = std::max(seen.velocity, std::abs(now.velocity));
      seen.acceleration = std::max(seen.acceleration, std::abs(now.acceleration));
      seen.jerk = std::max(seen.jerk, std::abs(now.acceleration - last_x.acceleration) * 1000);
    };
  }
  void accepts(const ClientCommand& command) {
    const CallOutcome outcome = order("plotter", command);
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
  }
  std::string refused(const ClientCommand& command) {
    const CallOutcome outcome = order("plotter", command);
    EXPECT_FALSE(outcome.ok());
    return outcome.reason;
  }
  /// Until the group rests.
  void finish() {
    for (int k = 0; k < 400 && (k < 2 || last(group).job != 0); ++k) advance(50ms);
    EXPECT_EQ(last(group).state, State::standstill);
  }
  Seen seen;
};

command::PathDynamics buffered(double velocity) {
  return {.along = {.velocity = velocity}, .buffer = PathBuffer::buffered};
}

// ---- override ----------------------------------------------------------------------------------

TEST(GroupOverride, AccelerationAndJerkAreLowerInTheNextMotion) {
  Measured site;
  site.accepts(command::GroupSetOverride{.acceleration = 0.25, .jerk = 0.1});
  ASSERT_TRUE(site.line(100, 0, {.along = {.velocity = 150}}).ok());
  site.finish();
  EXPECT_NEAR(site.seen.velocity, 150, 1e-9) << "the velocity stays";
  EXPECT_NEAR(site.seen.acceleration, 500, 1);
  EXPECT_LE(site.seen.jerk, 1e4 * (1 + 1e-9) + 1e-6);
  EXPECT_GE(site.seen.jerk, 0.99e4);
}

/// In motion, the rate falls: a share of a quarter of the acceleration halves the velocity.
TEST(GroupOverride, AccelerationInMotionReducesTheSpeed) {
  Measured site;
  ASSERT_TRUE(site.line(150, 0, {.along = {.velocity = 100}}).ok());
  site.advance(400ms);
  EXPECT_NEAR(site.last(x).velocity, 100, 1e-9);
  site.accepts(command::GroupSetOverride{.acceleration = 0.25});
  site.advance(300ms);
  EXPECT_NEAR(site.last(group).override_, 0.5, 1e-9);
  EXPECT_NEAR(site.last(x).velocity, 50, 1e-6);
  site.seen = {};
  site.finish();
  EXPECT_EQ(site.last(x).position, 150);
  EXPECT_LE(site.seen.acceleration, 500 * (1 + 1e-9));
  // The next motion is planned within the lower limits, at full speed.
  ASSERT_TRUE(site.line(0, 0, {.along = {.velocity = 100}}).ok());
  site.seen = {};
  site.finish();
  EXPECT_NEAR(site.seen.velocity, 100, 1e-9);
  EXPECT_LE(site.seen.acceleration, 500 * (1 + 1e-9));
  site.accepts(command::Override{0.5});
  ASSERT_TRUE(site.line(100, 0, {.along = {.velocity = 100}}).ok());
  site.seen = {};
  site.finish();
  EXPECT_NEAR(site.seen.velocity, 50, 1e-9) << "override keeps the other factors";
  EXPECT_LE(site.seen.acceleration, 125 * (1 + 1e-9));
}

TEST(GroupOverride, AboveOneUsesTheReserveOfSingleCommands) {
  Measured site;
  site.accepts(command::Override{2});
  command::PathDynamics path{.along = {.velocity = 60, .acceleration = 400, .jerk = 5000}};
  ASSERT_TRUE(site.line(150, 0, path).ok());
  site.advance(1s);
  EXPECT_NEAR(site.last(x).velocity, 120, 1e-6);
  site.finish();
  EXPECT_LE(site.seen.acceleration, 2000);
  // A move that uses the full acceleration has no reserve.
  site.seen = {};
  ASSERT_TRUE(site.line(0, 0, {.along = {.velocity = 60}}).ok());
  site.finish();
  EXPECT_NEAR(site.seen.velocity, 60, 1e-9);
}

/// The second line uses the full acceleration, so the group returns to the original speed before the
/// longer plan takes over; and a hold in progress stays within its limits.
TEST(GroupOverride, AFasterCommandEndsTheReserve) {
  for (const bool holds : {false, true}) {
    Measured site;
    site.accepts(command::Override{2});
    ASSERT_TRUE(
        site.line(150, 0, {.along = {.velocity = 50, .acceleration = 300, .jerk = 4000}}).ok());
    site.advance(500ms);
    EXPECT_GT(site.last(x).velocity, 80);
    if (holds) site.accepts(command::Hold{});
    ASSERT_TRUE(site.line(150, 100, buffered(200)).ok());
    if (holds) site.accepts(command::Resume{});
    site.finish();
    EXPECT_EQ(site.last(Plotter::y).position, 100) << holds;
    EXPECT_EQ(site.last(group).finished, 1U) << "one motion";
    EXPECT_EQ(site.last(group).fault, Cause::none);
  }
}

TEST(GroupOverride, IsCheckedAndForGroupsOnly) {
  Measured site;
  EXPECT_THROW(site.order("plotter", command::GroupSetOverride{.velocity = 2.5}), InputError);
  EXPECT_THROW(site.order("plotter", command::GroupSetOverride{.acceleration = 0}), InputError);
  EXPECT_THROW(site.order("plotter", command::GroupSetOverride{.jerk = 1.5}), InputError);
  EXPECT_THAT(site.order("x", command::GroupSetOverride{}).reason, HasSubstr("not_a_group"));
}

// ---- further limits ----------------------------------------------------------------------------

TEST(GroupLimits, QueuedLimitsApplyToTheCommandsAfterThem) {
  Measured site;
  ASSERT_TRUE(site.line(100, 0, {.along = {.velocity = 150}}).ok());
  site.accepts(command::GroupSetLimits{.dynamics = {.velocity = 40}, .queued = true});
  ASSERT_TRUE(site.line(100, 20, buffered(150)).ok());
  site.advance(300ms);
  EXPECT_NEAR(site.last(x).velocity, 150, 1e-9) << "the present motion keeps its velocity";
  double fastest = 0;
  const auto judge = site.each_tick;
  site.each_tick = [&] {
    judge();
    fastest = std::max(fastest, std::abs(site.last(Plotter::y).velocity));
  };
  site.finish();
  EXPECT_NEAR(fastest, 40, 1e-9);
  EXPECT_EQ(site.last(group).finished, 1U) << "one motion: limits along the path blend";
  // Until the group is disabled.
  site.accepts(command::Disable{});
  site.accepts(command::Enable{});
  site.seen = {};
  ASSERT_TRUE(site.line(0, 20, {.along = {.velocity = 150}}).ok());
  site.finish();
  EXPECT_NEAR(site.seen.velocity, 150, 1e-9);
}

TEST(GroupLimits, ImmediateLimitsReduceTheSpeedOfThePresentMotion) {
  Measured site;
  ASSERT_TRUE(site.line(150, 0, {.along = {.velocity = 150}}).ok());
  site.advance(300ms);
  site.accepts(command::GroupSetLimits{.dynamics = {.velocity = 30}});
  site.advance(300ms);
  site.seen = {};
  site.advance(100ms);
  EXPECT_NEAR(site.seen.velocity, 30, 1e-6);
  site.accepts(command::GroupSetLimits{});
  site.advance(400ms);
  EXPECT_NEAR(site.last(x).velocity, 150, 1e-6) << "without values, the limits are removed";
  site.finish();
  EXPECT_EQ(site.last(x).position, 150);
}

/// The appended line is planned within the new limit, so it is not slowed down with the line before it.
TEST(GroupLimits, AfterARestOnlyTheCommandsThatRemainCount) {
  Measured site;
  ASSERT_TRUE(site.line(150, 0, {.along = {.velocity = 150}}).ok());
  site.advance(300ms);
  site.accepts(command::GroupSetLimits{.dynamics = {.velocity = 30}});
  ASSERT_TRUE(site.line(150, 40, buffered(150)).ok());
  double fastest = 0;
  const auto judge = site.each_tick;
  site.each_tick = [&] {
    judge();
    fastest = std::max(fastest, std::abs(site.last(Plotter::y).velocity));
  };
  site.finish();
  EXPECT_EQ(site.last(group).finished, 1U) << "one motion";
  EXPECT_EQ(site.last(Plotter::y).position, 40);
  EXPECT_NEAR(fastest, 30, 1e-6);
}

TEST(GroupLimits, OfAnAxisHoldInEveryMotion) {
  Measured site;
  site.accepts(command::GroupSetLimits{
      .dynamics = {.velocity = 25, .acceleration = 300, .jerk = 2e4}, .axis = 1});
  ASSERT_TRUE(site.line(30, 60, {.along = {.velocity = 200}}).ok());
  ASSERT_TRUE(site.line(0, 60, buffered(200)).ok());
  site.finish();
  EXPECT_NEAR(site.seen.velocity, 25, 1e-6);
  EXPECT_LE(site.seen.acceleration, 300 * (1 + 1e-9));
  EXPECT_LE(site.seen.jerk, 2e4 * (1 + 1e-9) + 1e-6);
  // A program that was sent as a whole plays more slowly.
  site.requested.tolerance = 1e9;
  ASSERT_TRUE(site.line(0, 0, {}).ok());
  site.finish();
  site.seen = {};
  site.accepts(command::StartTable{});
  site.finish();
  EXPECT_LE(site.seen.velocity, 25 * (1 + 1e-9));
  EXPECT_GT(site.seen.velocity, 5);
  EXPECT_LE(site.seen.acceleration, 300 * (1 + 1e-9));
}

/// Limits of an axis change the plan of every command, so the commands after them begin at rest.
TEST(GroupLimits, OfAnAxisThatAreQueuedBeginAtRest) {
  Measured site;
  ASSERT_TRUE(site.line(60, 0, {.along = {.velocity = 150}}).ok());
  site.accepts(command::GroupSetLimits{.dynamics = {.velocity = 20}, .axis = 1, .queued = true});
  site.advance(250ms);
  EXPECT_NEAR(site.last(x).velocity, 150, 1e-9);
  ASSERT_TRUE(site.line(80, 0, blending(150)).ok());
  ASSERT_TRUE(site.line(100, 0, blending(150)).ok());
  for (int k = 0; k < 100 && site.last(group).finished < 1; ++k) site.advance(20ms);
  site.seen = {};
  site.finish();
  EXPECT_EQ(site.last(x).position, 100);
  EXPECT_EQ(site.last(group).finished, 2U);
  EXPECT_NEAR(site.seen.velocity, 20, 1e-9);
}

TEST(GroupLimits, AreChecked) {
  Measured site;
  EXPECT_THAT(site.refused(command::GroupSetLimits{.dynamics = {.velocity = 5}, .axis = 3}),
              HasSubstr("axis = 3: must be 1 (x) or 2 (y)"));
  EXPECT_THAT(site.refused(command::GroupSetLimits{.dynamics = {.deceleration = 5}, .axis = 1}),
              HasSubstr("deceleration = 5: applies along the path only"));
  EXPECT_THROW(site.order("plotter", command::GroupSetLimits{.dynamics = {.velocity = -1}}),
               InputError);
  EXPECT_THAT(site.order("x", command::GroupSetLimits{.dynamics = {.velocity = 5}}).reason,
              HasSubstr("not_a_group"));
  site.accepts(command::Disable{});
  EXPECT_EQ(site.refused(command::GroupSetLimits{.dynamics = {.velocity = 5}}),
            "axis: the group is disabled: send `jounce order AXIS enable` for x, y, then `jounce "
            "order plotter enable`");
}

// ---- coordinates -------------------------------------------------------------------------------

TEST(GroupSetPosition, ShiftsTheCoordinatesOfTheCommandsAfterIt) {
  Measured site;
  ASSERT_TRUE(site.line(40, 30, {}).ok());
  site.finish();
  site.accepts(command::GroupSetPosition{.to = at(0, as_configured)});
  EXPECT_EQ(site.last(x).position, 40) << "nothing moves";
  site.requested.lines.push_back({40, 30, 50, 30});
  site.accepts(command::MoveLinearAbsolute{.to = at(10, 30)});
  site.finish();
  EXPECT_NEAR(site.last(x).position, 50, 1e-9);
  EXPECT_NEAR(site.last(Plotter::y).position, 30, 1e-9);
  // Relative: the place is (10, 30), and then (12, 30).
  site.accepts(command::GroupSetPosition{.to = at(2, as_configured), .relative = true});
  site.requested.lines.push_back({50, 30, 48, 30});
  site.accepts(command::MoveLinearAbsolute{.to = at(10, as_configured)});
  site.finish();
  EXPECT_NEAR(site.last(x).position, 48, 1e-9);
  // A frame replaces the shift.
  site.accepts(command::SetCoordinateTransform{});
  site.requested.lines.push_back({48, 30, 45, 30});
  site.accepts(command::MoveLinearAbsolute{.to = at(45, 30)});
  site.finish();
  EXPECT_NEAR(site.last(x).position, 45, 1e-9);
}

/// In motion, the end of the last command gets the coordinates.
TEST(GroupSetPosition, InMotionCountsFromTheEndOfTheLastCommand) {
  Measured site;
  command::SetCoordinateTransform frame{.rotation = 90};
  frame.offset = at(10, 0);
  site.accepts(frame);
  site.requested.lines.push_back({0, 0, 10, 50});
  site.accepts(command::MoveLinearAbsolute{.to = at(50, 0), .path = {.along = {.velocity = 100}}});
  site.advance(100ms);
  site.accepts(command::GroupSetPosition{.to = at(0, 0)});
  site.requested.lines.push_back({10, 50, 10, 70});
  site.accepts(command::MoveLinearAbsolute{at(20, 0), buffered(100)});
  site.finish();
  EXPECT_NEAR(site.last(x).position, 10, 1e-9);
  EXPECT_NEAR(site.last(Plotter::y).position, 70, 1e-9);
  EXPECT_THAT(site.refused(command::GroupSetPosition{}),
              HasSubstr("the command has no coordinate"));
  command::GroupSetPosition third;
  third.to[2] = 1;
  EXPECT_THAT(site.refused(third), HasSubstr("3 coordinates, but the group has 2 axes"));
  EXPECT_THAT(site.order("x", command::GroupSetPosition{.to = at(0, 0)}).reason,
              HasSubstr("not_a_group"));
}

// ---- jog ---------------------------------------------------------------------------------------

TEST(GroupJogEnd, TheStatusNamesTheReason) {
  Limits axis = limits(200, 2000, 1e5);
  axis.position_min = -150;
  axis.position_max = 150;
  Measured site(false, axis);
  site.requested.lines.push_back({-150, 0, 150, 0});
  command::GroupJog jog{.dynamics = {.velocity = 150}};
  jog.along[0] = 1;
  const auto reason = [&] {
    return static_cast<Cause>(site.dispatcher.server(group).status().reason);
  };
  site.accepts(jog);
  EXPECT_EQ(reason(), Cause::none);
  site.finish();
  EXPECT_EQ(site.last(x).position, 150);
  EXPECT_EQ(reason(), Cause::range_end);
  jog.along[0] = -1;
  site.accepts(jog);
  site.advance(200ms);
  EXPECT_EQ(reason(), Cause::none);
  site.accepts(command::Halt{});
  site.finish();
  EXPECT_EQ(reason(), Cause::halted);
}

// ---- all of them -------------------------------------------------------------------------------

TEST(GroupLimits, ARecordIsReplayedToTheLastBit) {
  Measured site(true);
  site.accepts(command::Override{1.5});
  ASSERT_TRUE(
      site.line(60, 0, {.along = {.velocity = 60, .acceleration = 400, .jerk = 5000}}).ok());
  site.advance(300ms);
  site.accepts(command::GroupSetOverride{.velocity = 2, .acceleration = 0.5});
  site.accepts(command::GroupSetLimits{.dynamics = {.velocity = 50}, .axis = 1});
  ASSERT_TRUE(site.line(60, 40, buffered(100)).ok());
  site.finish();
  const Replay replay = site.replayed();
  EXPECT_TRUE(replay.same()) << replay.shorter
                             << (replay.difference ? replay.difference->what.field : "");
  EXPECT_GT(replay.compared, 1000);
}

}  // namespace
}  // namespace jounce::group_limits_test
