// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_clutch.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/live_gear.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/follow/live.hpp"
#include "axis/tables.hpp"

namespace jounce::live_clutch_test {
namespace {

using namespace test;

/// The master of Googol's example 7-5: a jog with 100 pulse/ms and 1 pulse/ms^2, in s.
Jet jog(double t) {
  constexpr double v = 1e5;
  constexpr double a = 1e6;
  if (t < v / a) return {a * t * t / 2, a * t, a, 0};
  return {v * (t - v / a / 2), v, 0, 0};
}

// Googol manual, example 7-5: ratio 1/2 over 100000 pulses.
TEST(LiveClutch, PlaysExample75) {
  LiveClutch clutch(1, 0.5, 1e5);
  Follower slave{clutch, jog};
  ASSERT_EQ(slave.begin({}), Cause::none);
  EXPECT_NEAR(slave.run(1050).slave[0], 25000, 1e-6) << "the clutch ends at 1050 ms";
  EXPECT_NEAR(slave.now().slave[1], 50e3, 1e-6);
  EXPECT_NEAR(slave.run(1000).slave[0], 75000, 1e-6);
  EXPECT_EQ(clutch.progress(), Progress::running);
}

// Position, velocity, acceleration and jerk belong together: central differences.
TEST(LiveClutch, DerivativesAreThoseOfThePosition) {
  LiveClutch clutch(1, -1.5, 3);
  const double h = 1e-4;
  Follower slave{clutch, [](double t) { return Jet{t * t * t, 3 * t * t, 6 * t, 6}; }, h};
  ASSERT_EQ(slave.begin({7, 0, 0}), Cause::none);
  Jet a = slave.now().slave;
  Jet b = slave.step().slave;
  for (int k = 2; k < 14000; ++k) {
    const Jet c = slave.step().slave;
    for (std::size_t n = 1; n < 4; ++n)
      ASSERT_NEAR((c[n - 1] - a[n - 1]) / (2 * h), b[n], 2e-3) << k << ' ' << n;
    a = b;
    b = c;
  }
}

TEST(LiveClutch, MovesBackAlongTheSameCurve) {
  LiveClutch clutch(1, 2, 10);
  double x = 0;
  Follower slave{clutch, [&](double) { return Jet{x, 0, 0, 0}; }};
  ASSERT_EQ(slave.begin({1, 0, 0}), Cause::none);
  x = 5;
  const double half = slave.step().slave[0];
  x = 9;
  slave.step();
  x = 5;
  EXPECT_DOUBLE_EQ(slave.step().slave[0], half);
  x = -5;
  EXPECT_DOUBLE_EQ(slave.step().slave[0], 2 - half) << "engages in the other direction";
  x = 12;
  EXPECT_DOUBLE_EQ(slave.step().slave[0], 1 + 10 + 2 * 2);
  x = 0;
  EXPECT_DOUBLE_EQ(slave.step().slave[0], 1 + 10 - 20) << "the new ratio is permanent";
}

/// Steps an axis that follows a master at constant velocity.
struct Slave : Bench {
  explicit Slave(const Limits& limits) : Bench({.limits = limits}) {}
  Tick follow(const Command& command = {}) {
    return step(command, at_master(1e3 * static_cast<double>(tick + 1) * 1e-3, 1e3));
  }
};

TEST(LiveClutch, ChangesTheRatioOfAGearInMotion) {
  Slave slave(limits(3000, 1e5));
  slave.follow({command::Enable{}});
  LiveClutch first(1, 0.5, 200);
  EXPECT_EQ(refusal(slave.follow({command::Couple{.movement = &first}})), Cause::none);
  for (int k = 0; k < 300; ++k) slave.follow();
  LiveClutch second(2, 2, 100);
  const double before = slave.follow().position;
  EXPECT_EQ(refusal(slave.follow({command::Couple{.movement = &second}})), Cause::none);
  Tick now;
  for (int k = 1; k <= 100; ++k) now = slave.follow();
  EXPECT_NEAR(now.position, before + 0.5 + 100 * (0.5 + 2) / 2, 1e-9);
  EXPECT_NEAR(slave.follow().velocity, 2000, 1e-9);
  LiveClutch tight(3, 0, 1);
  const Tick refused = slave.follow({command::Couple{.movement = &tight}});
  EXPECT_EQ(refusal(refused), Cause::acceleration_limit);
  EXPECT_DOUBLE_EQ(refused.refused->value, 15.0 / 8 * 2 * 1e6);
  LiveClutch fast(4, 3.1, 500);
  EXPECT_EQ(refusal(slave.follow({command::Couple{.movement = &fast}})), Cause::velocity_limit);
  slave.follow({command::MoveVelocity{.velocity = 1000}});
  LiveClutch from_a_jog(5, 1, 500);
  EXPECT_EQ(refusal(slave.follow({command::Couple{.movement = &from_a_jog}})), Cause::in_motion);
}

TEST(LiveClutch, RejectsDistances) {
  for (const double distance : {0.0, -1.0, 1e51, double(NAN), HUGE_VAL})
    EXPECT_THROW(LiveClutch(1, 1, distance), InputError);
}

}  // namespace
}  // namespace jounce::live_clutch_test
