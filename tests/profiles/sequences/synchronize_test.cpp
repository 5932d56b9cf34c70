// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/synchronize.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/moves/s_curve.hpp"

#include "support/random.hpp"

namespace jounce::synchronize_test {
namespace {

MotionState random_state(test::Random& random) {
  return {random.uniform(-3, 3), random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9)};
}

TEST(Synchronize, InTimeAllArriveTogetherAtTheEarliestInstantForAll) {
  test::Random random(41);
  for (int i = 0; i < 5000; ++i) {
    std::vector<AxisMove> axes(static_cast<std::size_t>(1 + random.below(6)));
    for (auto& axis : axes)
      axis = {random_state(random), random_state(random),
              within(random.uniform(2, 6), random.uniform(1, 6), random.uniform(1, 20))};
    std::vector<Profile> out(axes.size());
    const Synchronized s = synchronize(axes, Sync::time, out);
    ASSERT_EQ(s.status, MoveStatus::ok) << i;
    double earliest = 0;
    for (const auto& axis : axes)
      earliest = std::max(earliest, durations(axis.from, axis.to, axis.bounds).minimum);
    EXPECT_GE(s.duration, earliest * (1 - 1e-12));
    for (std::size_t k = 0; k < axes.size(); ++k) {
      EXPECT_NEAR(out[k].duration(), s.duration, 1e-12 * s.duration);
      const Motion end = out[k].at(s.duration * (1 + 1e-12));
      EXPECT_EQ(end.position, axes[k].to.position);
    }
    // No earlier instant suits every axis: just below, one of them cannot.
    bool all = true;
    for (const auto& axis : axes)
      all = all && durations(axis.from, axis.to, axis.bounds).allows(s.duration * (1 - 1e-9));
    EXPECT_FALSE(all) << i;
    if (HasFailure()) break;
  }
}

/// The greatest error of a profile's end, integrated phase by phase, and by how much a phase's end exceeds a bound.
struct Walk {
  double end = 0;     ///< relative to the distance
  double excess = 0;  ///< relative to the bound
};
Walk walk(const Profile& profile, const Bounds& b) {
  Walk worst;
  MotionState s = profile.start();
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const auto [t, j] = profile.phase(i);
    s = {s.position + t * (s.velocity + t * (s.acceleration / 2 + t * j / 6)),
         s.velocity + t * (s.acceleration + t * j / 2), s.acceleration + t * j};
    worst.excess =
        std::max({worst.excess, std::abs(s.velocity) / b.velocity_max - 1,
                  std::abs(s.acceleration) / b.acceleration_max - 1, std::abs(j) / b.jerk_max - 1});
  }
  const double distance = profile.end().position - profile.start().position;
  worst.end = std::abs(s.position - profile.end().position) / std::abs(distance);
  return worst;
}

TEST(Synchronize, FromRestToRestAllLastAsLongAsTheSlowest) {
  test::Random random(47);
  for (int i = 0; i < 5000; ++i) {
    std::vector<AxisMove> axes(static_cast<std::size_t>(1 + random.below(20)));
    double slowest = 0;
    for (auto& axis : axes) {
      const double v = random.log_uniform(1e-2, 1e2);
      const double a = random.log_uniform(1e-2, 1e2);
      const double j = random.log_uniform(1e-2, 1e2);
      const double d = random.log_uniform(1e-3, 1e3);
      axis = {{0}, {random.below(2) == 0 ? d : -d}, within(v, a, j)};
      slowest = std::max(
          slowest, s_curve({.to = d, .velocity = v, .acceleration = a, .jerk = j}).duration());
    }
    const double least = random.below(2) * random.log_uniform(1e-1, 1e2);
    const double grid = random.below(2) * 0.25;
    std::vector<Profile> out(axes.size());
    const Synchronized s = synchronize(axes, Sync::time, out, least, grid);
    ASSERT_EQ(s.status, MoveStatus::ok) << i;
    EXPECT_GE(s.duration, std::max(slowest, least) * (1 - 1e-12)) << i;
    EXPECT_LE(s.duration, std::max(slowest, least) * (1 + 1e-12) + grid) << i;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      EXPECT_NEAR(out[k].duration(), s.duration, 1e-12 * s.duration) << i << " axis " << k;
      const Walk walked = walk(out[k], axes[k].bounds);
      EXPECT_LE(walked.end, 1e-12) << i << " axis " << k;
      EXPECT_LE(walked.excess, 1e-12) << i << " axis " << k;
    }
    if (HasFailure()) break;
  }
}

