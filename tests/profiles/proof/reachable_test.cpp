// SPDX-License-Identifier: Apache-2.0
// The witness against closed forms, and against motions made at random.
#include "profiles/proof/reachable.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "profiles/proof/draw.hpp"

namespace jounce::proof {
namespace {

double least(const MotionState& from, const MotionState& to, const Bounds& b,
             const Slack& slack = {}) {
  return static_cast<double>(reachable(from, to, b, slack).front().from);
}

TEST(Reachable, RestToRestAgreesWithTheClosedForms) {
  // Jerk alone: T = (32 d / j)^(1/3).
  EXPECT_DOUBLE_EQ(least({}, {1, 0, 0}, within(10, 10, 1)), std::cbrt(32));
  EXPECT_DOUBLE_EQ(least({}, {-1, 0, 0}, within(10, 10, 1)), std::cbrt(32));
  // All seven phases: T = d/v + v/a + a/j.
  EXPECT_DOUBLE_EQ(least({}, {10, 0, 0}, within(2, 1, 1)), 10.0 / 2 + 2 + 1);
  // No velocity limit reached: T = a/j + sqrt((a/j)^2 + 4 d/a).
  EXPECT_DOUBLE_EQ(least({}, {3, 0, 0}, within(100, 1, 1)), 1 + std::sqrt(1 + 12.0));
  // Order 2: triangle and trapezoid; order 1.
  EXPECT_DOUBLE_EQ(least({}, {1, 0, 0}, within(10, 1)), 2);
  EXPECT_DOUBLE_EQ(least({}, {10, 0, 0}, within(2, 1)), 5 + 2);
  EXPECT_DOUBLE_EQ(least({}, {10, 0, 0}, within(2)), 5);
}

TEST(Reachable, AStartOutsideAgreesWithTheClosedForms) {
  // Velocity 2 where 1 is allowed, all limits 1: the level return takes 2 s and 3 u, the stop 2 s from
  // there, the stop at once 1 + 1 + 1 s and 3 u.
  const Bounds b = within(1, 1, 1);
  const Slack last{0x1p-60L, 0x1p-60L, 0x1p-60L};
  EXPECT_NEAR(least({0, 2, 0}, {3, 1, 0}, b, last), 2, 1e-9);
  EXPECT_DOUBLE_EQ(least({0, 2, 0}, {14, 0, 0}, b), 2 + 10 + 2);
  EXPECT_NEAR(least({0, 2, 0}, {3, 0, 0}, b, last), 3, 1e-8);
  const auto level = reachable_velocity({0, 3, 0}, 2, 0, within(2, 10, 100));
  EXPECT_DOUBLE_EQ(static_cast<double>(level.front().from), 0.2);
  // Braking with 2 where 1 is allowed, on to where it stops if it goes on.
  EXPECT_NEAR(least({0, 4, -2}, {13.0 / 3, 0, 0}, within(9, 1, 1), {1e-15L, 0, 0}), 3, 1e-6);
}

TEST(Reachable, AMovingTargetHasABlockedInterval) {
  // Order 2, from and to velocity 1, one unit apart, acceleration 1: straight in 1 s. Slower only
  // with a detour: least T on the way down and up again until the velocity 1 - T/2 loses too much,
  // T - T^2/4 <= 1 always holds up to T = 2, so everything is possible ...
  const std::vector<Span> all = reachable({0, 1, 0}, {1, 1, 0}, within(1, 1));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_DOUBLE_EQ(static_cast<double>(all[0].from), 1);
  // ... but a quarter unit is possible in 1/4 s and until T - T^2/4 = 1/4, then again from there on
  // the other branch: T = 2 -+ sqrt(3).
  const std::vector<Span> gap = reachable({0, 1, 0}, {0.25, 1, 0}, within(1, 1));
  ASSERT_EQ(gap.size(), 2U);
  EXPECT_DOUBLE_EQ(static_cast<double>(gap[0].from), 0.25);
  EXPECT_DOUBLE_EQ(static_cast<double>(gap[0].to), 2 - std::sqrt(3));
  EXPECT_DOUBLE_EQ(static_cast<double>(gap[1].from), 2 + std::sqrt(3));
  EXPECT_TRUE(std::isinf(gap[1].to));
}

TEST(Reachable, IsolatedTiesAreFoundWithTheSlackOfTheLastBit) {
  // profiles.md: p 1 to -2, v 0 to 0, a 1 to 1, all limits 2: the exact answer is 4.
  const Slack last{0x1p-60L, 0x1p-60L, 0x1p-60L};
  const std::vector<Span> T = reachable({1, 0, 1}, {-2, 0, 1}, within(2, 2, 2), last);
  EXPECT_NEAR(static_cast<double>(T.front().from), 4, 1e-9);
}

/// Random jerks within random bounds make a motion; the witness must call its duration possible.
TEST(Reachable, EveryMotionThatKeepsTheBoundsIsPossible) {
  Random r(20);
  int narrow = 0;
  for (int i = 0; i < 20000; ++i) {
    const int n = 1 + r.below(6);
    long double p = 0;
    long double v = r.uniform(-1, 1);
    long double a = r.uniform(-1, 1);
    const MotionState from{0, static_cast<double>(v), static_cast<double>(a)};
    long double T = 0;
    Bounds b = within(std::abs(from.velocity), std::abs(from.acceleration), 0);
    for (int k = 0; k < n; ++k) {
      const double t = r.uniform(0, 1);
      const double j = r.below(4) == 0 ? 0.0 : r.uniform(-2, 2);
      if (j != 0 && a / -j > 0 && a / -j < t)  // the velocity's extremum
        (a > 0 ? b.velocity_max : b.velocity_min) =
            a > 0 ? std::max(b.velocity_max, static_cast<double>(v - a * a / (2 * j)))
                  : std::min(b.velocity_min, static_cast<double>(v - a * a / (2 * j)));
      p += v * t + a * t * t / 2 + j * static_cast<long double>(t) * t * t / 6;
      v += a * t + j * static_cast<long double>(t) * t / 2;
      a += j * t;
      T += t;
      b.velocity_max = std::max(b.velocity_max, static_cast<double>(v));
      b.velocity_min = std::min(b.velocity_min, static_cast<double>(v));
      b.acceleration_max = std::max(b.acceleration_max, static_cast<double>(a));
      b.acceleration_min = std::min(b.acceleration_min, static_cast<double>(a));
      b.jerk_max = std::max(b.jerk_max, j);
      b.jerk_min = std::min(b.jerk_min, j);
    }
    const MotionState to{static_cast<double>(p), static_cast<double>(v), static_cast<double>(a)};
    if (!(b.jerk_max > 0) || !(b.jerk_min < 0)) continue;
    if (!safe_start(from, b) || !safe_target(to, b)) continue;
    const Slack rounding{1e-13L, 1e-13L, 1e-13L};
    EXPECT_TRUE(contains(reachable(from, to, b, rounding), T))
        << i << ": " << reproducer({from, to, b, static_cast<double>(T)});
    narrow += !contains(reachable(from, to, b), T * 2) ? 1 : 0;
  }
  EXPECT_GT(narrow, 0) << "some durations are impossible";
}

}  // namespace
}  // namespace jounce::proof
