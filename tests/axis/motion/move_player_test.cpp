// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/move_player.hpp"

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::move_player_test {
namespace {

using namespace test;

AxisConfig config() {
  AxisConfig config{.limits = limits(100, 1000, 1e5)};
  config.limits.position_max = 50;
  return resolved(config);
}

Goal to(double position, double velocity = 50) {
  MoveDynamics dynamics{.velocity = velocity};
  EXPECT_FALSE(fill(dynamics, config()));
  return {Goal::Kind::position, position, dynamics};
}

TEST(MovePlayer, ReachesItsTargetAndStaysThere) {
  MovePlayer player(1'000'000);
  ASSERT_TRUE(player.begin({{0, 0, 0}, 100}, to(20), 1, config()));
  EXPECT_EQ(player.goal().value, 20);
  EXPECT_FALSE(player.passes());
  EXPECT_EQ(player.at(100), (Jet{0, 0, 0, 1e5}));
  // 0.4 s at 50 u/s, and a ramp of 0.05 s plus 0.01 s of jerk.
  EXPECT_FALSE(player.is_over(559));
  EXPECT_TRUE(player.is_over(561));
  EXPECT_NEAR(player.beyond(600), 0.040, 1e-9);
  EXPECT_NEAR(player.at(10'000)[0], 20, 1e-12);
  EXPECT_EQ(player.at(10'000)[1], 0);
}

TEST(MovePlayer, ContinuesAtItsLastVelocity) {
  MovePlayer player(1'000'000);
  Goal goal = to(0);
  goal.kind = Goal::Kind::velocity;
  goal.value = 30;
  ASSERT_TRUE(player.begin({{0, 0, 0}, 0}, goal, 1, config()));
  ASSERT_TRUE(player.is_over(100));
  EXPECT_EQ(player.at(200)[1], 30);
  EXPECT_NEAR(player.at(300)[0] - player.at(200)[0], 3, 1e-12);
}

TEST(MovePlayer, AMoveThatIsNoneChangesNothing) {
  MovePlayer player(1'000'000);
  ASSERT_TRUE(player.begin({{0, 0, 0}, 0}, to(20), 1, config()));
  const Jet before = player.at(150);
  // At 99 u/s and 1e-12 u/s^2 to rest: the plan exceeds the precision of a double.
  Goal none = to(1e9);
  none.dynamics.deceleration = 1e-12;
  EXPECT_FALSE(player.begin({{0, 99, 0}, 150}, none, 1, config()));
  EXPECT_EQ(player.goal().value, 20);
  EXPECT_EQ(player.at(150), before);
}

TEST(MovePlayer, BeginsLateByWhatIsOver) {
  MovePlayer player(1'000'000), late(1'000'000);
  ASSERT_TRUE(player.begin({{0, 0, 0}, 0}, to(20), 1, config()));
  ASSERT_TRUE(late.begin({{0, 0, 0}, 3}, to(20), 1, config(), 0.003));
  EXPECT_NEAR(late.at(200)[0], player.at(200)[0], 1e-12);
}

TEST(MovePlayer, PausesWithItsOwnDynamicsAndKeepsItsGoal) {
  MovePlayer player(1'000'000);
  Goal goal = to(40);
  goal.dynamics.deceleration = 100;
  ASSERT_TRUE(player.begin({{0, 0, 0}, 0}, goal, 1, config()));
  const Jet now = player.at(200);
  ASSERT_TRUE(player.pause({{now[0], now[1], now[2]}, 200}, player.goal(), config()));
  EXPECT_EQ(player.goal().value, 40);
  EXPECT_NEAR(player.at(400)[1], now[1] - 100 * 0.2, 0.2) << "100 u/s^2, less the jerk";
  EXPECT_EQ(player.at(5000)[1], 0);
  EXPECT_LT(player.at(5000)[0], 40);
}

TEST(MovePlayer, ItsPeaksHoldForEveryFactorUpToThatOne) {
  MovePlayer player(1'000'000);
  ASSERT_TRUE(player.begin({{0, 0, 0}, 0}, to(20), 1, config()));
  EXPECT_EQ(player.peaks_up_to(0.5).velocity, 50);
  EXPECT_EQ(player.peaks_up_to(1.5).velocity, 75);
  EXPECT_EQ(player.peaks_up_to(1).acceleration, 1000);
  EXPECT_EQ(player.peaks_up_to(1).jerk, 1e5);
  ASSERT_TRUE(player.begin({{0, 90, 0}, 0}, to(20), 1, config()));
  EXPECT_EQ(player.peaks_up_to(1).velocity, 90) << "that of its start";
}

}  // namespace
}  // namespace jounce::move_player_test
