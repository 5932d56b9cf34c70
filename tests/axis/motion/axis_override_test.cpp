// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"
#include "support/random.hpp"

namespace jounce::axis_override_test {
namespace {

using namespace test;

/// At twice the speed of the stream below a stop has only 900 of 9900 u/s^2 left to brake with.
const AxisConfig tight{.limits = limits(300, 9000), .stop_acceleration = 9900};

/// A stream of which `known` s are there and `supply` s come in each of the axis's ticks.
struct Rolling : Bench {
  Rolling(double known, double supply) : Bench(tight) {
    feed.prefill(known);
    feed.supply = supply;
    send(Kind::enable);
    step({command::Arm{.movement = &feed}});
    send(Kind::start);
  }
  Tick override_by(double factor) { return step({command::Override{.factor = factor}}); }

  static constexpr double reach = 10, w = 15;  // 150 u/s, 2250 u/s^2: twice as fast is possible
  Feed feed{1, 0, reach, w};
};

// More than the path's own speed takes a longer way to rest, and a flatter one: an override that is
// raised shortly before the end of what is known must not take the axis off its path.
TEST(AxisOverride, RaisedWhileLittleIsKnownItStaysOnThePath) {
  for (int ticks = 20; ticks < 900; ticks += 7) {
    Rolling rolling(1, 0);
    rolling.run(ticks);
    Tick tick = rolling.override_by(2);
    for (int i = 0; i < 2000 && tick.fault == Cause::none; ++i) tick = rolling.step();
    tick = rolling.run(2000);
    EXPECT_EQ(tick.fault, Cause::underrun) << ticks;
    EXPECT_EQ(tick.job, 1U) << ticks << ": it has left the path";
    EXPECT_EQ(tick.velocity, 0) << ticks;
    EXPECT_EQ(tick.stopped, 0U);
  }
}

/// Holds at every rate: position and velocity are those of one path time, which rises.
TEST(AxisOverride, WhateverIsAskedAndSuppliedTheSetpointIsOnThePath) {
  test::Random random(7);
  for (int run = 0; run < 100; ++run) {
    Rolling rolling(random.uniform(0.05, 0.5), random.uniform(0, 3e-3));
    Tick before = rolling.step();
    for (int i = 0; i < 1500; ++i) {
      if (random.below(100) == 0) rolling.feed.supply = random.uniform(0, 3e-3);
      const Tick now =
          random.below(60) == 0 ? rolling.override_by(random.uniform(0, 2)) : rolling.step();
      if (now.fault == Cause::underrun && now.velocity == 0) {
        EXPECT_EQ(now.job, 1U) << "run " << run << ", tick " << i;
        rolling.feed.prefill(rolling.feed.known() + 0.4);
        rolling.send(Kind::reset);
        before = rolling.send(Kind::resume);
        continue;
      }
      ASSERT_TRUE(now.fault == Cause::none || now.fault == Cause::underrun) << name(now.fault);
      ASSERT_EQ(now.job, 1U) << "run " << run << ", tick " << i << ": it has left the path";
      // p = R (1 - cos ws), v = R w sin(ws) r: v^2 = w^2 p (2R - p) r^2
      const double p = now.position;
      const double expected = Rolling::w * std::sqrt(std::max(p * (2 * Rolling::reach - p), 0.0));
      ASSERT_NEAR(std::abs(now.velocity), expected * now.rate, 1e-5) << run << ' ' << i;
      ASSERT_LE(std::abs(now.velocity - before.velocity), 20 * (1 + 1e-9));
      before = now;
    }
  }
}

TEST(AxisOverride, OfAStreamThatComesFastEnoughItIsGranted) {
  Rolling rolling(1, 2.5e-3);
  rolling.run(50);
  rolling.override_by(2);
  const Tick tick = rolling.run(2000);
  EXPECT_EQ(tick.override_, 2);
  EXPECT_EQ(tick.rate, 2);
  EXPECT_EQ(tick.fault, Cause::none);
}

// Twice as fast is played than comes: what was ahead is used up, and then it is the supply's speed.
TEST(AxisOverride, OfAStreamThatKeepsUpWithFullSpeedAloneItIsTakenBackAndNoFault) {
  Rolling rolling(2, 1e-3);
  rolling.run(50);
  rolling.override_by(2);
  Tick tick = rolling.run(500);
  EXPECT_EQ(tick.rate, 2);
  double fastest = 0;
  for (int i = 0; i < 5000; ++i) tick = rolling.step();
  for (int i = 0; i < 2000; ++i) {
    tick = rolling.step();
    fastest = std::max(fastest, tick.rate);
    EXPECT_GE(tick.rate, 1);
  }
  EXPECT_EQ(tick.fault, Cause::none);
  EXPECT_LT(fastest, 1.5);
}

}  // namespace
}  // namespace jounce::axis_override_test
