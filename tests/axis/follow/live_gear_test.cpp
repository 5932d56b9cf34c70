// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_gear.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "axis/bench.hpp"
#include "axis/follow/live.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"

namespace jounce::live_gear_test {
namespace {

using namespace test;

/// There and back between 0 and `reach` by trapezoids, each way `T` s, without end.
std::function<Jet(double)> to_and_fro(const TablePtr& way, double reach) {
  return [=](double t) {
    const double T = way->length();
    const double n = std::floor(t / T);
    Jet x = way->jet(t - n * T);
    if (std::fmod(n, 2) != 0) x = {reach - x[0], -x[1], -x[2], -x[3]};
    return x;
  };
}

// PMC600 manual 6.1, example 6.1: master +-20000 at 10000, 10000; gears of -2 and 0.5.
TEST(LiveGear, PlaysExample61) {
  for (const auto& [numerator, denominator] : {std::pair{-2, 1}, {1, 2}}) {
    const double k = static_cast<double>(numerator) / denominator;
    LiveGear gear(1, {.numerator = numerator, .denominator = denominator, .acceleration = 1e6});
    Follower slave{gear, to_and_fro(trapezoid_table(20000, 10000, 10000, 10000), 20000)};
    ASSERT_EQ(slave.begin({}), Cause::none);
    for (int i = 1; i <= 9000; ++i) {
      const Setpoint now = slave.step();
      ASSERT_NEAR(now.slave[0], k * now.master, 1e-7) << i;
      ASSERT_NEAR(now.slave[1], k * now.master_velocity, 1e-9) << i;
      ASSERT_NEAR(std::abs(now.slave[2]), std::abs(slave.master(i * 1e-3)[2] * k), 1e-9);
    }
    EXPECT_EQ(gear.progress(), Progress::running);
    EXPECT_NEAR(slave.run(3000 * 2 - 3000).slave[0], 0, 1e-7) << "back: -40000 / 10000 a stroke";
  }
}

TEST(LiveGear, RampsFromWhateverMotionTheSlaveIsIn) {
  LiveGear gear(1, {.numerator = 1, .denominator = 2, .acceleration = 2000, .jerk = 20000});
  Follower slave{gear, steady(1000)};
  ASSERT_EQ(slave.begin({10, -200, 300}), Cause::none);
  EXPECT_EQ(gear.progress(), Progress::engaging);
  const GearedIn exact =
      gear_in({.numerator = 1, .denominator = 2, .acceleration = 2000, .jerk = 20000},
              {10, -200, 300}, {0, 1000, 0, 0}, 0);
  EXPECT_EQ(slave.now().slave[1], -200);
  EXPECT_EQ(slave.now().slave[2], 300);
  for (int k = 1; k < 1000; ++k)
    ASSERT_EQ(slave.step().slave, point(exact, steady(1000)(k * 1e-3), k * 1e-3));
  EXPECT_EQ(gear.progress(), Progress::running);
  EXPECT_NEAR(slave.now().slave[1], 500, 1e-9);
}

// Through the axis: engaged from rest, and left by GearOut with the velocity that it has.
TEST(LiveGear, IsEngagedAndLeftByAnAxis) {
  LiveGear gear(1, {.numerator = 1, .denominator = 2, .acceleration = 1e4});
  Bench bench({.limits = limits(1e4, 2e4)});
  const auto step = [&](const Command& command = {}) {
    Inputs inputs;
    inputs.master = steady(1000)(static_cast<double>(bench.tick + 1) * 1e-3);
    return bench.axis.step(++bench.tick, command, inputs);
  };
  step({command::Enable{}});
  EXPECT_FALSE(step({command::Couple{.movement = &gear}}).refused);
  Tick now;
  for (int k = 0; k < 200; ++k) now = step();
  EXPECT_EQ(now.state, State::synchronized_motion);
  EXPECT_NEAR(now.velocity, 500, 1e-9);
  EXPECT_EQ(now.progress, Progress::running);
  EXPECT_FALSE(step({command::GearOut{}}).refused);
  now = step();
  EXPECT_EQ(now.state, State::continuous_motion);
  EXPECT_NEAR(now.velocity, 500, 1e-9);
}

// The ramp uses the axis's limits up; both together had twice the jerk.
TEST(LiveGear, LeavesASuperimposedMoveWhatItsRampDoesNotUse) {
  for (const double share : {1.0, 0.5}) {
    Bench axis({.limits = limits(1000, 1e4, 1e5)});
    axis.send(Kind::enable);
    LiveGear gear(1, {.numerator = 1,
                      .denominator = 1,
                      .acceleration = 5000,
                      .deceleration = 5000,
                      .jerk = 1e5 * share});
    axis.step({command::Couple{.movement = &gear}}, at_master(0, 300));
    const Command up{command::MoveSuperimposed{.distance = 10}};
    const Tick engaging = axis.step(up, at_master(0.3, 300));
    EXPECT_EQ(refusal(engaging), share == 1 ? Cause::no_reserve : Cause::none);
    for (int i = 2; i < 500; ++i) axis.step({}, at_master(0.3 * i, 300));
    EXPECT_EQ(gear.progress(), Progress::running);
    EXPECT_EQ(refusal(axis.step(up, at_master(150, 300))), Cause::none);
  }
}

TEST(LiveGear, ALostMasterBreaksIt) {
  LiveGear gear(1, {.acceleration = 1e6});
  bool lost = false;
  Follower slave{gear, [&](double t) { return Jet{100 * t, lost ? NAN : 100, 0, 0}; }};
  ASSERT_EQ(slave.begin({}), Cause::none);
  const Setpoint before = slave.run(100);
  lost = true;
  EXPECT_EQ(slave.step().slave, before.slave);
  EXPECT_EQ(gear.progress(), Progress::broken);
  EXPECT_EQ(gear.cause(), Cause::master_lost);
  EXPECT_EQ(slave.begin({}), Cause::no_master_input);
  EXPECT_EQ(gear.begin({}, {0, 0, {0, 1e308, 0, 0}}), Cause::no_master_input);
  EXPECT_THROW(LiveGear(1, {.denominator = 0, .acceleration = 1}), InputError);
  EXPECT_THROW(LiveGear(1, {}), InputError) << "no acceleration: PMC600 error 676";
}

TEST(LiveGear, IsRejectedIfTheSlaveWouldExceedItsVelocityLimit) {
  for (const auto& [numerator, permitted] :
       {std::pair{9, false}, {-6, false}, {5, true}, {-5, true}}) {
    Bench axis(AxisConfig{.limits = limits(500, 5000)});
    axis.send(Kind::enable);
    LiveGear gear(1, {.numerator = numerator, .acceleration = 5000});
    const Tick tick = axis.step({command::Couple{.movement = &gear}}, at_master(0, 100));
    ASSERT_EQ(tick.refused.has_value(), !permitted) << numerator;
    if (permitted) continue;
    EXPECT_EQ(tick.refused->cause, Cause::velocity_limit);
    EXPECT_EQ(tick.refused->value, 100 * std::abs(numerator));
    EXPECT_EQ(tick.refused->limit, 500);
    EXPECT_EQ(axis.step({}, at_master(0.1, 100)).state, State::standstill) << "and it stays so";
  }
}

GearInPosSpec example_6_2() {
  return {.numerator = 1,
          .denominator = 2,
          .master_sync_position = 5000,
          .slave_sync_position = 2000,
          .master_start_distance = 4000};
}

// Example 6.2, looped: the master moves back and forth by 10000; in step through the reversals.
TEST(LiveGearInPos, PlaysExample62Looped) {
  LiveGearInPos gear(1, example_6_2());
  Follower slave{gear, to_and_fro(trapezoid_table(10000, 10000, 100000, 100000), 10000)};
  ASSERT_EQ(slave.begin({}), Cause::none);
  Setpoint now;
  for (test::LoopLimit loop; (now = slave.step()).master < 1000 && loop.goes_on();)
    ASSERT_EQ(now.slave[0], 0);
  EXPECT_EQ(gear.progress(), Progress::engaging) << "notes: starts at master 1000";
  for (test::LoopLimit loop; (now = slave.step()).master < 5000 && loop.goes_on();)
    ASSERT_EQ(gear.progress(), Progress::engaging);
  EXPECT_EQ(gear.progress(), Progress::running);
  EXPECT_NEAR(now.slave[0], 2000 + (now.master - 5000) / 2, 1e-9);
  EXPECT_NEAR(now.slave[1], 5000, 1e-9) << "notes: then 5000 pulse/s";
  double furthest = 0;
  for (int i = 0; i < 9000; ++i) {
    now = slave.step();
    ASSERT_NEAR(now.slave[0], 2000 + (now.master - 5000) / 2, 1e-9) << "through reversals";
    furthest = std::max(furthest, now.slave[0]);
  }
  EXPECT_NEAR(furthest, 4500, 1e-9) << "notes: at master 10000 the slave is at 4500";
}

TEST(LiveGearInPos, GoesBackWithAMasterThatTurnsWhileConnecting) {
  LiveGearInPos gear(1, example_6_2());
  Follower slave{gear, to_and_fro(trapezoid_table(3000, 10000, 100000, 100000), 3000)};
  ASSERT_EQ(slave.begin({}), Cause::none);
  bool told = false;
  Jet last{};
  for (int i = 0; i < 800; ++i) {
    const Jet now = slave.step().slave;
    told = told || gear.master_reversed();
    ASSERT_LE(std::abs(now[0] - last[0]), 0.76 * 10000 * 1e-3) << "no step";
    last = now;
  }
  EXPECT_TRUE(told);
  EXPECT_EQ(last[0], 0);
  EXPECT_EQ(gear.progress(), Progress::waiting);
}

TEST(LiveGearInPos, RejectsAnAxisThatDoesNotStandAtItsStart) {
  LiveGearInPos gear(1, example_6_2());
  const Moment now{0, 0, {0, 0, 0, 0}};
  EXPECT_EQ(gear.begin({0, 0, 0}, now), Cause::none);
  EXPECT_EQ(gear.begin({1, 0, 0}, now), Cause::start_position);
  EXPECT_EQ(gear.begin({0, 1, 0}, now), Cause::in_motion);
  EXPECT_EQ(gear.begin({1, 1, 0}, now), Cause::in_motion) << "the motion is the reason";
  EXPECT_EQ(gear.begin({0, 0, 0}, {0, 0, {NAN, 0, 0, 0}}), Cause::no_master_input);
  GearInPosSpec passed = example_6_2();
  passed.master_position = 2000;
  EXPECT_THROW(LiveGearInPos(1, passed), InputError);
}

}  // namespace
}  // namespace jounce::live_gear_test
