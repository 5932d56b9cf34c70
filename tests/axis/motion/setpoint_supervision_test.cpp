// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/setpoint_supervision.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::setpoint_supervision_test {
namespace {

using namespace test;

/// 100 u/s, 1000 u/s^2; a stop has twice that. 0 to 100 u.
AxisConfig config() {
  AxisConfig config{.limits = limits(100, 1000)};
  config.limits.position_min = 0;
  config.limits.position_max = 100;
  return resolved(config);
}

constexpr SupervisedMotion from_50{.last = {50, 10, 0}, .dt = 1e-3};

TEST(SetpointSupervision, ANextSetpointWithinTheLimitsPasses) {
  EXPECT_EQ(supervise({50.01, 10.5, 500}, from_50, config()), Cause::none);
}

TEST(SetpointSupervision, NamesTheNumberThatExceedsALimit) {
  const AxisConfig axis = config();
  const MotionState far{51, 10, 0};  // 1000 u/s
  EXPECT_EQ(supervise(far, from_50, axis), Cause::overspeed);
  EXPECT_DOUBLE_EQ(excess(Cause::overspeed, far, from_50, axis), 1000);
  const MotionState kinked{50.01, 14, 0};  // 4000 u/s^2
  EXPECT_EQ(supervise(kinked, from_50, axis), Cause::jump);
  EXPECT_DOUBLE_EQ(excess(Cause::jump, kinked, from_50, axis), 4000);
  EXPECT_TRUE(std::isnan(excess(Cause::out_of_range, kinked, from_50, axis)));
}

TEST(SetpointSupervision, AJointOfTwoMotionsMayHaveOneStep) {
  const MotionState next{50.01, 10 + 2.9, 0};  // the stop limit permits 2, the joint 1 more
  EXPECT_EQ(supervise(next, from_50, config()), Cause::jump);
  SupervisedMotion joined = from_50;
  joined.joined = true;
  EXPECT_EQ(supervise(next, joined, config()), Cause::none);
}

TEST(SetpointSupervision, OnlyAMotionThatWasNotCheckedAsAWholeIsComparedWithItsRange) {
  SupervisedMotion motion{.last = {99.9, 20, 0}, .dt = 1e-3};  // a stop takes 0.1 u
  const MotionState next{99.92, 20, 0};
  EXPECT_EQ(supervise(next, motion, config()), Cause::positive_soft_limit);
  motion.bounded = true;
  EXPECT_EQ(supervise(next, motion, config()), Cause::none);
  motion.bounded = false;
  motion.stops_in_fault = true;
  EXPECT_EQ(supervise(next, motion, config()), Cause::none);
}

TEST(SetpointSupervision, OnlyAFollowerInStepIsHeldToItsAcceleration) {
  SupervisedMotion motion = from_50;
  const MotionState next{50.01, 11.5, 1500};
  EXPECT_EQ(supervise(next, motion, config()), Cause::none);
  motion.in_step = true;
  EXPECT_EQ(supervise(next, motion, config()), Cause::overacceleration);
  EXPECT_EQ(excess(Cause::overacceleration, next, motion, config()), 1500);
}

TEST(SetpointSupervision, AnActiveLimitSwitchStopsItsDirectionButNotAHoming) {
  SupervisedMotion motion = from_50;
  motion.positive_switch = true;
  EXPECT_EQ(supervise({50.01, 10, 0}, motion, config()), Cause::positive_switch);
  motion.last.velocity = -10;
  EXPECT_EQ(supervise({49.99, -10, 0}, motion, config()), Cause::none);
  motion.last.velocity = 10;
  motion.searches = true;
  EXPECT_EQ(supervise({50.01, 10, 0}, motion, config()), Cause::none);
}

}  // namespace
}  // namespace jounce::setpoint_supervision_test
