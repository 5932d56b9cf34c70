// SPDX-License-Identifier: Apache-2.0
// Phase shifts of gears and cams against closed forms and the cam itself, and within the limits.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/live_cam.hpp"
#include "jounce/axis/live_gear.hpp"

#include "axis/tables.hpp"

namespace jounce::phasing_test {
namespace {

using namespace test;

/// An axis that follows a master of constant velocity.
struct Slave : Bench {
  Slave(Movement& movement, double master_velocity, const Limits& limits)
      : Bench({.limits = limits}), velocity(master_velocity) {
    follow({command::Enable{}});
    EXPECT_EQ(refusal(follow({command::Couple{.movement = &movement}})), Cause::none);
  }
  Tick follow(const Command& command = {}) {
    ++count;
    return step(command, at_master(velocity * static_cast<double>(count) * 1e-3, velocity));
  }
  Tick follow_for(int ticks) {
    Tick last;
    for (int k = 0; k < ticks; ++k) last = follow();
    return last;
  }
  double velocity;
  std::int64_t count = -2;  // the coupling begins at master 0
};

/// 0 to `way` with velocity v and acceleration a, as a trapezoid of velocity.
double shifted(double way, double v, double a, double t) {
  const double T = way / v + v / a;
  t = std::clamp(t, 0.0, T);
  if (t < v / a) return a * t * t / 2;
  if (t > T - v / a) return way - a * (T - t) * (T - t) / 2;
  return v * (t - v / a / 2);
}

TEST(Phasing, ShiftsAGearByTheRatio) {
  LiveGear gear(1, {.numerator = 3, .denominator = 2, .acceleration = 1e5});
  Slave slave(gear, 100, limits(1000, 1e5));
  slave.follow_for(200);
  const double before = slave.follow().position;
  const command::PhasingAbsolute shift{5,
                                       {.velocity = 20, .acceleration = 100, .deceleration = 100}};
  EXPECT_EQ(refusal(slave.follow({shift})), Cause::none);
  for (int k = 1; k < 1000; ++k) {
    const Tick now = slave.follow();
    const double s = shifted(5, 20, 100, k * 1e-3);
    ASSERT_NEAR(now.position, before + 1.5 * (0.1 * (k + 1) + s), 1e-9) << k;
    ASSERT_NEAR(now.master, 0.1 * static_cast<double>(slave.count) + s, 1e-9);
    ASSERT_EQ(now.state, State::synchronized_motion);
  }
  EXPECT_NEAR(slave.follow().velocity, 150, 1e-9) << "in gear";
  // Relative: once more; absolute: back to the phase of the beginning.
  const double shifted_once = slave.follow().position;
  slave.follow({command::PhasingRelative{5}});
  EXPECT_NEAR(slave.follow_for(2000).position, shifted_once + 1.5 * (0.1 * 2001 + 5), 1e-8);
  slave.follow({command::PhasingAbsolute{0}});
  EXPECT_NEAR(slave.follow_for(2000).position, shifted_once + 1.5 * (0.1 * 4002 - 5), 1e-8);
}

TEST(Phasing, ASlaveOfACamIsOnTheCamAtTheShiftedMaster) {
  const TablePtr table = pmc600_cam();
  LiveCam cam(1, table, {.start = StartMode::absolute});
  Slave slave(cam, 100, limits(1e3, 1e5));
  slave.follow_for(500);
  const Command shift{
      command::PhasingRelative{-30, {.velocity = 50, .acceleration = 500, .deceleration = 500}}};
  EXPECT_EQ(refusal(slave.follow(shift)), Cause::none);
  for (int k = 1; k < 2000; ++k) {
    const Tick now = slave.follow();
    const double x = 0.1 * static_cast<double>(slave.count) - shifted(30, 50, 500, k * 1e-3);
    ASSERT_NEAR(now.master, x, 1e-9);
    ASSERT_NEAR(now.position, table->jet(x - 360 * std::floor(x / 360))[0], 1e-8) << k;
  }
}

TEST(Phasing, TheDefaultsUseTheLimitsThatAreLeft) {
  LiveGear gear(1, {.numerator = 2, .denominator = 1, .acceleration = 1e4, .jerk = 1e6});
  Slave slave(gear, 100, limits(500, 1e4, 1e6));
  slave.follow_for(500);
  EXPECT_EQ(refusal(slave.follow({command::PhasingAbsolute{100}})), Cause::none);
  double fastest = 0;
  double hardest = 0;
  Tick last = slave.follow();
  for (int k = 0; k < 3000; ++k) {
    const Tick now = slave.follow();
    fastest = std::max(fastest, now.velocity);
    hardest = std::max(hardest, std::abs(now.acceleration));
    ASSERT_LE(std::abs(now.acceleration - last.acceleration), 1e6 * 1e-3 * (1 + 1e-6));
    last = now;
  }
  EXPECT_NEAR(fastest, 500, 1e-9);
  EXPECT_NEAR(hardest, 1e4, 1e-6);
  EXPECT_NEAR(last.velocity, 200, 1e-9);
}

TEST(Phasing, IsRejectedWithTheNumbersOfTheAxis) {
  LiveGear gear(1, {.numerator = 2, .denominator = 1, .acceleration = 1e4});
  Slave slave(gear, 100, limits(500, 1e4));
  slave.follow_for(500);
  const auto refused = [&](double shift, const MoveDynamics& dynamics = {}) {
    const Tick now = slave.follow({command::PhasingAbsolute{shift, dynamics}});
    return now.refused.value_or(Refusal{});
  };
  EXPECT_EQ(refused(NAN).cause, Cause::no_value);
  EXPECT_EQ(refused(1e300).cause, Cause::no_such_move);
  const Refusal fast = refused(100, {.velocity = 151});
  EXPECT_EQ(fast.cause, Cause::velocity_limit);
  EXPECT_NEAR(fast.value, 502, 1e-6);
  EXPECT_DOUBLE_EQ(fast.limit, 500);
  EXPECT_EQ(refused(100, {.acceleration = 6000}).cause, Cause::acceleration_limit);
  EXPECT_EQ(refused(100, {.velocity = 0}).cause, Cause::not_positive);
  EXPECT_NEAR(slave.follow().velocity, 200, 1e-9) << "nothing has changed";
  // The slave needs all of its velocity for its master.
  const Refusal full = [&] {
    LiveGear steady(2, {.numerator = 2, .denominator = 1, .acceleration = 1e4});
    Slave fastest(steady, 250, limits(500, 1e4));
    fastest.follow_for(500);
    return fastest.follow({command::PhasingAbsolute{1}}).refused.value_or(Refusal{});
  }();
  EXPECT_EQ(full.cause, Cause::velocity_limit);
  EXPECT_DOUBLE_EQ(full.value, 500);
}

TEST(Phasing, NeedsALiveMaster) {
  Bench bench({.limits = limits(100, 1000)});
  const Command shift{command::PhasingAbsolute{5}};
  EXPECT_EQ(refusal(bench.step(shift)), Cause::not_enabled);
  bench.send(Kind::enable);
  EXPECT_EQ(refusal(bench.step(shift)), Cause::not_synchronized);
  bench.step({command::MoveVelocity{.velocity = 50}});
  EXPECT_EQ(refusal(bench.step(shift)), Cause::not_synchronized);
  bench.run(10);
  bench.send(Kind::stop);
  EXPECT_EQ(refusal(bench.step(shift)), Cause::stopping);
}

TEST(Phasing, EndsWithTheCoupling) {
  LiveGear gear(1, {.acceleration = 1e4});
  LiveGear again(2, {.acceleration = 1e4});
  Slave slave(gear, 100, limits(500, 1e4));
  slave.follow_for(500);
  slave.follow({command::PhasingAbsolute{50, {.velocity = 100}}});
  slave.follow_for(100);
  Tick now = slave.follow({command::GearOut{}});
  EXPECT_EQ(now.fault, Cause::none);
  EXPECT_NEAR(slave.follow().velocity, 200, 1e-6) << "keeps the velocity";
  EXPECT_EQ(refusal(slave.follow({command::Couple{.movement = &again}})), Cause::none);
  now = slave.follow_for(500);
  EXPECT_EQ(now.fault, Cause::none);
  EXPECT_NEAR(now.velocity, 100, 1e-9);
  EXPECT_NEAR(now.master, 0.1 * static_cast<double>(slave.count), 1e-9) << "no phase shift";
}

// Shifts that follow each other at random, on a gear and on a cam: no setpoint exceeds a limit.
TEST(Phasing, StaysWithinTheLimitsOfTheAxis) {
  const Limits most = limits(600, 2e4, 2e6);
  for (const bool curved : {false, true}) {
    LiveGear gear(1, {.numerator = 3, .denominator = 2, .acceleration = 1e4, .jerk = 1e6});
    LiveCam cam(2, pmc600_cam(), {.start = StartMode::absolute});
    Slave slave(curved ? static_cast<Movement&>(cam) : gear, 150, most);
    std::uint32_t seed = 7;
    const auto random = [&] {
      seed = seed * 1664525U + 1013904223U;
      return static_cast<double>(seed >> 8U) / static_cast<double>(1U << 24U);
    };
    slave.follow_for(300);
    Tick last = slave.follow();
    int accepted = 0;
    for (int k = 0; k < 60000; ++k) {
      Command command;
      if (k % 97 == 0) command.what = command::PhasingRelative{60 * random() - 30};
      const Tick now = slave.follow(command);
      accepted += k % 97 == 0 && !now.refused;
      ASSERT_EQ(now.fault, Cause::none) << k;
      ASSERT_LE(std::abs(now.velocity), 600 * (1 + 1e-9)) << k;
      ASSERT_LE(std::abs(now.acceleration), 2e4 * (1 + 1e-9)) << k;
      if (!curved) {
        ASSERT_LE(std::abs(now.acceleration - last.acceleration), 2e3 * (1 + 1e-6)) << k;
      }
      ASSERT_NEAR(now.position - last.position, (now.velocity + last.velocity) / 2 * 1e-3,
                  2e4 * 1e-6)
          << k;
      last = now;
    }
    EXPECT_GT(accepted, 100);
  }
}

}  // namespace
}  // namespace jounce::phasing_test
