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

/// A motion that uses a limit has no reserve: the answer states the highest factor.
TEST(GroupOverride, TheAnswerNamesTheHighestFactorOfTheMotion) {
  Measured site;
  ASSERT_TRUE(site.line(150, 0, {.along = {.velocity = 200}}).ok());
  site.advance(100ms);
  EXPECT_EQ(site.order("plotter", command::Override{1.5}).reason,
            "the limits permit at most 100 % of the speed of the present motion");
  EXPECT_EQ(site.order("plotter", command::GroupSetOverride{.velocity = 1.5}).reason,
            "the limits permit at most 100 % of the speed of the present motion");
  EXPECT_EQ(site.order("plotter", command::Override{0.8}).reason, "");
  site.finish();
  EXPECT_EQ(site.order("plotter", command::Override{1.5}).reason, "") << "nothing moves";
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
  EXPECT_EQ(site.order("plotter", command::Override{2}).reason, "");
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
  EXPECT_THROW(static_cast<void>(site.order("plotter", command::GroupSetOverride{.velocity = 2.5})),
               InputError);
  EXPECT_THROW(
      static_cast<void>(site.order("plotter", command::GroupSetOverride{.acceleration = 0})),
      InputError);
  EXPECT_THROW(static_cast<void>(site.order("plotter", command::GroupSetOverride{.jerk = 1.5})),
               InputError);
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

/// The greatest magnitudes of the axis x on each of some intervals of x.
struct SeenBetween {
  SeenBetween(Measured& site, std::vector<double> ends) : ends(std::move(ends)) {
    seen.resize(this->ends.size() - 1);
    site.each_tick = [this, &site, judge = site.each_tick] {
      const Tick before = site.before[x];
      judge();
      const Tick& now = site.last(x);
      if (now.tick != before.tick + 1) return;
      for (std::size_t k = 0; k + 1 < this->ends.size(); ++k) {
        // A tick that crosses an end counts for neither side.
        if (!(before.position >= this->ends[k] && now.position <= this->ends[k + 1])) continue;
        Seen& here = seen[k];
        here.velocity = std::max({here.velocity, before.velocity, now.velocity});
        here.acceleration = std::max(
            {here.acceleration, std::abs(before.acceleration), std::abs(now.acceleration)});
        here.jerk = std::max(here.jerk, std::abs(now.acceleration - before.acceleration) * 1000);
      }
    };
  }
  std::vector<double> ends;
  std::vector<Seen> seen;
};

/// The group slows down before the place where lower limits of an axis begin, and speeds up after the
/// place where higher ones begin. It rests nowhere.
TEST(GroupLimits, OfAnAxisThatAreQueuedTakeEffectAtTheirPlace) {
  Measured site;
  const SeenBetween parts(site, {0, 60, 80, 140});
  ASSERT_TRUE(site.line(60, 0, {.along = {.velocity = 150}}).ok());
  site.accepts(command::GroupSetLimits{
      .dynamics = {.velocity = 20, .acceleration = 500, .jerk = 2e4}, .axis = 1, .queued = true});
  ASSERT_TRUE(site.line(80, 0, blending(150)).ok());
  site.accepts(command::GroupSetLimits{.axis = 1, .queued = true});
  ASSERT_TRUE(site.line(140, 0, blending(150)).ok());
  site.finish();
  EXPECT_EQ(site.last(x).position, 140);
  EXPECT_EQ(site.last(group).finished, 1U) << "one motion";
  EXPECT_NEAR(parts.seen[0].velocity, 150, 1e-9);
  EXPECT_NEAR(parts.seen[1].velocity, 20, 1e-9);
  EXPECT_LE(parts.seen[1].acceleration, 500 * (1 + 1e-9));
  EXPECT_LE(parts.seen[1].jerk, 2e4 * (1 + 1e-9) + 1e-6);
  EXPECT_NEAR(parts.seen[2].velocity, 150, 1e-9);
  EXPECT_GT(parts.seen[2].acceleration, 1500);
}

/// Limits that were set at rest end where queued higher ones begin.
TEST(GroupLimits, OfAnAxisBecomeHigherDuringTheMotion) {
  for (const std::int32_t axis : {0, 1}) {
    Measured site;
    const SeenBetween parts(site, {0, 30, 90});
    site.accepts(command::GroupSetLimits{.dynamics = {.velocity = 30}, .axis = axis});
    ASSERT_TRUE(site.line(30, 0, {.along = {.velocity = 150}}).ok());
    site.accepts(
        command::GroupSetLimits{.dynamics = {.velocity = 120}, .axis = axis, .queued = true});
    ASSERT_TRUE(site.line(90, 0, blending(150)).ok());
    site.finish();
    EXPECT_EQ(site.last(group).finished, 1U) << axis;
    EXPECT_NEAR(parts.seen[0].velocity, 30, 1e-9) << axis;
    EXPECT_NEAR(parts.seen[1].velocity, 120, 1e-9) << axis;
  }
}

/// If limits change during the motion, an override above 1 raises no speed, and a lower share of the
/// acceleration applies to all of them.
TEST(GroupLimits, OfAnAxisThatAreQueuedHoldWithAnOverride) {
  Measured site;
  const SeenBetween parts(site, {0, 60, 100});
  ASSERT_TRUE(site.line(60, 0, {.along = {.velocity = 50, .acceleration = 300, .jerk = 1e4}}).ok());
  site.accepts(command::GroupSetLimits{
      .dynamics = {.velocity = 20, .acceleration = 200}, .axis = 1, .queued = true});
  ASSERT_TRUE(site.line(100, 0, blending(50)).ok());
  site.accepts(command::Override{2});
  site.advance(800ms);
  EXPECT_NEAR(site.last(x).velocity, 50, 1e-9);
  site.accepts(command::GroupSetOverride{.acceleration = 0.25});
  site.finish();
  EXPECT_EQ(site.last(group).finished, 1U);
  EXPECT_NEAR(parts.seen[0].velocity, 50, 1e-9);
  EXPECT_NEAR(parts.seen[1].velocity, 10, 1e-6);
  EXPECT_LE(parts.seen[1].acceleration, 50 * (1 + 1e-9));
}

/// After an M word, the limits of the commands that wait there count, not those that are queued later.
TEST(GroupLimits, OfAnAxisThatAreQueuedBelongToTheirStage) {
  Measured site;
  const SeenBetween parts(site, {20, 50, 80});
  ASSERT_TRUE(site.line(20, 0, {.along = {.velocity = 100}}).ok());
  site.accepts(command::GroupMWord{.number = 6});
  ASSERT_TRUE(site.line(50, 0, buffered(100)).ok());
  site.accepts(command::GroupSetLimits{.dynamics = {.velocity = 10}, .axis = 1, .queued = true});
  ASSERT_TRUE(site.line(80, 0, blending(100)).ok());
  site.advance(1s);
  site.accepts(command::GroupAcknowledge{});
  site.finish();
  EXPECT_EQ(site.last(x).position, 80);
  EXPECT_NEAR(parts.seen[0].velocity, 100, 1e-9);
  EXPECT_NEAR(parts.seen[1].velocity, 10, 1e-9);
}

/// Limits of an axis that apply at once lower the speed of the present motion; the next command begins
/// at rest, with its full speed.
TEST(GroupLimits, OfAnAxisThatApplyAtOnceLetTheNextCommandBeginAtRest) {
  Measured site;
  ASSERT_TRUE(site.line(130, 0, {.along = {.velocity = 150}}).ok());
  site.advance(250ms);
  site.accepts(command::GroupSetLimits{.dynamics = {.velocity = 20}, .axis = 1});
  ASSERT_TRUE(site.line(150, 0, blending(150)).ok());
  site.advance(300ms);
  EXPECT_NEAR(site.last(x).velocity, 20, 1e-6);
  site.finish();
  EXPECT_EQ(site.last(x).position, 150);
  EXPECT_EQ(site.last(group).finished, 2U);
}

/// A line with the limits of both axes, and the command that sets them; axis 0: none.
struct LimitedLine {
  double x = 0, y = 0, velocity = 0;
  std::array<AxisRates, 2> rates{};
  std::int32_t set = 0;  ///< the axis whose limits change before the line
};

std::vector<LimitedLine> random_lines(std::uint64_t seed) {
  Random random(seed);
  std::vector<LimitedLine> lines;
  LimitedLine line;
  for (int k = 0; k < 40; ++k) {
    line.set = k > 0 ? random.below(3) : 0;
    if (line.set > 0)
      line.rates[static_cast<std::size_t>(line.set) - 1] = {
          random.log_uniform(10, 150), random.log_uniform(200, 2000), random.log_uniform(5e3, 1e5)};
    line.x += random.uniform(1, 3);
    line.y += random.uniform(-3, 3);
    line.velocity = random.uniform(40, 180);
    lines.push_back(line);
  }
  return lines;
}

/// The limits of an axis at this place. Around the corners, which replace less than 1 mm, those of both
/// lines.
AxisRates limits_at(const std::vector<LimitedLine>& lines, double px, std::size_t axis) {
  AxisRates most{0, 0, 0};
  double from = -10;
  for (const LimitedLine& line : lines) {
    const AxisRates& rates = line.rates[axis];
    if (px >= from - 1 && px <= line.x + 1)
      most = {std::max(most.velocity, std::min(rates.velocity, 200.0)),
              std::max(most.acceleration, std::min(rates.acceleration, 2000.0)),
              std::max(most.jerk, std::min(rates.jerk, 1e5))};
    from = line.x;
  }
  return most;
}

/// Random lines with queued limits of both axes, behind a wait. The motion equals the offline plan of the
/// same program, and each axis is within the limits of its line in every tick.
TEST(GroupLimits, OfAxesThatAreQueuedEqualTheOfflinePlan) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const std::vector<LimitedLine> lines = random_lines(seed);
    Program program(2);
    program.dwell(1);
    for (const LimitedLine& line : lines) {
      program.set({.velocity = line.velocity,
                   .corner = Corner::deviation,
                   .value = 0.05,
                   .axes = {line.rates.begin(), line.rates.end()}});
      program.line({line.x, line.y});
    }
    const Plan offline = plan(program, {.axes = std::vector<Limits>(2, limits(200, 2000, 1e5))});
    Judged site;
    double apart = 0;
    double nearest = 1e9;  // to a limit of the velocity
    std::size_t beyond = 0;
    std::int64_t start = -1;
    site.each_tick = [&, judge = site.each_tick] {
      judge();
      const Tick& all = site.last(group);
      if (all.job == 0) return;
      if (start < 0) start = all.tick;
      std::array<Motion, 2> planned;
      offline.at(std::min(static_cast<double>(all.tick - start) * 1e-3, offline.duration()),
                 planned);
      for (const std::size_t i : {x, Plotter::y}) {
        const Tick& now = site.last(i);
        apart = std::max(apart, std::abs(now.position - planned[i].position));
        const AxisRates most = limits_at(lines, site.last(x).position, i);
        nearest = std::min(nearest, most.velocity - std::abs(now.velocity));
        beyond += std::abs(now.velocity) > most.velocity * (1 + 1e-9) ||
                  std::abs(now.acceleration) > most.acceleration * (1 + 1e-9);
      }
    };
    ASSERT_TRUE(site.order("plotter", command::GroupWait{1}).ok());
    for (const LimitedLine& line : lines) {
      if (line.set > 0) {
        const auto& [velocity, acceleration, jerk] =
            line.rates[static_cast<std::size_t>(line.set) - 1];
        ASSERT_TRUE(
            site.order("plotter", command::GroupSetLimits{.dynamics = {.velocity = velocity,
                                                                       .acceleration = acceleration,
                                                                       .jerk = jerk},
                                                          .axis = line.set,
                                                          .queued = true})
                .ok());
      }
      ASSERT_TRUE(site.line(line.x, line.y, blending(line.velocity, 0.05)).ok());
    }
    for (int k = 0; k < 400 && (k < 2 || site.last(group).job != 0); ++k) site.advance(50ms);
    EXPECT_NEAR(site.last(x).position, lines.back().x, 1e-12) << seed;
    EXPECT_EQ(site.last(group).finished, 1U) << seed;
    EXPECT_LE(apart, 1e-9) << seed;
    EXPECT_EQ(beyond, 0U) << seed;
    EXPECT_LT(nearest, 1e-6) << seed << ": a limit is reached";
  }
}

