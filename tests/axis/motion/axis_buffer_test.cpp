// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"
#include "support/random.hpp"

namespace jounce::axis_buffer_test {
namespace {

using namespace test;

AnyCommand to(double position, double velocity, BufferMode buffer = BufferMode::aborting) {
  return {.kind = Kind::move_absolute,
          .position = position,
          .dynamics = {.velocity = velocity},
          .buffer = buffer};
}

constexpr double a = 1000;  // u/s^2, of every move here

struct Two : Bench {
  Two() : Bench({.limits = limits(200, a)}) { send(Kind::enable); }
  /// Runs until the axis rests; returns the ticks since the first move was commanded.
  std::int64_t finish() {
    const std::int64_t from = tick;
    while (last.state != State::standstill && tick < from + 20000) last = step();
    return last.tick;
  }
  Tick last{.state = State::discrete_motion};
};

/// Duration and distance of a motion from v0 to v1 at `a`, both > 0.
double time_between(double v0, double v1) {
  return std::abs(v1 - v0) / a;
}
double way_between(double v0, double v1) {
  return std::abs(v1 * v1 - v0 * v0) / (2 * a);
}

// At 95 u/s and 1000 u/s^2, a move needs a jerk of a^2 / (2 * 5 u/s) = 1e5 u/s^3 to keep 100 u/s. It
// also brakes with that jerk, in 5.5 u. At constant velocity its own 5e3 u/s^3 would do, with a stop of
// 100 u/s * sqrt(100 / 5e3) s = 14 u: so it cannot be planned again, and no move can wait for it.
TEST(AxisBuffer, AMoveBehindOneThatCannotBePlannedAgainDoesNotWait) {
  AxisConfig config{.limits = limits(100, 1000, 1e6)};
  config.limits.position_max = 14;
  Bench axis(config);
  axis.send(Kind::enable);
  Tick tick = axis.step({command::MoveVelocity{.velocity = 100}});
  for (; tick.velocity < 95; tick = axis.step()) ASSERT_LT(tick.tick, 200);
  const Command first{command::MoveAbsolute{.position = 14, .dynamics = {.jerk = 5e3}}};
  ASSERT_EQ(refusal(axis.step(first)), Cause::none);
  axis.run(20);
  const Command second{command::MoveRelative{.distance = -5, .buffer = BufferMode::buffered}};
  tick = axis.step(second);
  EXPECT_EQ(refusal(tick), Cause::no_such_move);
  EXPECT_FALSE(tick.waiting);
  tick = axis.run(2000);
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_NEAR(tick.position, 14, 1e-9) << "the rejected move has not begun";
}

// Buffered: the second move begins where the first has ended, at rest.
TEST(AxisBuffer, ABufferedMoveBeginsWhereTheOneBeforeHasEnded) {
  Two axis;
  axis.step(to(50, 100));  // 0.1 s up, 40 u at 100, 0.1 s down: 0.6 s
  EXPECT_EQ(refusal(axis.step(to(80, 100, BufferMode::buffered))), Cause::none);
  Tick tick = axis.step();
  EXPECT_TRUE(tick.waiting);
  EXPECT_TRUE(in_motion(tick));
  for (test::LoopLimit loop; tick.finished == 0 && loop.goes_on();) tick = axis.step();
  EXPECT_EQ(tick.position, 50);
  EXPECT_EQ(tick.velocity, 0);
  EXPECT_EQ(tick.state, State::discrete_motion) << "no standstill between";
  EXPECT_FALSE(tick.waiting);
  const std::int64_t there = tick.tick;
  EXPECT_EQ(axis.finish(), there + 400) << "30 u: 0.1 s, 20 u, 0.1 s";
  EXPECT_EQ(axis.last.position, 80);
  EXPECT_EQ(axis.last.finished, 2U);
}

TEST(AxisBuffer, OneThatIsRelativeCountsFromThere) {
  Two axis;
  axis.step(to(50, 100));
  axis.step({command::MoveRelative{.distance = -20, .buffer = BufferMode::buffered}});
  axis.finish();
  EXPECT_EQ(axis.last.position, 30);
  EXPECT_EQ(axis.last.finished, 2U);
}

TEST(AxisBuffer, AtStandstillItBeginsAtOnce) {
  Two axis;
  EXPECT_EQ(axis.step(to(50, 100, BufferMode::blending_next)).state, State::discrete_motion);
  axis.finish();
  EXPECT_EQ(axis.last.position, 50);
}

/// Both moves' velocities, the mode, and the velocity at the first target.
struct Blend {
  BufferMode mode;
  double first, second, through;
};

// The whole motion in closed form: to 100 u, through at the velocity asked for, to 200 u.
TEST(AxisBuffer, BlendsAtTheVelocityOfItsMode) {
  using Mode = BufferMode;
  for (const Blend& b : {Blend{Mode::blending_low, 100, 50, 50},
                         {Mode::blending_low, 50, 100, 50},
                         {Mode::blending_previous, 100, 50, 100},
                         {Mode::blending_previous, 50, 100, 50},
                         {Mode::blending_next, 100, 50, 50},
                         {Mode::blending_next, 50, 100, 100},
                         {Mode::blending_high, 100, 50, 100},
                         {Mode::blending_high, 50, 100, 100}}) {
    Two axis;
    const Tick told = axis.step(to(100, b.first));
    ASSERT_EQ(refusal(axis.step(to(200, b.second, b.mode))), Cause::none);
    const double cruise1 =
        (100 - way_between(0, b.first) - way_between(b.first, b.through)) / b.first;
    const double T1 = time_between(0, b.first) + cruise1 + time_between(b.first, b.through);
    const double cruise2 =
        (100 - way_between(b.through, b.second) - way_between(b.second, 0)) / b.second;
    const double T2 = time_between(b.through, b.second) + cruise2 + time_between(b.second, 0);
    double before = 0;
    bool passed = false;
    Tick tick;
    const double begun = told.time;
    for (test::LoopLimit loop; !passed && loop.goes_on();) {
      tick = axis.step();
      passed = tick.position >= 100;
      if (!passed) before = tick.velocity;
    }
    EXPECT_EQ(tick.tick, static_cast<std::int64_t>(std::ceil((begun + T1) * 1e3 - 1e-6)));
    EXPECT_LE(std::abs(before - b.through), a * 1e-3 + 1e-9);
    EXPECT_LE(std::abs(tick.velocity - b.through), a * 1e-3 + 1e-9);
    EXPECT_EQ(tick.finished, 1U);
    const double since = tick.time - begun - T1;
    const double up = b.second > b.through ? a : b.second < b.through ? -a : 0;
    EXPECT_NEAR(tick.position, 100 + b.through * since + up * since * since / 2, 1e-9);
    EXPECT_EQ(axis.finish(), static_cast<std::int64_t>(std::ceil((begun + T1 + T2) * 1e3 - 1e-6)));
    EXPECT_EQ(axis.last.position, 200);
    EXPECT_EQ(axis.last.finished, 2U);
  }
}

// From where the next move could no longer stop in time it is as fast as it can be: v^2 = 2 a s.
TEST(AxisBuffer, PassesNoFasterThanTheNextMoveCanTake) {
  Two axis;
  axis.step(to(100, 150));
  axis.step(to(101, 150, BufferMode::blending_previous));
  Tick before, tick;
  for (tick = axis.step(); tick.position < 100; tick = axis.step()) before = tick;
  const double through = std::sqrt(2 * a * 1);
  EXPECT_NEAR(before.velocity, std::sqrt(through * through + 2 * a * (100 - before.position)),
              1e-3);
  axis.finish();
  EXPECT_EQ(axis.last.position, 101);
}

TEST(AxisBuffer, AMoveBackComesToRestFirst) {
  Two axis;
  axis.step(to(100, 100));
  axis.step(to(20, 100, BufferMode::blending_high));
  double furthest = 0;
  for (test::LoopLimit loop; axis.last.state != State::standstill && loop.goes_on();) {
    axis.last = axis.step();
    furthest = std::max(furthest, axis.last.position);
  }
  EXPECT_EQ(furthest, 100);
  EXPECT_EQ(axis.last.position, 20);
}

TEST(AxisBuffer, IntoAVelocityItBlendsToo) {
  Two axis;
  axis.step(to(50, 100));
  axis.step({command::MoveVelocity{.velocity = 100, .buffer = BufferMode::blending_previous}});
  Tick tick = axis.run(100);
  for (int i = 0; i < 1000; ++i) {
    tick = axis.step();
    ASSERT_NEAR(tick.velocity, 100, 1e-9);
  }
  EXPECT_EQ(tick.state, State::continuous_motion);
}

// PLCopen: after MC_MoveVelocity the next begins when the velocity is reached.
TEST(AxisBuffer, AfterAVelocityItBeginsWhenThatIsReached) {
  Two axis;
  axis.step({command::MoveVelocity{.velocity = 100}});
  axis.step(to(500, 50, BufferMode::buffered));
  Tick tick = axis.run(97);
  EXPECT_EQ(tick.state, State::continuous_motion);
  tick = axis.run(3);
  EXPECT_EQ(tick.state, State::discrete_motion);
  axis.finish();
  EXPECT_EQ(axis.last.position, 500);
}

TEST(AxisBuffer, AfterATableAndAfterAHaltTheyBeginAtItsEnd) {
  Job job(1, trapezoid_table(50, 100, 900, 900));
  Two axis;
  axis.arm(job);
  axis.send(Kind::start);
  axis.run(50);
  axis.step(to(80, 100, BufferMode::blending_high));
  axis.finish();
  EXPECT_EQ(axis.last.position, 80);
  EXPECT_EQ(axis.last.finished, 2U);

  Two halted;
  halted.step(to(100, 100));
  halted.run(300);
  halted.send(Kind::halt);
  EXPECT_EQ(refusal(halted.step(to(90, 100, BufferMode::buffered))), Cause::none);
  halted.finish();
  EXPECT_EQ(halted.last.position, 90);
  EXPECT_EQ(halted.last.stopped, 1U);
}

TEST(AxisBuffer, EightWaitAndAnotherIsRejected) {
  Two axis;
  axis.step(to(50, 100));
  for (int i = 1; i <= 8; ++i)
    EXPECT_EQ(refusal(axis.step(to(50 + i, 100, BufferMode::buffered))), Cause::none) << i;
  EXPECT_EQ(refusal(axis.step(to(90, 100, BufferMode::buffered))), Cause::buffer_full);
  axis.finish();
  EXPECT_EQ(axis.last.position, 58);
  EXPECT_EQ(axis.last.finished, 9U);
}

TEST(AxisBuffer, WhatEndsTheMotionEndsWhatWaitsForIt) {
  for (const Kind kind :
       {Kind::stop, Kind::halt, Kind::abort, Kind::disable, Kind::disarm, Kind::move_absolute}) {
    Two axis;
    axis.step(to(50, 100));
    axis.step(to(80, 100, BufferMode::blending_low));
    axis.run(100);
    const Tick tick = axis.step(any({.kind = kind, .position = 60}));
    ASSERT_TRUE(tick.dropped) << name(kind);
    EXPECT_EQ(tick.dropped->cause, Cause::replaced);
    EXPECT_FALSE(axis.run(3000).waiting);
    EXPECT_LT(axis.step().position, 60.5) << name(kind);
  }
}

TEST(AxisBuffer, BehindALiveMasterThereIsNoEndToWaitFor) {
  Gear gear(1, 1);
  Two axis;
  Inputs inputs;
  inputs.master = {0, 0, 0, 0};
  axis.step({command::Couple{.movement = &gear}}, inputs);
  EXPECT_EQ(refusal(axis.step(to(80, 100, BufferMode::buffered), inputs)), Cause::synchronized);
}

// An override, a hold and a resume on the way change when, not where.
TEST(AxisBuffer, AnOverrideAndAHoldKeepBothTargets) {
  for (const BufferMode mode :
       {BufferMode::buffered, BufferMode::blending_low, BufferMode::blending_previous})
    for (int when = 100; when < 1800; when += 130) {
      Two axis;
      axis.step(to(100, 100));
      axis.step(to(160, 80, mode));
      axis.run(when);
      axis.step({command::Override{.factor = 0.5}});
      axis.run(90);
      axis.send(Kind::hold);
      axis.run(400);
      axis.send(Kind::resume);
      axis.run(120);
      axis.step({command::Override{.factor = 1.5}});
      axis.finish();
      EXPECT_EQ(axis.last.position, 160) << when;
      EXPECT_EQ(axis.last.finished, 2U) << when;
    }
}

/// Any two moves in one direction, with and without a jerk limit, commanded at any time of the
/// first one.
TEST(AxisBuffer, WhateverTheMovesBothTargetsAreMetWithinTheLimits) {
  test::Random random(49);
  for (int run = 0; run < 300; ++run) {
    AxisConfig config{.limits = limits(200, 1000)};
    if (run % 2 == 0) config.limits.jerk = 2e4;
    Bench axis(config);
    axis.send(Kind::enable);
    const double p1 = random.log_uniform(0.5, 100);
    const double p2 = p1 + random.log_uniform(0.01, 100);
    const double v1 = random.log_uniform(5, 200), v2 = random.log_uniform(5, 200);
    const auto mode = static_cast<BufferMode>(1 + random.below(5));
    axis.step(to(p1, v1));
    axis.run(random.below(60));
    Tick before = axis.step(to(p2, v2, mode));
    const std::string told = std::to_string(run) + ": " + std::to_string(p1) + " at " +
                             std::to_string(v1) + ", " + std::to_string(p2) + " at " +
                             std::to_string(v2) + ", mode " +
                             std::to_string(static_cast<int>(mode));
    Tick tick = before;
    for (int i = 0; i < 60000 && tick.state != State::standstill; ++i) {
      tick = axis.step();
      ASSERT_EQ(tick.fault, Cause::none) << told;
      ASSERT_GE(tick.position, before.position - 1e-9) << told;
      ASSERT_LE(std::abs(tick.acceleration), 1000 * (1 + 1e-9)) << told;
      ASSERT_LE(std::abs(tick.velocity - before.velocity), 1 + 1e-7) << told;
      const bool faster_before = mode >= BufferMode::blending_next && v2 > v1;
      const double most = tick.position <= p1 - 1e-9 && !faster_before ? v1 : std::max(v1, v2);
      ASSERT_LE(tick.velocity, most * (1 + 1e-9)) << told;
      ASSERT_LE(tick.position, p2 + 1e-9) << told;
      before = tick;
    }
    EXPECT_EQ(tick.position, p2) << told;
    EXPECT_EQ(tick.finished, 2U) << told;
  }
}

}  // namespace
}  // namespace jounce::axis_buffer_test
