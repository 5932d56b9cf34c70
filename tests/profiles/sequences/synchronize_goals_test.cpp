// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/sequences/synchronize.hpp"

#include "support/random.hpp"

namespace jounce::synchronize_goals_test {
namespace {

MotionState random_state(test::Random& random) {
  return {random.uniform(-3, 3), random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9)};
}

/// Bounds that every random state keeps, together with what its acceleration leads to.
Bounds random_bounds(test::Random& random) {
  return within(random.uniform(2, 6), random.uniform(1, 6), random.uniform(1, 20));
}

void expect_kept(const Profile& profile, const Bounds& b, double rounding) {
  const double t = profile.duration();
  for (int n = 0; n <= 64; ++n) {
    const Motion m = profile.at(t * n / 64);
    EXPECT_LE(std::abs(m.velocity), b.velocity_max + rounding);
    EXPECT_LE(std::abs(m.acceleration), b.acceleration_max + rounding);
    EXPECT_LE(std::abs(m.jerk), b.jerk_max + rounding);
  }
}

void expect_end(const Profile& profile, const MotionState& end, double rounding) {
  // The half measured from the start must meet the half measured from the end.
  const double half = profile.duration() / 2;
  const Motion a = profile.at(half * (1 - 1e-12));
  const Motion b = profile.at(half * (1 + 1e-12));
  EXPECT_NEAR(a.position, b.position, rounding);
  EXPECT_NEAR(a.velocity, b.velocity, rounding);
  EXPECT_NEAR(profile.end().position, end.position, rounding);
  EXPECT_NEAR(profile.end().velocity, end.velocity, rounding);
  EXPECT_NEAR(profile.end().acceleration, end.acceleration, rounding);
}

TEST(SynchronizeGoals, AVelocityAloneIsReachedAsFastAsByMoveVelocity) {
  test::Random random(51);
  for (int i = 0; i < 5000 && !::testing::Test::HasFailure(); ++i) {
    AxisMove axis{random_state(random), random_state(random), random_bounds(random)};
    axis.goal = MoveGoal::velocity;
    Profile out;
    ASSERT_EQ(synchronize({&axis, 1}, Sync::none, {&out, 1}).status, MoveStatus::ok) << i;
    const MoveResult alone =
        move_velocity(axis.from, axis.to.velocity, axis.bounds, axis.to.acceleration);
    EXPECT_NEAR(out.duration(), alone.profile.duration(), 1e-9) << i;
    expect_end(out, alone.profile.end(), 1e-9);
    expect_kept(out, axis.bounds, 1e-9);
  }
}

TEST(SynchronizeGoals, VelocitiesAreReachedTogether) {
  test::Random random(52);
  for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i) {
    std::array<AxisMove, 4> axes;
    double longest = 0;
    for (auto& axis : axes) {
      axis = {random_state(random), random_state(random), random_bounds(random)};
      axis.from.acceleration = axis.to.acceleration = 0;  // no blocked durations
      axis.goal = MoveGoal::velocity;
      longest = std::max(
          longest, move_velocity(axis.from, axis.to.velocity, axis.bounds).profile.duration());
    }
    std::array<Profile, 4> out;
    const Synchronized s = synchronize(axes, Sync::time, out);
    ASSERT_EQ(s.status, MoveStatus::ok);
    EXPECT_NEAR(s.duration, longest, 1e-9);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      EXPECT_NEAR(out[k].duration(), s.duration, 1e-12 * s.duration);
      EXPECT_NEAR(out[k].end().velocity, axes[k].to.velocity, 1e-12);
      expect_end(out[k], out[k].end(), 1e-9);
      expect_kept(out[k], axes[k].bounds, 1e-9);
    }
  }
}

TEST(SynchronizeGoals, VelocitiesInPhaseChangeOnALine) {
  test::Random random(53);
  for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i) {
    std::array<AxisMove, 3> axes;
    for (auto& axis : axes) {
      axis = {random_state(random), random_state(random), random_bounds(random)};
      axis.from.acceleration = axis.to.acceleration = 0;
      axis.goal = MoveGoal::velocity;
    }
    std::array<Profile, 3> out;
    const Synchronized s = synchronize(axes, Sync::phase, out);
    ASSERT_EQ(s.status, MoveStatus::ok);
    for (int n = 0; n <= 20; ++n) {
      const auto share = [&](std::size_t k) {
        return (out[k].at(s.duration * n / 20).velocity - axes[k].from.velocity) /
               (axes[k].to.velocity - axes[k].from.velocity);
      };
      EXPECT_NEAR(share(1), share(0), 1e-9);
      EXPECT_NEAR(share(2), share(0), 1e-9);
    }
    for (std::size_t k = 0; k < 3; ++k) expect_kept(out[k], axes[k].bounds, 1e-9);
  }
}