/// A state, a rest, a second order, a velocity, or an axis that takes no part.
AxisMove random_axis(test::Random& random) {
  AxisMove axis{random_state(random), random_state(random),
                within(random.uniform(2, 6), random.uniform(1, 6), random.uniform(1, 20))};
  const auto kind = random.below(8);
  if (kind < 2) axis.from = {axis.from.position};
  if (kind < 2) axis.to = {axis.to.position};
  if (kind == 2) axis.bounds = within(4, 3);
  if (kind == 3) axis.goal = MoveGoal::velocity;
  axis.enabled = kind != 4;
  return axis;
}

TEST(Synchronize, TheOrderOfTheAxesDecidesNothing) {
  test::Random random(43);
  for (int i = 0; i < 2000; ++i) {
    std::vector<AxisMove> axes(static_cast<std::size_t>(1 + random.below(24)));
    for (auto& axis : axes) axis = random_axis(random);
    const double minimum = random.below(2) * random.uniform(0, 8);
    const double grid = random.below(2) * 0.25;
    std::vector<Profile> out(axes.size());
    const Synchronized s = synchronize(axes, Sync::time, out, minimum, grid);
    ASSERT_EQ(s.status, MoveStatus::ok) << i;
    EXPECT_GE(s.duration, minimum * (1 - 1e-12));
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const double duration = axes[k].enabled ? s.duration : 0;
      EXPECT_NEAR(out[k].duration(), duration, 1e-12 * s.duration) << i << " axis " << k;
    }
    std::reverse(axes.begin(), axes.end());
    const Synchronized backwards = synchronize(axes, Sync::time, out, minimum, grid);
    EXPECT_NEAR(backwards.duration, s.duration, 1e-12 * s.duration) << i;
    if (HasFailure()) break;
  }
}

TEST(Synchronize, InPhaseStaysOnTheLine) {
  test::Random random(42);
  for (int i = 0; i < 5000; ++i) {
    std::vector<AxisMove> axes(static_cast<std::size_t>(2 + random.below(5)));
    const double v0 = random.uniform(-0.2, 0.2);
    const double a0 = random.uniform(-0.2, 0.2);
    const double vf = random.uniform(-0.2, 0.2);
    for (auto& axis : axes) {
      const double d = random.uniform(-3, 3);
      const double from = random.uniform(-3, 3);
      axis = {{from, v0 * d, a0 * d},
              {from + d, vf * d, 0},
              within(random.uniform(2, 6), random.uniform(2, 6), random.uniform(5, 20))};
    }
    std::vector<Profile> out(axes.size());
    const double least = i % 3 == 0 ? 20 : 0;
    const Synchronized s = synchronize(axes, Sync::phase, out, least);
    ASSERT_EQ(s.status, MoveStatus::ok) << i << explain(s.status);
    EXPECT_GE(s.duration, least * (1 - 1e-14));
    for (int n = 0; n <= 50; ++n) {
      const double t = s.duration * n / 50;
      const double share = (out[0].at(t).position - axes[0].from.position) /
                           (axes[0].to.position - axes[0].from.position);
      for (std::size_t k = 1; k < axes.size(); ++k) {
        const double d = axes[k].to.position - axes[k].from.position;
        EXPECT_NEAR(out[k].at(t).position, axes[k].from.position + share * d, 1e-11);
        EXPECT_LE(std::abs(out[k].at(t).velocity), axes[k].bounds.velocity_max * (1 + 1e-12));
        EXPECT_LE(std::abs(out[k].at(t).acceleration),
                  axes[k].bounds.acceleration_max * (1 + 1e-12));
      }
    }
    if (HasFailure()) break;
  }
}

