// SPDX-License-Identifier: Apache-2.0
// Moves that wait, and how fast their targets are passed.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/src/motion/move_plan.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"
#include "support/random.hpp"

namespace jounce::move_queue_test {
namespace {

using namespace test;

constexpr double a = 1000;  // u/s^2

AnyCommand to(double position, double velocity, BufferMode buffer) {
  return {.kind = Kind::move_absolute,
          .position = position,
          .dynamics = {.velocity = velocity},
          .buffer = buffer};
}

AxisConfig config_with(double jerk) {
  AxisConfig config{.limits = limits(200, a)};
  if (jerk > 0) config.limits.jerk = jerk;
  return config;
}

/// The first of two moves as the axis plans it: to 100 u at 50 u/s, through at 100 u/s.
Profile first_of_two(const AxisConfig& config, double from = 0) {
  MoveDynamics slow{.velocity = 50}, fast{.velocity = 100};
  EXPECT_FALSE(fill(slow, config));
  EXPECT_FALSE(fill(fast, config));
  const Goal next{.kind = Goal::Kind::position, .value = 200, .dynamics = fast};
  Goal first{.kind = Goal::Kind::position, .value = 100, .dynamics = slow};
  const MotionState start{.position = from};
  first.through = passing_velocity(start, first, next, BufferMode::blending_high, 1, config);
  const auto profile = plan(start, first, 1, config);
  EXPECT_TRUE(profile);
  return *profile;
}

// A cycle that is late by more than a short move takes: it goes on where it would have been in time.
TEST(Blending, ALateCycleMayPassSeveralTargets) {
  for (const std::int64_t late : {5, 20, 40, 90}) {
    Bench in_time(config_with(0)), too_late(config_with(0));
    for (Bench* each : {&in_time, &too_late}) {
      each->send(Kind::enable);
      each->step(to(100, 50, BufferMode::aborting));
      for (int i = 1; i <= 6; ++i) each->step(to(100 + 0.5 * i, 50, BufferMode::blending_previous));
      each->step(to(150, 50, BufferMode::blending_previous));
      for (test::LoopLimit loop; each->step().position < 99.5 && loop.goes_on();) continue;
    }
    const Tick there = in_time.run(late);
    too_late.tick += late - 1;
    const Tick here = too_late.step();
    ASSERT_EQ(here.tick, there.tick);
    ASSERT_EQ(here.fault, Cause::none);
    EXPECT_NEAR(here.position, there.position, 1e-9) << late << " ticks late";
    EXPECT_NEAR(here.velocity, there.velocity, 1e-9) << late << " ticks late";
    EXPECT_EQ(here.finished, there.finished);
    const Tick last = too_late.run(5000);
    EXPECT_EQ(last.state, State::standstill);
    EXPECT_NEAR(last.position, 150, 1e-9);
    EXPECT_EQ(last.finished, 8);
  }
}

// PLCopen: through the target at the higher velocity. From 50 to 100 u/s at a takes 50 ms and 3.75 u: it
// begins 3.75 u before the target, and no sooner.
TEST(Blending, SpeedsUpForAFasterMoveAsLateAsItCan) {
  const Profile p = first_of_two(config_with(0));
  EXPECT_EQ(p.end(), (MotionState{100, 100, 0}));
  // 0.05 s to 50 u/s in 1.25 u; 95 u at 50 u/s; 0.05 s and 3.75 u.
  EXPECT_NEAR(p.duration(), 0.05 + 95.0 / 50 + 0.05, 1e-12);
  EXPECT_NEAR(p.at(0.05 + 1.9).position, 96.25, 1e-9);
  EXPECT_NEAR(p.at(0.05 + 1.9).velocity, 50, 1e-9);
  EXPECT_NEAR(p.at(1).velocity, 50, 1e-9);
}

// Below 4 a^2 / dv, a jerk j makes a ramp of 2 sqrt(dv / j) at the mean velocity: 75 u/s.
TEST(Blending, SpeedsUpWithinItsJerkToo) {
  const double j = 2e4;
  const Profile p = first_of_two(config_with(j));
  const double ramp = 50 / a + a / j;  // s: acceleration-limited, dv > a^2 / j
  EXPECT_EQ(p.end(), (MotionState{100, 100, 0}));
  EXPECT_NEAR(p.at(p.duration() - ramp).position, 100 - 75 * ramp, 1e-9);
  EXPECT_NEAR(p.at(p.duration() - ramp).velocity, 50, 1e-9);
  EXPECT_NEAR(p.at(p.duration() - ramp).acceleration, 0, 1e-6);
  EXPECT_LE(velocities(p)[1], 100 * (1 + 1e-12));
}

// From rest 2 u before the target: v^2 = 2 a s.
TEST(Blending, PassesAsFastAsItCanWhereTheWayIsShort) {
  const Profile p = first_of_two(config_with(0), 98);
  EXPECT_NEAR(p.end().velocity, std::sqrt(2 * a * 2), 1e-4);
  EXPECT_EQ(p.end().position, 100);
}

TEST(Blending, IsMirroredTheOtherWay) {
  MoveDynamics slow{.velocity = 50}, fast{.velocity = 100};
  const AxisConfig config = config_with(2e4);
  EXPECT_FALSE(fill(slow, config));
  EXPECT_FALSE(fill(fast, config));
  const Goal next{.kind = Goal::Kind::position, .value = -200, .dynamics = fast};
  Goal first{.kind = Goal::Kind::position, .value = -100, .dynamics = slow};
  first.through = passing_velocity({}, first, next, BufferMode::blending_next, 1, config);
  EXPECT_EQ(first.through, -100);
  const auto back = plan({}, first, 1, config);
  ASSERT_TRUE(back);
  const Profile ahead = first_of_two(config);
  for (double t = 0; t < ahead.duration(); t += 0.01)
    EXPECT_NEAR(back->at(t).position, -ahead.at(t).position, 1e-9) << t;
}

// Eight moves behind one, each blended: every target is met, in order, within the limits, and the sum of
// relative ones is exact.
TEST(MoveQueue, EveryTargetIsMetInOrder) {
  test::Random random(56);
  for (int run = 0; run < 120; ++run) {
    const double jerk = run % 2 == 0 ? 2e4 : 0;
    Bench axis(config_with(jerk));
    axis.send(Kind::enable);
    std::vector<double> targets;
    std::string told = "run " + std::to_string(run) + ":";
    Tick before;
    for (int i = 0; i < 9; ++i) {
      const double by = random.log_uniform(0.02, 30) * (random.below(6) == 0 ? -1 : 1);
      const auto mode = static_cast<BufferMode>(i == 0 ? 0 : 1 + random.below(5));
      const double v = random.log_uniform(5, 200);
      targets.push_back((targets.empty() ? 0 : targets.back()) + by);
      told += " " + std::to_string(by) + " at " + std::to_string(v) + " mode " +
              std::to_string(static_cast<int>(mode)) + ";";
      AnyCommand move = to(by, v, mode);
      move.kind = Kind::move_relative;
      before = axis.step(move);
      ASSERT_FALSE(before.refused) << told;
    }
    std::size_t met = before.finished;
    Tick tick = before;
    for (int i = 0; i < 60'000 && tick.state != State::standstill; ++i) {
      tick = axis.step();
      ASSERT_EQ(tick.fault, Cause::none) << told;
      ASSERT_LE(std::abs(tick.velocity), 200 * (1 + 1e-9)) << told;
      ASSERT_LE(std::abs(tick.velocity - before.velocity), 1 + 1e-7) << told;
      for (; met < tick.finished; ++met) {  // passed, or stood at, since the tick before
        const double low = std::min(before.position, tick.position);
        const double high = std::max(before.position, tick.position);
        ASSERT_GE(targets[met], low - 1e-9) << told;
        ASSERT_LE(targets[met], high + 1e-9) << told;
      }
      before = tick;
    }
    EXPECT_EQ(tick.finished, 9U) << told;
    EXPECT_NEAR(tick.position, targets.back(), 1e-9) << told;
  }
}

// The limit switch is reached exactly where the first move ends: the second may not begin, and so the third,
// which would go back from where the second was to end, does not either.
TEST(MoveQueue, WhatCannotBeginEndsWhatComesAfterIt) {
  std::int64_t there = -1;  // the tick in which the first move ends, of a run without the switch
  for (const bool blocked : {false, true}) {
    Bench axis(config_with(0));
    axis.send(Kind::enable);
    axis.step(to(10, 100, BufferMode::aborting));
    axis.step(to(20, 100, BufferMode::buffered));
    axis.step(to(5, 100, BufferMode::buffered));
    Tick tick;
    for (bool dropped = false; tick.state != State::standstill;) {
      Inputs inputs;
      inputs.positive_switch = blocked && axis.tick + 1 == there;
      tick = axis.step({}, inputs);
      if (tick.finished == 1 && there < 0) there = tick.tick;
      dropped |= tick.dropped.has_value();
      if (tick.dropped) {
        EXPECT_EQ(tick.dropped->cause, Cause::direction_blocked);
      }
      if (tick.state == State::standstill) {
        EXPECT_EQ(dropped, blocked);
      }
    }
    EXPECT_EQ(tick.position, blocked ? 10 : 5);
    EXPECT_EQ(tick.finished, blocked ? 1U : 3U);
    EXPECT_EQ(tick.fault, Cause::none);
    EXPECT_FALSE(tick.waiting);
  }
}

TEST(MoveQueue, DisarmTakesAllBackAndAMoveReplacesThem) {
  for (const Kind kind : {Kind::disarm, Kind::move_absolute, Kind::halt}) {
    Bench axis(config_with(0));
    axis.send(Kind::enable);
    axis.step(to(50, 100, BufferMode::aborting));
    for (int i = 1; i <= 4; ++i) axis.step(to(50 + 10 * i, 100, BufferMode::blending_high));
    axis.run(100);
    const Tick told = axis.step(any({.kind = kind, .position = 40}));
    ASSERT_TRUE(told.dropped) << name(kind);
    EXPECT_EQ(told.dropped->cause, Cause::replaced);
    EXPECT_EQ(told.dropped->value, 60) << "the first of them";
    const Tick end = axis.run(3000);
    EXPECT_EQ(end.state, State::standstill);
    EXPECT_LE(end.position, 50);
    EXPECT_FALSE(end.waiting);
  }
}

// A place is free as soon as a move begins.
TEST(MoveQueue, TakesMoreAsItIsWorkedOff) {
  Bench axis(config_with(0));
  axis.send(Kind::enable);
  axis.step(to(1, 100, BufferMode::aborting));
  int given = 1;
  Tick tick;
  for (int i = 0; i < 20'000 && (given < 40 || tick.state != State::standstill); ++i) {
    const bool more = given < 40;
    tick = axis.step(more ? to(given + 1, 100, BufferMode::blending_low) : Command{});
    if (more && !tick.refused) ++given;
    if (tick.refused) {
      EXPECT_EQ(tick.refused->cause, Cause::buffer_full);
    }
  }
  EXPECT_EQ(tick.position, 40);
  EXPECT_EQ(tick.finished, 40U);
}

}  // namespace
}  // namespace jounce::move_queue_test