TEST(GroupLimits, AboveThoseOfTheAxisAreAcceptedWithTheLimitsThatRemain) {
  Measured site;
  const CallOutcome high = site.order(
      "plotter",
      command::GroupSetLimits{.dynamics = {.velocity = 900, .acceleration = 50}, .axis = 1});
  EXPECT_TRUE(high.ok());
  EXPECT_THAT(high.reason, HasSubstr("the lower limits of x remain: velocity 200"));
  EXPECT_EQ(high.reason.find("acceleration"), std::string::npos);
  EXPECT_EQ(site.order("plotter", command::GroupSetLimits{.dynamics = {.velocity = 150}, .axis = 1})
                .reason,
            "");
}

TEST(GroupLimits, AreChecked) {
  Measured site;
  EXPECT_THAT(site.refused(command::GroupSetLimits{.dynamics = {.velocity = 5}, .axis = 3}),
              HasSubstr("--axis = 3: must be 1 (x) or 2 (y)"));
  EXPECT_THAT(site.refused(command::GroupSetLimits{.dynamics = {.deceleration = 5}, .axis = 1}),
              HasSubstr("--deceleration = 5: applies along the path only"));
  EXPECT_THROW(static_cast<void>(
                   site.order("plotter", command::GroupSetLimits{.dynamics = {.velocity = -1}})),
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