TEST(Synchronize, InPhaseIsReplannedOnItsOwnLine) {
  test::Random random(43);
  for (int i = 0; i < 5000; ++i) {
    const double offset = i % 2 == 0 ? 0 : 1e4;
    std::vector<AxisMove> axes(2);
    for (auto& axis : axes)
      axis = {{offset + random.uniform(0, 1000), 0, 0},
              {offset + random.uniform(0, 1000), 0, 0},
              within(2, 10, 100)};
    std::vector<Profile> out(2);
    const double t = synchronize(axes, Sync::phase, out).duration * random.uniform(0.001, 0.99);
    for (std::size_t k = 0; k < 2; ++k) {
      const Motion m = out[k].at(t);
      axes[k].from = {m.position, m.velocity, m.acceleration};
    }
    EXPECT_EQ(synchronize(axes, Sync::phase, out).status, MoveStatus::ok) << i << " at " << t;
    if (HasFailure()) break;
  }
}

TEST(Synchronize, RejectsAnEndlessDuration) {
  std::vector<AxisMove> axes{{{}, {1, 0, 0}, within(1, 1, 1)}};
  std::vector<Profile> out(1);
  for (const Sync sync : {Sync::none, Sync::time, Sync::phase})
    EXPECT_EQ(synchronize(axes, sync, out, Bounds::none).status, MoveStatus::not_finite);
}

TEST(Synchronize, NeverBendsAPathThatShouldBeStraight) {
  std::vector<AxisMove> axes{{{0, 0.1, 0}, {1, 0, 0}, within(1, 1, 1)},
                             {{0, 0.2, 0}, {1, 0, 0}, within(1, 1, 1)}};
  std::vector<Profile> out(2);
  const Synchronized s = synchronize(axes, Sync::phase, out);
  EXPECT_EQ(s.status, MoveStatus::not_straight);
  EXPECT_EQ(s.axis, 1U);
}

TEST(Synchronize, UnsynchronizedEachIsAsFastAsItCan) {
  std::vector<AxisMove> axes{{{}, {1, 0, 0}, within(1, 1, 1)}, {{}, {9, 0, 0}, within(1, 1, 1)}};
  std::vector<Profile> out(2);
  const Synchronized s = synchronize(axes, Sync::none, out);
  EXPECT_EQ(out[0].duration(), move_to({}, {1, 0, 0}, within(1, 1, 1)).profile.duration());
  EXPECT_EQ(s.duration, out[1].duration());
}

TEST(Synchronize, NamesTheAxisThatCannot) {
  std::vector<AxisMove> axes{{{}, {1, 0, 0}, within(1, 1, 1)}, {{}, {1, 2, 0}, within(1, 1, 1)}};
  std::vector<Profile> out(2);
  for (const Sync sync : {Sync::none, Sync::time, Sync::phase}) {
    const Synchronized s = synchronize(axes, sync, out);
    EXPECT_EQ(s.status, MoveStatus::target_outside);
    EXPECT_EQ(s.axis, 1U);
  }
}

TEST(Synchronize, RejectsAWrongNumberOfProfiles) {
  std::vector<AxisMove> axes{{{}, {1, 0, 0}, within(1, 1, 1)}, {{}, {9, 0, 0}, within(1, 1, 1)}};
  std::vector<Profile> out(3, Profile({7, 0, 0}, 3));
  for (const Sync sync : {Sync::none, Sync::time, Sync::phase, Sync::phase_or_time})
    for (const std::size_t size : {0U, 1U, 3U}) {
      EXPECT_EQ(synchronize(axes, sync, std::span(out).first(size)).status, MoveStatus::wrong_size);
      for (const Profile& profile : out) EXPECT_EQ(profile.start().position, 7);
    }
}

}  // namespace
}  // namespace jounce::synchronize_test
