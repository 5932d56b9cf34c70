// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/himc/himc.hpp"

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "controllers/motion.hpp"
#include "support/random.hpp"

namespace jounce::himc {
namespace {

const AxisProfile example{.velocity = 100, .acceleration = 500, .smoothing_time = 50};

double first_ramp(const Profile& p) {
  return p.phase(0).duration + p.phase(1).duration + p.phase(2).duration;
}

TEST(HimcProfile, TheManualsRampTakesTwoHundredAndFiftyMilliseconds) {
  const Profile p = move_abs(0, 1000, example);
  EXPECT_DOUBLE_EQ(first_ramp(p), 0.25);
  EXPECT_DOUBLE_EQ(p.at(0).jerk, 10000);
  EXPECT_DOUBLE_EQ(p.duration(), 10 + 0.25);  // h/v + T
}

TEST(HimcProfile, WithoutSmoothingIsATrapezoid) {
  AxisProfile axis = example;
  axis.smoothing_time = 0;
  const Profile p = move_abs(0, 1000, axis);
  EXPECT_EQ(p.order(), 2);
  EXPECT_DOUBLE_EQ(p.duration(), 10.2);
}

TEST(HimcProfile, TakesTheRampsAsTimes) {
  // 100 mm/s in 200 ms is 500 mm/s^2; the smoothing comes on top: T = Ta + Ts.
  AxisProfile axis = example;
  axis.acceleration = 0;
  axis.acceleration_time = 200;
  axis.deceleration_time = 400;
  const Dynamics d = dynamics(axis);
  EXPECT_DOUBLE_EQ(d.acceleration, 500);
  EXPECT_DOUBLE_EQ(d.deceleration, 250);
  EXPECT_DOUBLE_EQ(first_ramp(move_abs(0, 1000, axis)), 0.25);
  EXPECT_DOUBLE_EQ(move_abs(0, 1000, axis).duration(), 10 + (0.25 + 0.45) / 2);
}

TEST(HimcProfile, VelocityScaleLeavesTheAccelerationsAlone) {
  AxisProfile axis = example;
  axis.velocity_scale = 50;
  axis.acceleration = 0;
  axis.acceleration_time = 200;
  const Dynamics d = dynamics(axis);
  EXPECT_DOUBLE_EQ(d.velocity, 50);
  EXPECT_DOUBLE_EQ(d.acceleration, 500);
}

TEST(HimcProfile, RejectsAsTheManual) {
  const auto refused = [](auto change) {
    AxisProfile bad = example;
    change(bad);
    EXPECT_THROW(dynamics(bad), InputError);
  };
  refused([](AxisProfile& a) { a.smoothing_time = -1; });
  refused([](AxisProfile& a) { a.smoothing_time = 501; });
  refused([](AxisProfile& a) { a.velocity = 0; });
  refused([](AxisProfile& a) { a.acceleration = 0; });
  refused([](AxisProfile& a) { a.acceleration_time = 100; });
  refused([](AxisProfile& a) { a.deceleration = a.deceleration_time = 100; });
  refused([](AxisProfile& a) { a.velocity_scale = 0; });
  refused([](AxisProfile& a) { a.velocity_scale = 101; });
  AxisProfile edge = example;
  edge.smoothing_time = 500;
  edge.velocity_scale = 100;
  EXPECT_NO_THROW(dynamics(edge));
}

TEST(HimcProfile, EveryRampTakesItsTrapezoidsTimePlusTheSmoothing) {
  test::Random random(41);
  for (int i = 0; i < 500; ++i) {
    AxisProfile axis{.velocity = random.log_uniform(1, 1000)};
    axis.acceleration_time = random.uniform(50, 500);
    axis.deceleration_time = random.uniform(50, 500);
    axis.smoothing_time = random.uniform(1, 50);  // not above Ta: the acceleration is reached
    const double h = 2 * axis.velocity;
    const double ramps =
        (axis.acceleration_time + axis.deceleration_time) / 2 + axis.smoothing_time;
    EXPECT_NEAR(move_abs(0, h, axis).duration(), 2 + ramps * 1e-3, 1e-12) << i;
  }
}

TEST(HimcMoveVel, ReachesTheVelocityInItsDirection) {
  const Profile p = move_vel({5, 0, 0}, -1, example);
  EXPECT_DOUBLE_EQ(p.duration(), 0.25);
  EXPECT_EQ(p.end().velocity, -100);
  EXPECT_DOUBLE_EQ(p.end().position, 5 - 12.5);
  EXPECT_THROW(move_vel({}, 0, example), InputError);
  AxisProfile slower = example;
  slower.velocity = 50;
  const Trajectory f = move_vel(p.curve(), 1, -1, slower);
  EXPECT_DOUBLE_EQ(f.end(), 1 + 0.1 + 0.05);
  EXPECT_DOUBLE_EQ(state_at(f, 2).velocity, -50);
}

TEST(HimcMoveAbs, TakesANewTargetAndVelocityWhileMoving) {
  AxisProfile axis = example;
  const Trajectory f = move_abs(0, 1000, axis).curve();
  axis.velocity = 60;
  const Trajectory g = move_abs(f, 3, 800, axis);
  EXPECT_NEAR(g.at(g.end()).position, 800, 1e-12);
  EXPECT_NEAR(g.at(8).velocity, 60, 1e-12);
  test::expect_invariants(g, 2);
  test::expect_within(g, 100, 500, 10000);
}

TEST(HimcMoveAbs, GivenAgainIsTheSameMove) {
  const AxisProfile axis{
      .velocity = 100, .acceleration = 1000, .deceleration = 250, .smoothing_time = 50};
  const Trajectory f = move_abs(0, 200, axis).curve();
  EXPECT_NEAR(f.end(), 2.3, 1e-12);
  for (const double t : {0.02, 0.07, 0.12, 1.0, 1.88, 2.0, 2.28})
    EXPECT_NEAR(move_abs(f, t, 200, axis).end(), 2.3, 1e-6) << t;
}

TEST(HimcStop, BringsTheAxisToRestSmoothly) {
  const Trajectory f = stop(move_abs(0, 1000, example).curve(), 0.1, example);
  EXPECT_NEAR(state_at(f, f.end()).velocity, 0, 1e-12);
  test::expect_invariants(f, 2);
  test::expect_within(f, 100, 500, 10000);
}

}  // namespace
}  // namespace jounce::himc
