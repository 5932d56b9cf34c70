// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/move_goal.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::move_goal_test {
namespace {

using namespace test;

AxisConfig config() {
  AxisConfig config{.limits = limits(100, 1000, 1e5)};
  config.limits.position_min = -50;
  config.limits.position_max = 50;
  config.limit_acceleration = 500;
  return resolved(config);
}

const AxisConfig axis = config();
const MotionState at_ten{10, 0, 0};

struct Answer {
  Cause cause = Cause::none;
  Goal goal;
};

template <class Move>
Answer goal(const Move& move, const MoveRules& rules = {axis}, const MotionState& from = at_ten) {
  Answer answer;
  const auto no = goal_of(move, from, rules, answer.goal);
  if (no) answer.cause = no->cause;
  return answer;
}

TEST(MoveGoal, IsAPositionADistanceOrAVelocity) {
  EXPECT_EQ(goal(command::MoveAbsolute{.position = 30}).goal.value, 30);
  EXPECT_EQ(goal(command::MoveRelative{.distance = 30}).goal.value, 40);
  const Answer moves = goal(command::MoveVelocity{.velocity = -20});
  EXPECT_EQ(moves.goal.kind, Goal::Kind::velocity);
  EXPECT_EQ(moves.goal.value, -20);
  EXPECT_EQ(moves.goal.dynamics.velocity, 20);
  EXPECT_EQ(moves.goal.dynamics.acceleration, 1000) << "that of the axis";
  Goal additive;
  EXPECT_FALSE(goal_of(command::MoveAdditive{.distance = 5}, 30, at_ten, {axis}, additive));
  EXPECT_EQ(additive.value, 35);
}

TEST(MoveGoal, IsInsideTheRange) {
  EXPECT_EQ(goal(command::MoveAbsolute{.position = 50}).cause, Cause::none);
  EXPECT_EQ(goal(command::MoveAbsolute{.position = 51}).cause, Cause::position_limit);
  EXPECT_EQ(goal(command::MoveRelative{.distance = -61}).cause, Cause::position_limit);
  Goal additive;
  EXPECT_EQ(goal_of(command::MoveAdditive{.distance = 25}, 30, at_ten, {axis}, additive)->cause,
            Cause::position_limit);
  EXPECT_EQ(goal(command::MoveVelocity{.velocity = 1}, {axis}, {50, 0, 0}).cause,
            Cause::position_limit);
  EXPECT_EQ(goal(command::MoveVelocity{.velocity = -1}, {axis}, {50, 0, 0}).cause, Cause::none);
}

TEST(MoveGoal, DoesNotLeadTowardsAnActiveLimitSwitch) {
  const MoveRules blocked{.config = axis, .positive_switch = true};
  EXPECT_EQ(goal(command::MoveAbsolute{.position = 11}, blocked).cause, Cause::direction_blocked);
  EXPECT_EQ(goal(command::MoveAbsolute{.position = 9}, blocked).cause, Cause::none);
  EXPECT_EQ(goal(command::MoveRelative{.distance = 1}, blocked).cause, Cause::direction_blocked);
  EXPECT_EQ(goal(command::MoveVelocity{.velocity = 1}, blocked).cause, Cause::direction_blocked);
  EXPECT_EQ(goal(command::MoveVelocity{.velocity = -1}, blocked).cause, Cause::none);
}

TEST(MoveGoal, HasFiniteNumbersWithinTheLimits) {
  EXPECT_EQ(goal(command::MoveAbsolute{.position = NAN}).cause, Cause::no_value);
  EXPECT_EQ(goal(command::MoveRelative{.distance = INFINITY}).cause, Cause::no_value);
  EXPECT_EQ(goal(command::MoveVelocity{.velocity = NAN}).cause, Cause::no_value);
  EXPECT_EQ(goal(command::MoveVelocity{.velocity = 101}).cause, Cause::velocity_limit);
  EXPECT_EQ(goal(command::MoveAbsolute{.position = 20, .dynamics = {.acceleration = 1001}}).cause,
            Cause::acceleration_limit);
}

TEST(MoveGoal, WaitingMovesEndAtTheTargetOfTheLast) {
  WaitingMoves moves;
  EXPECT_EQ(end_of(moves, at_ten, {axis})->position, 10);
  moves.push(command::MoveRelative{.distance = 5});
  moves.push(command::MoveAbsolute{.position = -20});
  moves.push(command::MoveRelative{.distance = -5});
  EXPECT_EQ(end_of(moves, at_ten, {axis})->position, -25);
  EXPECT_FALSE(end_of(moves, std::nullopt, {axis}));
  moves.push(command::MoveVelocity{.velocity = 5});
  EXPECT_FALSE(end_of(moves, at_ten, {axis})) << "it has no target";
}

TEST(StopAtLimit, EndsAtTheEndOfTheRangeWithTheGentlestStopThatIsLeft) {
  // v^2 / (2 a) of the two stops, and half a jerk ramp each.
  const auto soft = stop_at_limit(Cause::positive_soft_limit, {50 - 5.2, 70, 0}, 1e-3, axis);
  ASSERT_TRUE(soft);
  EXPECT_EQ(soft->kind, Goal::Kind::position);
  EXPECT_EQ(soft->value, 50);
  EXPECT_EQ(soft->dynamics.deceleration, 500);
  const auto hard = stop_at_limit(Cause::negative_soft_limit, {-50 + 1.6, -70, 0}, 1e-3, axis);
  ASSERT_TRUE(hard);
  EXPECT_EQ(hard->value, -50);
  EXPECT_EQ(hard->dynamics.deceleration, axis.stop_acceleration);
}

TEST(StopAtLimit, IsNoneOutsideOrOnAWayThatEndsElsewhere) {
  EXPECT_FALSE(stop_at_limit(Cause::positive_soft_limit, {51, 1, 0}, 1e-3, axis));
  EXPECT_FALSE(stop_at_limit(Cause::positive_soft_limit, {0, 70, 0}, 1e-3, axis));
  EXPECT_FALSE(stop_at_limit(Cause::positive_soft_limit, {49, 100, 0}, 1e-3, axis));
}

}  // namespace
}  // namespace jounce::move_goal_test
