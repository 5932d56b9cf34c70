// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/position_compare.hpp"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

namespace jounce::position_compare_test {
namespace {

Trajectory trapezoid_to(double from, double to) {
  return trapezoid({.from = from, .to = to, .velocity = 1000, .acceleration = 2000}).curve();
}

/// A motion there and back again.
Trajectory there_and_back(double from, double to) {
  const Trajectory there = trapezoid_to(from, to);
  return concatenated(there, trapezoid_to(to, from));
}

std::vector<double> positions_of(const Compared& all) {
  std::vector<double> positions;
  for (const CompareEvent& event : all.events) positions.push_back(event.position);
  return positions;
}

PositionCompare pulses_at(const std::vector<double>& positions) {
  PositionCompare compare{.pulse = 0.5};
  for (const double p : positions) compare.points.push_back({p});
  return compare;
}

// PMC600 manual 9.3, examples 9.3 to 9.6.

TEST(PositionCompare, HoldsItsOutputOnceTheAxisIsBeyond) {
  const PositionCompare compare{.mode = CompareMode::greater, .points = {{10000}}};
  const Compared all = compared(compare, there_and_back(0, 12000));
  ASSERT_EQ(all.edges.size(), 1U);  // stays on, also on the way back
  EXPECT_TRUE(all.edges[0].on);
  EXPECT_NEAR(all.edges[0].time, 0.25 + 10, 1e-12);  // v^2 / 2a = 250 in 0.5 s, then 9750 at 1000
}

TEST(PositionCompare, IsMetAtTheStart) {
  const PositionCompare below{.mode = CompareMode::less, .points = {{10}}};
  EXPECT_EQ(compared(below, trapezoid_to(0, 100)).edges.at(0).time, 0);
  const PositionCompare later{.mode = CompareMode::less, .points = {{-10}}};
  EXPECT_TRUE(compared(later, trapezoid_to(0, 100)).edges.empty());
}

TEST(PositionCompare, FiresLinearlyFiveTimes) {
  const PositionCompare compare{
      .mode = CompareMode::linear, .points = evenly(2000, 2000, 5), .pulse = 0.5};
  const Compared all = compared(compare, trapezoid_to(0, 12000));
  EXPECT_THAT(positions_of(all), testing::ElementsAre(2000, 4000, 6000, 8000, 10000));
  ASSERT_EQ(all.edges.size(), 10U);
  for (std::size_t i = 0; i < 5; ++i) {
    const double t = 2.25 + 2 * static_cast<double>(i);  // 1000 pulse/s past the ramp
    EXPECT_NEAR(all.edges[2 * i].time, t, 1e-12);
    EXPECT_NEAR(all.edges[2 * i + 1].time, t + 0.5, 1e-12);
  }
}

TEST(PositionCompare, FiresAListInItsOrderAndWaitsForWhatIsMissed) {
  const Trajectory motion = trapezoid_to(0, 20000);
  EXPECT_EQ(compared(pulses_at({1000, 5000, 7000, 10000, 15000}), motion).events.size(), 5U);
  const PositionCompare wrong = pulses_at({1000, 5000, 4000, 10000});
  EXPECT_EQ(compared(wrong, motion).events.size(), 2U);
  const Report report = check(wrong, motion, {}, "pulse");
  EXPECT_FALSE(report.ok());
  EXPECT_EQ(report.findings[0].rule, "compare/missed");
  EXPECT_EQ(report.findings[0].advice,
            "point 3 at 4000 pulse is not passed between point 2 and the end of the motion, and "
            "blocks the following points: give the points in the order and direction in which the "
            "motion passes them");
  EXPECT_EQ(check(pulses_at({-900}), motion, {}).findings[0].advice,
            "point 1 at -900 is never passed; the motion goes from 0 to 20000: leave out the "
            "points outside, or extend the motion");
}

TEST(PositionCompare, SetsLevelsThereAndBack) {
  PositionCompare compare{.mode = CompareMode::fifo_level};
  for (int i = 1; i <= 131; ++i) compare.points.push_back({1000.0 * i, i % 2 == 1});
  for (int i = 132; i <= 256; ++i) compare.points.push_back({1000.0 * (262 - i), i % 2 == 1});
  EXPECT_EQ(compared(compare, trapezoid_to(0, 132000)).events.size(), 131U);
  const Compared all = compared(compare, there_and_back(0, 132000));
  ASSERT_EQ(all.events.size(), 256U);
  EXPECT_EQ(all.edges.size(), 256U);  // every point changes the level
  EXPECT_TRUE(all.edges.front().on);
  EXPECT_LT(all.events.back().velocity, 0);
}

// HMPL manual 12.1.

TEST(PositionTrigger, PulsesOnlyWithinStartAndEndBothWays) {
  const Compared up = compared(himc::position_trigger(10, 20, 1, 1000), trapezoid_to(0, 30));
  ASSERT_EQ(up.events.size(), 11U);
  EXPECT_EQ(up.events.front().position, 10);
  EXPECT_EQ(up.events.back().position, 20);
  const Compared down = compared(himc::position_trigger(20, 10, 1, 1000), trapezoid_to(30, 0));
  ASSERT_EQ(down.events.size(), 11U);
  EXPECT_EQ(down.events.front().position, 20);
  EXPECT_NEAR(up.edges[1].time - up.edges[0].time, 1e-6, 1e-12);
}

TEST(PositionTrigger, FiresUnevenPositionsBothWays) {
  const std::array<double, 11> positions{10, 12, 13, 16, 17, 20, 22, 25, 26, 28, 30};
  std::vector<bool> states;
  for (std::size_t i = 0; i < positions.size(); ++i) states.push_back(i % 2 == 0);
  const Trajectory there = trapezoid_to(0, 40);
  EXPECT_EQ(compared(himc::random_trigger(positions, states, 0, 10), there).events.size(), 11U);
  EXPECT_EQ(
      compared(himc::random_trigger(positions, states, 10, 0), trapezoid_to(40, 0)).events.size(),
      11U);
  EXPECT_THROW(himc::random_trigger(positions, states, 0, 11), InputError);
  EXPECT_THROW(himc::random_trigger({}, {}, 0, 0), InputError);
}

TEST(PositionTrigger, RejectsWhatTheDriveRejects) {
  EXPECT_THROW(himc::position_trigger(0, 10, 1, 19), InputError);
  EXPECT_THROW(himc::position_trigger(0, 10, 1, 30), InputError);
  EXPECT_THROW(himc::position_trigger(0, 10, 1, 80020), InputError);
  EXPECT_THROW(himc::position_trigger(0, 10, 0, 1000), InputError);
  EXPECT_THROW(himc::position_trigger(0, std::nan(""), 1, 1000), InputError);
}

TEST(PositionTrigger, KeepsItsHighestSpeed) {
  // 0.1 mm at 16 kHz: below 1600 mm/s.
  const PositionCompare compare = himc::position_trigger(100, 200, 0.1, 1000);
  const auto at = [&](double velocity) {
    const Trajectory motion =
        trapezoid({.to = 300, .velocity = velocity, .acceleration = 1e6}).curve();
    return check(compare, motion, {.sampling_frequency = 16e3});
  };
  EXPECT_TRUE(at(1599).ok());
  const Report fast = at(1601);
  ASSERT_FALSE(fast.ok());
  EXPECT_EQ(fast.findings[0].rule, "compare/speed");
  EXPECT_NEAR(fast.findings[0].limit, 1600, 1e-6);
  EXPECT_NEAR(fast.findings[0].value, 1601, 1e-9);
}

TEST(PositionCompare, MergesPulsesThatOverlap) {
  PositionCompare compare = pulses_at({1000, 1400, 5000});  // 0.4 s apart at 1000/s
  const Trajectory motion = trapezoid_to(0, 8000);
  const Compared all = compared(compare, motion);
  ASSERT_EQ(all.edges.size(), 4U);
  EXPECT_NEAR(all.edges[1].time - all.edges[0].time, 0.9, 1e-12);
  const Report report = check(compare, motion, {});
  EXPECT_TRUE(report.ok());
  EXPECT_EQ(report.warnings(), 1U);
}

TEST(PositionCompare, FindsThePointWhereTheAxisTurns) {
  const Trajectory motion = there_and_back(0, 5000);
  const Compared all = compared(pulses_at({5000}), motion);
  ASSERT_EQ(all.events.size(), 1U);
  EXPECT_NEAR(all.events[0].time, motion.end() / 2, 1e-6);
}

/// Every time stamp is an instant at which the motion is at the point, and the first after the last.
TEST(PositionCompare, StampsTheCrossingItself) {
  const Trajectory motion =
      s_curve({.from = -3, .to = 117, .velocity = 90, .acceleration = 400, .jerk = 5000}).curve();
  PositionCompare compare{
      .mode = CompareMode::linear, .points = evenly(-3, 0.37, 324), .pulse = 1e-9};
  const Compared all = compared(compare, motion);
  ASSERT_EQ(all.events.size(), 324U);
  double last = -1;
  for (const CompareEvent& event : all.events) {
    EXPECT_NEAR(motion.jet(event.time)[0], event.position, 1e-12);
    EXPECT_GT(event.time, last);
    last = event.time;
  }
}

TEST(PositionCompare, NamesWhatIsMissing) {
  const Trajectory motion = trapezoid_to(0, 10);
  EXPECT_THROW(compared({}, motion), InputError);
  EXPECT_THROW(compared({.points = {{1}}}, motion), InputError);  // no pulse
  EXPECT_THROW(compared({.mode = CompareMode::equal, .points = {{1}, {2}}}, motion), InputError);
  EXPECT_THROW(compared({.mode = CompareMode::equal, .points = {{1}}, .pulse = 1}, motion),
               InputError);
  EXPECT_THROW(compared({.points = {{std::nan("")}}, .pulse = 1}, motion), InputError);
  EXPECT_THROW(compared(pulses_at({5}), with(motion, Extrapolation::advance)), InputError);
  EXPECT_THROW(evenly(1, 0, 2), InputError);
}

// ---- in a plane: PMC600 manual 9.4 -----------------------------------------------------------

TEST(PlaneCompare, FiresOnEnteringTheZoneOrAtTheAxis) {
  const Trajectory x({line(10, 0, 100)});
  const Trajectory y({line(10, 0, 50)});
  PlaneCompare compare{
      .x_band = 2, .y_band = 3, .points = {{20, 10}, {60, 31}, {80, 60}}, .pulse = 1e-3};
  const auto zone = compared(compare, x, y);
  ASSERT_EQ(zone.size(), 2U);             // y is 40 where x is 80: outside the band
  EXPECT_NEAR(zone[0].time, 1.8, 1e-12);  // x enters 18 to 22; y is in 7 to 13 since 1.4
  EXPECT_NEAR(zone[1].time, 5.8, 1e-12);  // x enters at 58, y is in 28 to 34 since 5.6
  compare.equal = true;
  const auto equal = compared(compare, x, y);
  ASSERT_EQ(equal.size(), 2U);
  EXPECT_NEAR(equal[0].time, 2, 1e-12);
  EXPECT_NEAR(equal[1].time, 6, 1e-12);
}

}  // namespace
}  // namespace jounce::position_compare_test
