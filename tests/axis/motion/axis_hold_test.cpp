// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/tables.hpp"

// A hold brings everything to rest in the time of a halt, for every motion under way.

namespace jounce::axis_hold_test {
namespace {

using namespace test;

const AxisConfig wide{.limits = limits(1000, 1e4)};

struct Held : Bench {
  explicit Held(const AxisConfig& config = wide) : Bench(config) { send(Kind::enable); }

  /// Ticks until it rests, at most 5000.
  int rest() {
    int ticks = 0;
    for (last = step(); last.velocity != 0 && ticks < 5000; ++ticks) {
      const Tick now = step();
      most = std::max(most, std::abs(now.velocity - last.velocity) * 1e3);
      last = now;
    }
    return ticks;
  }
  Tick last;
  double most = 0;  // u/s^2
};

TEST(AxisHold, BrakesWithTheLimitsOfTheAxisWhateverItsMoveAskedFor) {
  Held axis;
  axis.step({command::MoveVelocity{.velocity = 100, .dynamics = {.deceleration = 1e-9}}});
  axis.run(50);
  axis.send(Kind::hold);
  EXPECT_LE(axis.rest(), 10);  // 100 u/s by 1e4 u/s^2
  EXPECT_LE(axis.most, 1e4 * (1 + 1e-9));
  axis.send(Kind::resume);
  EXPECT_EQ(axis.run(50).velocity, 100);
  axis.step({command::Override{.factor = 0}});
  EXPECT_LE(axis.rest(), 10) << "an override of 0 is the same";
}

TEST(AxisHold, OfAMoveTakesWhatIsSuperimposedWithItAndResumesToTheTargetOfBoth) {
  Held axis;
  axis.step({command::MoveAbsolute{
      .position = 100, .dynamics = {.velocity = 100, .acceleration = 5000, .deceleration = 5000}}});
  axis.run(100);
  axis.step({command::MoveSuperimposed{.distance = 50,
                                       .dynamics = {.velocity = 20, .deceleration = 10}}});
  EXPECT_GT(axis.run(50).velocity, 110);
  axis.send(Kind::hold);
  EXPECT_LE(axis.rest(), 15);
  EXPECT_LE(axis.most, 1e4 * (1 + 1e-9));
  const double stands = axis.last.position;
  EXPECT_EQ(axis.run(1000).position, stands);
  axis.send(Kind::resume);
  EXPECT_EQ(axis.run(3000).position, 150);
}

TEST(AxisHold, OfAPathTakesWhatIsSuperimposedWithItAndGoesOnWithIt) {
  Held axis;
  Job job(1, trapezoid_table(200, 100, 1000, 1000));
  axis.arm(job);
  axis.send(Kind::start);
  axis.run(500);
  axis.step({command::MoveSuperimposed{.distance = 50,
                                       .dynamics = {.velocity = 20, .deceleration = 10}}});
  EXPECT_GT(axis.run(100).velocity, 110);
  axis.send(Kind::hold);
  EXPECT_LE(axis.rest(), 30);
  EXPECT_LE(axis.most, 2e4 * (1 + 1e-9)) << "within the stop limits";
  const double stands = axis.last.position;
  EXPECT_EQ(axis.run(1000).position, stands);
  EXPECT_EQ(axis.last.job, 1U);
  EXPECT_FALSE(axis.send(Kind::resume).refused);
  EXPECT_NEAR(axis.run(30'000).position, 250, 1e-9);
  EXPECT_EQ(axis.axis.state(), State::standstill);
}

// An order for this tick plans it anew, and so does the hold: the second leapt by a tick.
TEST(AxisHold, InTheTickOfAnotherOrderTakesNoStep) {
  Held axis;
  Job job(1, trapezoid_table(200, 100, 1000, 1000));
  axis.arm(job);
  axis.send(Kind::start);
  axis.run(500);
  const Command up{command::MoveSuperimposed{.distance = 50, .dynamics = {.velocity = 100}}};
  axis.step(up);
  axis.run(100);
  Command again = up;
  again.at = axis.tick + 10;
  axis.step(again);
  const Tick before = axis.run(8);
  const Tick now = axis.send(Kind::hold);
  EXPECT_NEAR(now.position - before.position, 5e-4 * (now.velocity + before.velocity), 5.1e-3);
}

TEST(AxisHold, WhatIsSuperimposedStaysHeldWhereThePathEndsMeanwhile) {
  Held axis;
  Job job(1, trapezoid_table(10, 100, 5000, 5000));
  axis.arm(job);
  axis.send(Kind::start);
  axis.run(105);
  axis.step({command::MoveSuperimposed{.distance = 50,
                                       .dynamics = {.velocity = 20, .deceleration = 10}}});
  axis.run(12);
  axis.send(Kind::hold);
  axis.rest();
  const double stands = axis.last.position;
  EXPECT_LT(stands, 30);
  EXPECT_EQ(axis.run(1000).position, stands);
  axis.send(Kind::resume);
  EXPECT_NEAR(axis.run(30'000).position, 60, 1e-9);
}

// The way back from beyond the target would take a day at 1e-9 u/s; the planner's durations have no digits
// for it, and its motion leapt by 122 u in the middle.
TEST(AxisMoves, AMoveThatNoDoubleHasTheDigitsForIsRejected) {
  Held axis({.limits = limits(1000, 1e4, 1e6)});
  axis.step({command::MoveVelocity{.velocity = 400}});
  Tick last = axis.run(200);
  const Command far{
      command::MoveRelative{.distance = 2, .dynamics = {.velocity = 500, .deceleration = 2e-14}}};
  const Tick now = axis.step(far);
  EXPECT_EQ(refusal(now), Cause::no_such_move);
  EXPECT_EQ(now.velocity, 400) << "the jog goes on";
  axis.step({command::Halt{}});
  for (last = axis.step(); last.state != State::standstill; last = axis.step())
    ASSERT_LT(axis.tick, 1000);
  Command near = far;
  std::get<command::MoveRelative>(near.what).dynamics.deceleration = 1e-6;
  EXPECT_FALSE(axis.step(near).refused) << "from rest it is only as fast as it can brake";
}

// Let go of the jog to one side, an operator presses that to the other one.
TEST(AxisHold, AfterAReleaseTheNextMotionBeginsAtOnceAndAfterAStopNone) {
  const Command back{command::MoveVelocity{.velocity = -100}};
  for (const bool stops : {false, true}) {
    Held axis;
    axis.step({command::MoveVelocity{.velocity = 500}});
    axis.run(100);
    axis.send(Kind::release);
    EXPECT_EQ(axis.run(3).state, State::stopping);
    if (stops) axis.send(Kind::stop);
    const Tick now = axis.step(back);
    EXPECT_EQ(refusal(now), stops ? Cause::stopping : Cause::none);
    axis.run(200);
    EXPECT_EQ(axis.step().velocity, stops ? 0 : -100);
    EXPECT_EQ(axis.step().reason, stops ? Cause::stopped : Cause::replaced);
  }
}

}  // namespace
}  // namespace jounce::axis_hold_test