TEST(SynchronizeGoals, AnOrderWithoutAccelerationLimitsStepsToItsVelocity) {
  AxisMove axis{{1, 0, 0}, {0, 0.5, 0}, within(2), MoveGoal::velocity};
  Profile out;
  ASSERT_EQ(synchronize({&axis, 1}, Sync::time, {&out, 1}, 2).status, MoveStatus::ok);
  EXPECT_EQ(out.duration(), 2);
  EXPECT_EQ(out.at(1).position, 1.5);
  axis.bounds = within(2, 4);
  ASSERT_EQ(synchronize({&axis, 1}, Sync::time, {&out, 1}).status, MoveStatus::ok);
  EXPECT_EQ(out.duration(), 0.125);
  EXPECT_EQ(out.at(0.0625).velocity, 0.25);
}

/// True if a motion to the target's position after t can last exactly t; computed without its
/// coordinates.
bool can_meet(const AxisMove& axis, double t) {
  MotionState there = axis.to;
  there.position += t * there.velocity;
  return durations(axis.from, there, axis.bounds).allows(t);
}

TEST(SynchronizeGoals, AMovingTargetIsMetAsSoonAsItCanBe) {
  test::Random random(54);
  for (int i = 0; i < 2000 && !::testing::Test::HasFailure(); ++i) {
    AxisMove axis{random_state(random), random_state(random), random_bounds(random)};
    axis.to.acceleration = 0;
    axis.goal = MoveGoal::moving;
    Profile out;
    const Synchronized s = synchronize({&axis, 1}, Sync::none, {&out, 1});
    ASSERT_EQ(s.status, MoveStatus::ok) << i;
    expect_kept(out, axis.bounds, 1e-9);
    const double t = s.duration;
    expect_end(out, {axis.to.position + t * axis.to.velocity, axis.to.velocity, 0}, 1e-9);
    EXPECT_TRUE(can_meet(axis, t * (1 + 1e-9)) || can_meet(axis, t * (1 - 1e-9))) << i;
    for (int n = 1; n < 200; ++n) EXPECT_FALSE(can_meet(axis, t * (n / 200.0 - 1e-6))) << i;
  }
}

TEST(SynchronizeGoals, MovingTargetsInEveryOrder) {
  for (const Bounds& b : {within(3), within(3, 10), within(3, 10, 100)}) {
    const AxisMove axis{{0, 0, 0}, {2, 1, 0}, b, MoveGoal::moving};
    Profile out;
    const Synchronized s = synchronize({&axis, 1}, Sync::none, {&out, 1});
    ASSERT_EQ(s.status, MoveStatus::ok);
    EXPECT_NEAR(out.end().position, 2 + s.duration, 1e-12);
    EXPECT_NEAR(out.at(s.duration / 2 * (1 - 1e-9)).position,
                out.at(s.duration / 2 * (1 + 1e-9)).position, 1e-6);
  }
  const AxisMove axis{{0, 0, 0}, {2, 1, 0}, within(3), MoveGoal::moving};
  Profile out;
  EXPECT_EQ(synchronize({&axis, 1}, Sync::none, {&out, 1}).duration, 1);  // 3 t = 2 + t
}

TEST(SynchronizeGoals, ATargetAsFastAsTheLimitCannotBeMet) {
  const AxisMove axis{{0, 0, 0}, {2, 3, 0}, within(3, 10, 100), MoveGoal::moving};
  Profile out;
  EXPECT_EQ(synchronize({&axis, 1}, Sync::none, {&out, 1}).status, MoveStatus::target_outside);
}

TEST(SynchronizeGoals, AMeetingBeyondThePositionLimitIsNone) {
  AxisMove axis{{0, 0, 0}, {2, 1, 0}, within(3, 10, 100), MoveGoal::moving};
  axis.bounds.position_max = 2.5;
  Profile out;
  EXPECT_EQ(synchronize({&axis, 1}, Sync::none, {&out, 1}).status, MoveStatus::position_limit);
}

