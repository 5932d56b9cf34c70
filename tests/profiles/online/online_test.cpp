// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/online/online.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "executor/hooks.hpp"
#include "support/random.hpp"

namespace jounce::online_test {
namespace {

constexpr double cycle = 1e-3;

template <std::size_t N>
OnlineGenerator<N> axes_with(const Bounds& bounds, Sync sync = Sync::none) {
  OnlineGenerator<N> g(sync);
  for (std::size_t i = 0; i < N; ++i) EXPECT_EQ(g.set_bounds(i, bounds), MoveStatus::ok);
  return g;
}

/// Steps until all have arrived: how many it took, or -1 after 60 s.
template <std::size_t N>
int steps_to_arrival(OnlineGenerator<N>& g) {
  for (int k = 1; k < 60000; ++k)
    if (g.step(cycle).arrived) return k;
  return -1;
}

template <std::size_t N>
void run(OnlineGenerator<N>& g, double seconds) {
  for (int k = 0; k < static_cast<int>(std::lround(seconds / cycle)); ++k) (void)g.step(cycle);
}

TEST(Online, MovesLikeMoveTo) {
  auto g = axes_with<1>(within(2, 10, 100));
  g.set_target(0, {.position = 1});
  const Profile plan = move_to({}, {1, 0, 0}, within(2, 10, 100)).profile;
  for (int k = 1; k < 900; ++k) {
    const OnlineStep s = g.step(cycle);
    EXPECT_EQ(s.planned, k == 1);
    EXPECT_EQ(s.arrived, k * cycle >= plan.duration());
    EXPECT_NEAR(g[0].position, plan.at(k * cycle).position, 1e-12);
    EXPECT_NEAR(g[0].velocity, plan.at(k * cycle).velocity, 1e-12);
    EXPECT_NEAR(g.remaining(), std::max(0.0, plan.duration() - k * cycle), 1e-12);
  }
  EXPECT_EQ(g[0].position, 1);
}

TEST(Online, RestsUntilItHasATarget) {
  auto g = axes_with<2>(within(2, 10, 100));
  g.set_state(1, {3, 1, 0});
  EXPECT_FALSE(g.step(cycle).arrived);
  EXPECT_GT(steps_to_arrival(g), 0);
  EXPECT_EQ(g[0].position, 0);
  EXPECT_EQ(g[1].velocity, 0);
  EXPECT_NEAR(g[1].position, stop({3, 1, 0}, within(2, 10, 100)).profile.end().position, 1e-12);
}

TEST(Online, NothingMovesWithoutBounds) {
  OnlineGenerator<1> g;
  EXPECT_TRUE(g.step(cycle).arrived);
  g.set_target(0, {.position = 1});
  const OnlineStep s = g.step(cycle);
  EXPECT_FALSE(s.arrived);
  EXPECT_EQ(s.status, MoveStatus::invalid_bounds);
  EXPECT_EQ(g[0].position, 0);
}

TEST(Online, ContinuesAtTheVelocityOfItsTarget) {
  auto g = axes_with<1>(within(2, 10, 100));
  g.set_target(0, {1, 0.5, 0});
  const double t = move_to({}, {1, 0.5, 0}, within(2, 10, 100)).profile.duration();
  const int k = steps_to_arrival(g);
  EXPECT_EQ(k, static_cast<int>(std::ceil(t / cycle)));
  run(g, 1);
  EXPECT_NEAR(g[0].position, 1 + 0.5 * ((k + 1000) * cycle - t), 1e-12);
  g.set_target(0, {1, 0.5, 0});  // repeated in every cycle
  EXPECT_FALSE(g.step(cycle).planned);
  g.set_bounds(0, within(3, 20, 200));  // it does not go back for it
  (void)g.step(cycle);
  EXPECT_EQ(g[0].velocity, 0.5);
  EXPECT_TRUE(g.step(cycle).arrived);
}

TEST(Online, ReleasesTheAccelerationOfItsTarget) {
  auto g = axes_with<1>(within(2, 10, 100));
  g.set_target(0, {1, 0.5, -3});
  ASSERT_GT(steps_to_arrival(g), 0);
  for (int k = 0; k < 2000; ++k) {
    EXPECT_TRUE(g.step(cycle).arrived);
    EXPECT_LE(std::abs(g[0].acceleration), 10 + 1e-12);
  }
  EXPECT_EQ(g[0].velocity, 0.5);
  EXPECT_EQ(g[0].acceleration, 0);
}

TEST(Online, MeetsATargetThatMovesAndStaysWithIt) {
  auto g = axes_with<1>(within(2, 10, 100));
  int planned = 0;
  for (int k = 0; k < 3000; ++k) {
    g.set_target(0, {1 + 0.3 * k * cycle, 0.3, 0}, MoveGoal::moving);
    planned += g.step(cycle).planned ? 1 : 0;
  }
  EXPECT_EQ(planned, 1);
  EXPECT_NEAR(g[0].position, 1 + 0.3 * 3000 * cycle, 1e-12);
  run(g, 1);  // set or not
  EXPECT_NEAR(g[0].position, 1 + 0.3 * 4000 * cycle, 1e-12);
}

TEST(Online, KeepsItsMotionWhileTheTargetIsWithinTheTolerance) {
  auto g = axes_with<1>(within(2, 10, 100));
  g.set_tolerance(0, 1e-3);
  test::Random random(1);
  int planned = 0;
  for (int k = 0; k < 1500; ++k) {
    g.set_target(0, {.position = 1 + random.uniform(-0.5e-3, 0.5e-3)});
    planned += g.step(cycle).planned ? 1 : 0;
  }
  EXPECT_EQ(planned, 1);
  EXPECT_NEAR(g[0].position, 1, 0.5e-3);
  g.set_target(0, {.position = 1.01});
  EXPECT_TRUE(g.step(cycle).planned);
  ASSERT_GT(steps_to_arrival(g), 0);
  EXPECT_EQ(g[0].position, 1.01);
}

TEST(Online, VelocityControl) {
  auto g = axes_with<3>(within(2, 10, 100), Sync::time);
  g.set_velocity(0, 1.5);
  g.set_velocity(1, -0.5);
  g.set_velocity(2, 9);  // the limit
  const double longest = move_velocity({}, 2, within(2, 10, 100)).profile.duration();
  EXPECT_NEAR(steps_to_arrival(g) * cycle, longest, cycle);
  EXPECT_EQ(g[0].velocity, 1.5);
  EXPECT_EQ(g[1].velocity, -0.5);
  EXPECT_EQ(g[2].velocity, 2);
  g.set_bounds(2, within(4, 10, 100));
  EXPECT_GT(steps_to_arrival(g), 0);
  EXPECT_EQ(g[2].velocity, 4);
  EXPECT_EQ(g[0].velocity, 1.5);
}

TEST(Online, ATargetThatIsSetAgainMakesNoOtherAxisLate) {
  auto g = axes_with<2>(within(2, 10, 100), Sync::time);
  g.set_target(1, {1, 0.4, 0.3});
  const double t = move_to({}, {1, 0.4, 0.3}, within(2, 10, 100)).profile.duration();
  int k = 0;
  for (; k < 5000 && g[1].position < 1; ++k) {
    if (k < 400) g.set_target(0, {.position = 0.2 + 1e-6 * k});  // could be there long before
    (void)g.step(cycle);
  }
  EXPECT_NEAR(k * cycle, t, 2 * cycle);
}

TEST(Online, DurationsOnTheGridEndWithACycle) {
  auto g = axes_with<2>(within(2, 10, 100), Sync::time);
  g.set_grid(cycle);
  g.set_target(0, {.position = 1});
  g.set_target(1, {.position = 0.123});
  const double t = move_to({}, {1, 0, 0}, within(2, 10, 100)).profile.duration();
  const int k = steps_to_arrival(g);
  EXPECT_EQ(k, static_cast<int>(std::ceil(t / cycle)));
  g = axes_with<2>(within(2, 10, 100), Sync::time);
  g.set_grid(cycle);
  g.set_target(0, {.position = 1});
  (void)g.step(0);
  EXPECT_NEAR(g.remaining(), k * cycle, 1e-12);
}

TEST(Online, AnAxisThatIsNotEnabledStopsAndTheOthersDoNotWait) {
  auto g = axes_with<2>(within(2, 10, 100), Sync::time);
  g.set_target(0, {.position = 1});
  g.set_target(1, {.position = 5});
  run(g, 0.3);
  g.set_enabled(1, false);
  const MotionState at{g[1].position, g[1].velocity, g[1].acceleration};
  const double stopped = stop(at, within(2, 10, 100)).profile.end().position;
  const double t = 0.3 + move_to({g[0].position, g[0].velocity, g[0].acceleration}, {1, 0, 0},
                                 within(2, 10, 100))
                             .profile.duration();
  EXPECT_NEAR(steps_to_arrival(g) * cycle + 0.3, t, 2 * cycle);
  run(g, 1);
  EXPECT_NEAR(g[1].position, stopped, 1e-12);
  EXPECT_EQ(g[1].velocity, 0);
  g.set_state(1, {7, 0, 0});  // something else has moved it
  EXPECT_EQ(g[1].position, 7);
  g.set_enabled(1, true);
  EXPECT_GT(steps_to_arrival(g), 0);
  EXPECT_EQ(g[1].position, 5);
}

TEST(Online, AVelocityLimitOfZeroHoldsTheAxis) {
  for (const Bounds& zero : {within(0, 10, 100), within(2, 0, 100), within(2, 10, 0)}) {
    auto g = axes_with<1>(within(2, 10, 100));
    g.set_target(0, {.position = 3});
    run(g, 0.7);
    const MotionState at{g[0].position, g[0].velocity, g[0].acceleration};
    EXPECT_EQ(g.set_bounds(0, zero), MoveStatus::ok);
    for (int k = 0; k < 3000; ++k) {
      EXPECT_FALSE(g.step(cycle).arrived);
      EXPECT_GE(g[0].velocity, 0);
      EXPECT_GE(g[0].acceleration, -10 - 1e-12);
    }
    EXPECT_EQ(g[0].velocity, 0);
    EXPECT_NEAR(g[0].position, stop(at, within(2, 10, 100)).profile.end().position, 1e-12);
    g.set_target(0, {.position = 4});
    run(g, 0.1);
    EXPECT_EQ(g[0].velocity, 0);
    g.set_bounds(0, within(1, 10, 100));
    EXPECT_GT(steps_to_arrival(g), 0);
    EXPECT_EQ(g[0].position, 4);
  }
}

TEST(Online, AVelocityLimitOfZeroForbidsOneDirection) {
  auto g = axes_with<1>(within(2, 10, 100));
  g.set_target(0, {.position = 3});
  run(g, 0.7);
  Bounds backwards = within(2, 10, 100);
  backwards.velocity_max = 0;
  g.set_bounds(0, backwards);
  g.set_target(0, {.position = -1});
  double highest = g[0].velocity;
  for (int k = 0; k < 5000 && !g.step(cycle).arrived; ++k) highest = g[0].velocity;
  EXPECT_EQ(g[0].position, -1);
  EXPECT_LE(highest, 0);
  g.set_target(0, {.position = 1});
  const OnlineStep s = g.step(cycle);
  EXPECT_EQ(s.status, MoveStatus::target_outside);
  run(g, 1);
  EXPECT_EQ(g[0].position, -1);
  g.set_bounds(0, within(2, 10, 100));
  EXPECT_GT(steps_to_arrival(g), 0);
  EXPECT_EQ(g[0].position, 1);
}

TEST(Online, StopsBeforeAPositionLimitThatItsVelocityLeadsTo) {
  Bounds b = within(2, 10, 100);
  b.position_max = 1.5;
  for (const double dt : {1e-4, 1e-3, 5e-3}) {
    auto g = axes_with<1>(b);
    g.set_velocity(0, 1.9);
    OnlineStep s;
    for (int k = 0; k < 3 / dt; ++k) {
      s = g.step(dt);
      EXPECT_LE(g[0].position, 1.5);
    }
    EXPECT_EQ(s.status, MoveStatus::position_limit);
    EXPECT_EQ(g[0].velocity, 0);
    EXPECT_GT(g[0].position, 1.5 - 2 * 1.9 * dt);
    g.set_velocity(0, -1);
    EXPECT_EQ(g.step(dt).status, MoveStatus::ok);
    EXPECT_LT(g[0].velocity, 0);
  }
}

TEST(Online, ATargetThatCannotBeReachedLeavesTheMotionUnderWay) {
  auto g = axes_with<2>(within(2, 10, 100), Sync::time);
  g.set_target(0, {.position = 3});
  g.set_target(1, {.position = 2});
  run(g, 0.3);
  g.set_target(0, {3, 2.5, 0});
  const OnlineStep s = g.step(cycle);
  EXPECT_EQ(s.status, MoveStatus::target_outside);
  EXPECT_EQ(s.axis, 0U);
  run(g, 5);
  EXPECT_EQ(g[0].position, 3);
  EXPECT_EQ(g[1].position, 2);
  EXPECT_EQ(g.status(0), MoveStatus::target_outside);
  g.set_target(0, {.position = 3});
  EXPECT_TRUE(g.step(cycle).arrived);
}

TEST(Online, StopsWhereALoweredLimitForbidsTheVelocityOfTheTarget) {
  auto g = axes_with<1>(within(2, 10, 100));
  g.set_target(0, {3, 1.5, 0});
  run(g, 0.5);
  g.set_bounds(0, within(1, 10, 100));
  const OnlineStep s = g.step(cycle);
  EXPECT_EQ(s.status, MoveStatus::target_outside);
  run(g, 2);
  EXPECT_EQ(g[0].velocity, 0);
  g.set_bounds(0, within(2, 10, 100));
  EXPECT_GT(steps_to_arrival(g), 0);
  EXPECT_EQ(g[0].velocity, 1.5);
}

TEST(Online, InPhaseAllStopOnTheLineWhereOneIsHeld) {
  auto g = axes_with<2>(within(2, 10, 100), Sync::phase);
  g.set_target(0, {.position = 3});
  g.set_target(1, {.position = -1});
  run(g, 0.5);
  g.set_bounds(1, within(0, 10, 100));
  EXPECT_EQ(g.step(cycle).status, MoveStatus::not_straight);
  for (int k = 0; k < 1000; ++k) {
    (void)g.step(cycle);
    EXPECT_NEAR(g[1].position, -g[0].position / 3, 1e-12);
  }
  EXPECT_EQ(g[0].velocity, 0);
  g.set_bounds(1, within(2, 10, 100));
  EXPECT_GT(steps_to_arrival(g), 0);
  EXPECT_EQ(g[0].position, 3);
}

TEST(Online, ATargetOffTheLineStopsNothingThatKeepsItsBounds) {
  auto g = axes_with<2>(within(2, 10, 100), Sync::phase);
  g.set_target(0, {.position = 3});
  g.set_target(1, {.position = -1});
  run(g, 0.5);
  g.set_target(1, {.position = -2});
  EXPECT_EQ(g.step(cycle).status, MoveStatus::not_straight);
  run(g, 3);
  EXPECT_EQ(g[0].position, 3);
  EXPECT_EQ(g[1].position, -1);
  g.set_sync(Sync::phase_or_time);
  g.set_target(1, {.position = -2});
  run(g, 3);
  EXPECT_EQ(g[1].position, -2);
}

TEST(Online, RejectsContradictions) {
  auto g = axes_with<1>(within(2, 10, 100));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  g.set_target(0, {.position = 1});
  EXPECT_EQ(g.set_target(0, {.position = nan}), MoveStatus::not_finite);
  EXPECT_EQ(g.set_velocity(0, Bounds::none), MoveStatus::not_finite);
  EXPECT_EQ(g.set_state(0, {0, nan, 0}), MoveStatus::not_finite);
  EXPECT_EQ(g.set_bounds(0, within(-1, 10, 100)), MoveStatus::invalid_bounds);
  EXPECT_EQ(g.set_bounds(0, within(nan, 10, 100)), MoveStatus::invalid_bounds);
  EXPECT_EQ(g.step(nan).status, MoveStatus::not_finite);
  EXPECT_EQ(g.step(-1).status, MoveStatus::not_finite);
  EXPECT_EQ(g.step(cycle).status, MoveStatus::ok);
  EXPECT_GT(steps_to_arrival(g), 0);
  EXPECT_EQ(g[0].position, 1);
}

TEST(Online, IsAValue) {
  auto g = axes_with<2>(within(2, 10, 100), Sync::time);
  g.set_target(0, {.position = 3});
  g.set_target(1, {.position = -1});
  run(g, 0.2);
  auto copy = g;
  g.set_target(0, {.position = -9});
  EXPECT_GT(steps_to_arrival(copy), 0);
  EXPECT_EQ(copy[0].position, 3);
  EXPECT_EQ(copy[1].position, -1);
}

TEST(Online, TakesNothingFromTheHeap) {
  test::Random random(9);
  auto g = axes_with<4>(within(2, 10, 100), Sync::time);
  const test::Noise before = test::noise();
  for (int k = 0; k < 4000; ++k) {
    const auto i = static_cast<std::size_t>(random.below(4));
    if (k % 50 == 0) g.set_target(i, {random.uniform(-3, 3), random.uniform(-1, 1), 0});
    if (k % 70 == 0) g.set_velocity(i, random.uniform(-1, 1));
    if (k % 90 == 0) g.set_bounds(i, within(random.uniform(0, 3), random.uniform(1, 9), 100));
    if (k % 110 == 0) g.set_enabled(i, random.below(2) == 0);
    if (k % 300 == 0) g.set_sync(static_cast<Sync>(random.below(5)));
    if (k % 400 == 0) g.set_grid(random.below(2) * cycle);
    (void)g.step(cycle);
  }
  EXPECT_EQ(test::noise(), before);
}

}  // namespace
}  // namespace jounce::online_test
