// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/path_clock.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "axis/tables.hpp"
#include "support/random.hpp"

namespace jounce::path_clock_test {
namespace {

using test::limits;

const AxisConfig axis = resolved({.limits = limits(100, 1000, 20'000)});

TEST(PathClock, AtFullSpeedIsTheTicksTimeBitForBit) {
  PathClock clock(250'000);
  clock.start(1'000'000'007, 0, 1);
  for (std::int64_t k = 0; k < 10'000'000; k += 99'991)
    ASSERT_EQ(clock.at(1'000'000'007 + k).s, static_cast<double>(k * 250'000) / 1e9);
}

TEST(PathClock, StopsInThreeHalvesOfTheSlopeAndHalfOfThatWay) {
  PathClock clock(1'000'000);
  clock.start(0, 0, 1);
  ASSERT_TRUE(clock.change(1000, 0, 2));  // D = 0.75 s
  EXPECT_EQ(clock.at(1000).s, 1);
  EXPECT_NEAR(clock.at(1375).rate, 0.5, 1e-12);
  EXPECT_NEAR(clock.at(1375).rate_slope, -2, 1e-12);
  EXPECT_FALSE(clock.steady(1749));
  EXPECT_TRUE(clock.steady(1750));
  EXPECT_EQ(clock.at(1750).rate, 0);
  EXPECT_NEAR(clock.at(5000).s, 1.375, 1e-12);
}

// A hold and a resume: path time goes on where it stopped, then again one second a second.
TEST(PathClock, ContinuesWhereItWasHeld) {
  PathClock clock(1'000'000);
  clock.start(0, 0, 1);
  clock.change(500, 0, 10);
  const double held = clock.at(2000).s;
  clock.change(2000, 1, 10);
  EXPECT_EQ(clock.at(2000).s, held);
  const PathTime on = clock.at(2150);
  EXPECT_EQ(on.rate, 1);
  EXPECT_NEAR(on.s, held + 0.075, 1e-12);
  EXPECT_NEAR(clock.at(3150).s - on.s, 1, 1e-12);
}

TEST(PathClock, NeverRunsBackwardsWhateverIsAskedOfItWhen) {
  test::Random random(7);
  PathClock clock(1'000'000);
  clock.start(0, 0, 1);
  PathTime last;
  double top = 1;  // no rate above those asked for
  for (std::int64_t tick = 1; tick < 100'000; ++tick) {
    if (random.below(40) == 0) {
      const double rate = random.below(3) ? random.uniform(0, 2) : 0;
      top = std::max(rate, clock.steady(tick) ? clock.target() : top);
      ASSERT_TRUE(clock.change(tick, rate, 20));
    }
    const PathTime now = clock.at(tick);
    ASSERT_GE(now.s, last.s) << tick;
    ASSERT_GE(now.rate, 0) << tick;
    ASSERT_LE(now.rate, top * (1 + 1e-12)) << tick;
    ASSERT_LE(std::abs(now.rate_slope), 20 * (1 + 1e-12)) << tick;
    ASSERT_LE(std::abs(now.rate_slope - last.rate_slope), 800e-3 * (1 + 1e-9)) << tick;
    ASSERT_NEAR(now.s - last.s, (now.rate + last.rate) / 2e3, 1e-6) << tick;
    last = now;
  }
}

// Over p = V/w sin(w s), whose peaks are V, V w, V w^2, a stop begun anywhere keeps the stop
// limits: checked against the velocity's own differences, not by the formula that set the slope.
TEST(PathClock, AChangeOfTheRateKeepsTheStopLimitsWhereverItComes) {
  const double V = 80;
  const double w = 10;
  const Peaks peaks{V, V * w, V * w * w, 0};
  for (const double to : {0.0, 0.3, 1.1}) {
    const double slope = rate_slope(peaks, axis, std::max(1.0, to));
    for (std::int64_t when = 1000; when < 1628; when += 7) {
      PathClock clock(1'000'000);
      clock.start(0, 0, 1);
      clock.change(when, to, slope);
      Jet before{};
      for (std::int64_t tick = when; tick < when + 700; ++tick) {
        const PathTime time = clock.at(tick);
        const double x = w * time.s;
        const Setpoint path{
            0,
            0,
            {V / w * std::sin(x), V * std::cos(x), -V * w * std::sin(x), -V * w * w * std::cos(x)}};
        const Jet now = at_rate(path, time).slave;
        ASSERT_LE(std::abs(now[2]), axis.stop_acceleration * (1 + 1e-9));
        ASSERT_LE(std::abs(now[3]), axis.stop_jerk * (1 + 1e-9));
        if (tick > when) {
          ASSERT_NEAR(now[0] - before[0], (now[1] + before[1]) / 2e3, axis.stop_jerk * 1e-9 / 6);
          ASSERT_LE(std::abs(now[1] - before[1]), axis.stop_acceleration * 1e-3 * (1 + 1e-9));
        }
        before = now;
      }
    }
  }
}

TEST(PathClock, AnOverrideIsClippedToWhatTheLimitsLeave) {
  EXPECT_DOUBLE_EQ(highest_rate({80, 100, 100, 0}, axis), 1.25);
  EXPECT_DOUBLE_EQ(highest_rate({10, 640, 100, 0}, axis), 1.25);
  EXPECT_DOUBLE_EQ(highest_rate({10, 100, 20'000 / 1.728, 0}, axis), 1.2);
  EXPECT_EQ(highest_rate({1, 1, 1, 0}, axis), 2);
  EXPECT_EQ(highest_rate({100, 1000, 20'000, 0}, axis), 1);
  // A kink at a rate above 1 may meet another one in the same tick.
  EXPECT_DOUBLE_EQ(highest_rate({10, 0, 0, 0.4}, axis), 1.25);
}

TEST(PathClock, RejectsAChangeThatIsNone) {
  PathClock clock(1'000'000);
  clock.start(0, 0, 1);
  EXPECT_FALSE(clock.change(1, -1, 1));
  EXPECT_FALSE(clock.change(1, 0, 0));
  EXPECT_FALSE(clock.change(1, NAN, 1));
  EXPECT_EQ(clock.at(1000).s, 1);
}

TEST(PathClock, APathThatStandsIsStoppedWithinATick) {
  EXPECT_DOUBLE_EQ(stop_duration({}, axis), 1e-3);
}

}  // namespace
}  // namespace jounce::path_clock_test