TEST(SynchronizeGoals, DurationsLieOnTheGrid) {
  test::Random random(55);
  for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i) {
    std::array<AxisMove, 3> axes;
    for (auto& axis : axes)
      axis = {random_state(random), random_state(random), random_bounds(random)};
    std::array<Profile, 3> out;
    const double grid = random.log_uniform(1e-3, 0.5);
    for (const Sync sync : {Sync::none, Sync::time, Sync::time_if_moving}) {
      const Synchronized s = synchronize(axes, sync, out, 0, grid);
      ASSERT_EQ(s.status, MoveStatus::ok);
      for (std::size_t k = 0; k < 3; ++k) {
        const double cycles = out[k].duration() / grid;
        EXPECT_NEAR(cycles, std::round(cycles), 1e-9 * cycles) << i;
        EXPECT_EQ(out[k].end().position, axes[k].to.position);
        EXPECT_GE(out[k].duration(),
                  durations(axes[k].from, axes[k].to, axes[k].bounds).minimum * (1 - 1e-11));
      }
      if (sync != Sync::time) continue;
      bool all = true;  // one multiple earlier one of them cannot
      for (const auto& axis : axes)
        all = all && durations(axis.from, axis.to, axis.bounds).allows(s.duration - grid);
      EXPECT_FALSE(all) << i;
    }
  }
}

// The direct change takes 0.014 s less a rounding: nothing may be made of what is left of the grid.
TEST(SynchronizeGoals, ARoundingLeftOfTheGridIsNoTimeToSpend) {
  Bounds b = within(0.10461243843757903, 0.568791, 6.9417815389749462);
  b.jerk_max = 9.0267280871433329;
  const AxisMove axis{{0, 0.1039321438467595, 0.097184941545648745},
                      {0, 0.10461243843757903, 0},
                      b,
                      MoveGoal::velocity};
  Profile out;
  ASSERT_EQ(synchronize({&axis, 1}, Sync::time, {&out, 1}, 0, 0.002).status, MoveStatus::ok);
  EXPECT_NEAR(out.duration(), 0.014, 1e-12);
  expect_end(out, out.end(), 1e-12);
}

TEST(SynchronizeGoals, OnlyMovingTargetsWaitForEachOtherWhereThatIsAskedFor) {
  test::Random random(56);
  for (int i = 0; i < 2000 && !::testing::Test::HasFailure(); ++i) {
    std::array<AxisMove, 4> axes;
    for (auto& axis : axes)
      axis = {random_state(random), random_state(random), random_bounds(random)};
    axes[1].to.velocity = axes[1].to.acceleration = 0;
    axes[3].to.velocity = axes[3].to.acceleration = 0;
    std::array<Profile, 4> out;
    const Synchronized s = synchronize(axes, Sync::time_if_moving, out);
    ASSERT_EQ(s.status, MoveStatus::ok);
    for (std::size_t k = 0; k < 4; ++k) {
      const double least = durations(axes[k].from, axes[k].to, axes[k].bounds).minimum;
      EXPECT_NEAR(out[k].duration(), k % 2 == 0 ? s.duration : least, 1e-9);
      EXPECT_GE(s.duration, least * (1 - 1e-12));
    }
  }
}

TEST(SynchronizeGoals, WhereAllTargetsRestTheDurationIsThatOfTheSlowestAxis) {
  const Bounds bounds = within(1, 2, 10);
  const std::array<AxisMove, 2> axes{AxisMove{{0, 0, 0}, {1, 0, 0}, bounds},
                                     AxisMove{{0, 0, 0}, {3, 0, 0}, bounds}};
  std::array<Profile, 2> out;
  const Synchronized s = synchronize(axes, Sync::time_if_moving, out, 60);
  ASSERT_EQ(s.status, MoveStatus::ok);
  EXPECT_EQ(s.duration, out[1].duration()) << "not the minimum of 60 s, which no axis has";
  EXPECT_LT(out[0].duration(), out[1].duration());
  EXPECT_LT(out[1].duration(), 60);
}

TEST(SynchronizeGoals, InPhaseWhereTheStatesAllowItOtherwiseInTime) {
  std::array<AxisMove, 2> axes{AxisMove{{0, 0, 0}, {1, 0, 0}, within(1, 1, 1)},
                               AxisMove{{0, 0, 0}, {-2, 0, 0}, within(1, 1, 1)}};
  std::array<Profile, 2> out, other;
  EXPECT_EQ(synchronize(axes, Sync::phase_or_time, out).duration,
            synchronize(axes, Sync::phase, other).duration);
  EXPECT_NEAR(out[1].at(0.7).position, -2 * out[0].at(0.7).position, 1e-14);
  axes[0].from.velocity = 0.3;
  EXPECT_EQ(synchronize(axes, Sync::phase, other).status, MoveStatus::not_straight);
  const double t = synchronize(axes, Sync::phase_or_time, out).duration;
  EXPECT_EQ(t, synchronize(axes, Sync::time, other).duration);
  EXPECT_NEAR(out[0].duration(), t, 1e-12);
}

TEST(SynchronizeGoals, GoalsOfTwoKindsHaveNoCommonLine) {
  std::array<AxisMove, 2> axes{AxisMove{{0, 0, 0}, {1, 0, 0}, within(1, 1, 1)},
                               AxisMove{{0, 0, 0}, {0, 1, 0}, within(1, 1, 1), MoveGoal::velocity}};
  std::array<Profile, 2> out;
  EXPECT_EQ(synchronize(axes, Sync::phase, out).status, MoveStatus::not_straight);
  EXPECT_EQ(synchronize(axes, Sync::time, out).status, MoveStatus::ok);
  EXPECT_NEAR(out[0].duration(), out[1].duration(), 1e-12);
}

TEST(SynchronizeGoals, AnAxisThatIsNotEnabledTakesNoPart) {
  std::array<AxisMove, 3> axes{AxisMove{{0, 0.1, 0}, {1, 0, 0}, within(1, 1, 1)},
                               AxisMove{{7, 3, 0}, {900, 0, 0}, Bounds{}},
                               AxisMove{{0, 0.2, 0}, {2, 0, 0}, within(1, 1, 1)}};
  axes[1].enabled = false;
  const std::array<AxisMove, 2> two{axes[0], axes[2]};
  for (const Sync sync : {Sync::none, Sync::time, Sync::time_if_moving, Sync::phase}) {
    std::array<Profile, 3> out;
    std::array<Profile, 2> expected;
    const Synchronized s = synchronize(axes, sync, out);
    ASSERT_EQ(s.status, MoveStatus::ok);
    EXPECT_EQ(s.duration, synchronize(two, sync, expected).duration);
    EXPECT_EQ(out[0].duration(), expected[0].duration());
    EXPECT_EQ(out[2].duration(), expected[1].duration());
    EXPECT_EQ(out[1].duration(), 0);
    EXPECT_EQ(out[1].end().position, 7);
  }
}

// A target that moves is met on a knife's edge: rounding may make the state a hair late for it, and the
// next possibility is far away. The motion under way still gets there.
TEST(SynchronizeGoals, AMotionUnderWayIsNotLost) {
  test::Random random(57);
  int lost = 0;
  for (int i = 0; i < 2000; ++i) {
    const MotionState to = random_state(random);
    const Bounds b = random_bounds(random);
    const Profile plan = move_to(random_state(random), to, b).profile;
    const Profile rest = plan.after(plan.duration() * random.uniform(0.1, 0.99));
    AxisMove axis{rest.start(), to, b};
    axis.to.position += 1e-9 * random.uniform(-1, 1);
    Profile out;
    (void)synchronize({&axis, 1}, Sync::time, {&out, 1});
    if (out.duration() > rest.duration() * 1.001) ++lost;
    axis.under_way = &rest;
    EXPECT_LE(synchronize({&axis, 1}, Sync::time, {&out, 1}).duration, rest.duration());
  }
  EXPECT_GT(lost, 50);  // there is something to lose
}

TEST(ProfileAfter, IsTheRestOfTheMotion) {
  test::Random random(58);
  for (int i = 0; i < 2000 && !::testing::Test::HasFailure(); ++i) {
    const Profile plan =
        move_to(random_state(random), random_state(random), random_bounds(random)).profile;
    const double t = plan.duration();
    const double cut = random.uniform(-0.1, 1.1) * t;
    const Profile rest = plan.after(cut);
    const double begun = std::min(std::max(cut, 0.0), t);
    EXPECT_NEAR(rest.duration(), t - begun, 1e-12 * t);
    for (int n = 0; n <= 20; ++n) {
      const double u = (t - begun) * n / 20;
      EXPECT_NEAR(rest.at(u).position, plan.at(begun + u).position, 1e-10);
      EXPECT_NEAR(rest.at(u).velocity, plan.at(begun + u).velocity, 1e-10);
    }
    EXPECT_EQ(rest.end(), plan.end());
  }
}

}  // namespace
}  // namespace jounce::synchronize_goals_test
