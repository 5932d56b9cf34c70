// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/superimposed_move.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::superimposed_move_test {
namespace {

using namespace test;

AxisConfig config() {
  AxisConfig config{.limits = limits(200, 1000, 1e5)};
  config.limits.position_min = -50;
  config.limits.position_max = 50;
  return resolved(config);
}

constexpr Peaks half{.velocity = 100, .acceleration = 500, .jerk = 5e4};

/// Offset at rest at 0, in this tick.
Jet added(SuperimposedMove& move, std::int64_t tick) {
  Setpoint next;
  move.add_to(next, tick);
  return next.slave;
}

Cause cause(const std::optional<Refusal>& refusal) {
  return refusal ? refusal->cause : Cause::none;
}

TEST(SuperimposedMove, EndsAtItsDistanceWithinWhatIsLeft) {
  SuperimposedMove move(config());
  EXPECT_FALSE(move.shifts());
  ASSERT_EQ(cause(move.begin(0, 20, {}, half, 0)), Cause::none);
  EXPECT_EQ(move.distance(), 20);
  EXPECT_EQ(move.peaks().velocity, 100);
  std::int64_t tick = 0;
  for (; move.running(); ++tick) {
    ASSERT_LT(tick, 2000);
    EXPECT_NEAR(move.remaining(tick), 20 - added(move, tick)[0], 1e-9);
    const Jet now = added(move, tick);
    EXPECT_LE(std::abs(now[1]), 100 * (1 + 1e-9));
    EXPECT_LE(std::abs(now[2]), 500 * (1 + 1e-9));
  }
  // 0.2 s at 100 u/s, and a ramp of 0.2 s plus 0.01 s of jerk.
  EXPECT_NEAR(static_cast<double>(tick), 411, 2);
  EXPECT_NEAR(added(move, tick)[0], 20, 1e-9);
  EXPECT_EQ(added(move, tick)[1], 0);
  EXPECT_NEAR(move.finished(), 20, 1e-9);
  EXPECT_TRUE(move.shifts()) << "its distance stays";
  EXPECT_EQ(move.peaks().velocity, 0);
  move.clear();
  EXPECT_FALSE(move.shifts());
}

TEST(SuperimposedMove, IsRejectedAndLeavesTheOneInProgress) {
  SuperimposedMove move(config());
  ASSERT_EQ(cause(move.begin(0, 20, {}, half, 0)), Cause::none);
  const Peaks all{.velocity = 200, .acceleration = 500, .jerk = 5e4};
  EXPECT_EQ(cause(move.begin(10, 5, {}, all, 0)), Cause::no_reserve);
  EXPECT_EQ(cause(move.begin(10, 5, {}, {.acceleration = 1000}, 0)), Cause::no_reserve);
  EXPECT_EQ(cause(move.begin(10, 5, {}, {.jerk = 1e5}, 0)), Cause::no_reserve);
  EXPECT_EQ(cause(move.begin(10, 5, {.velocity = 0}, half, 0)), Cause::not_positive);
  EXPECT_EQ(cause(move.begin(10, 5, {.velocity = 101}, half, 0)), Cause::velocity_limit);
  EXPECT_EQ(move.distance(), 20);
  EXPECT_EQ(move.peaks().velocity, 100);
}

TEST(SuperimposedMove, ThatWouldEndOutsideIsRejected) {
  SuperimposedMove move(config());
  const auto no = move.begin(0, 31, {}, half, 20);
  ASSERT_EQ(cause(no), Cause::position_limit);
  EXPECT_EQ(no->value, 51);
  EXPECT_EQ(no->limit, 50);
  EXPECT_EQ(cause(move.begin(0, -71, {}, half, 20)), Cause::position_limit);
  EXPECT_EQ(cause(move.begin(0, 30, {}, half, 20)), Cause::none);
  SuperimposedMove unknown(config());
  EXPECT_EQ(cause(unknown.begin(0, 31, {}, half, std::nullopt)), Cause::none);
}

TEST(SuperimposedMove, AFurtherOneGoesOnFromTheStateOfThis) {
  SuperimposedMove move(config());
  ASSERT_EQ(cause(move.begin(0, 20, {}, half, 0)), Cause::none);
  const Jet before = added(move, 250);
  ASSERT_EQ(cause(move.begin(250, 5, {}, half, 0)), Cause::none);
  EXPECT_NEAR(move.distance(), before[0] + 5, 1e-12);
  const Jet now = added(move, 250);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(now[k], before[k], 1e-9) << k;
}

TEST(SuperimposedMove, HeldItComesToRestAndGoesOnToItsEnd) {
  SuperimposedMove move(config());
  ASSERT_EQ(cause(move.begin(0, 20, {}, half, 0)), Cause::none);
  ASSERT_TRUE(move.hold(true, 150));
  EXPECT_TRUE(move.held());
  const Jet there = added(move, 1000);
  EXPECT_EQ(there[1], 0);
  EXPECT_LT(there[0], 20);
  EXPECT_TRUE(move.running());
  EXPECT_EQ(added(move, 9000)[0], there[0]);
  ASSERT_TRUE(move.hold(false, 9000));
  EXPECT_NEAR(added(move, 12'000)[0], 20, 1e-9);
  EXPECT_FALSE(move.running());
  EXPECT_TRUE(move.hold(true, 12'001)) << "nothing to hold";
  EXPECT_FALSE(move.held() && move.running());
}

TEST(SuperimposedMove, IsHeldFromTheTickOfItsBeginAtTheEarliest) {
  SuperimposedMove move(config());
  ASSERT_EQ(cause(move.begin(100, 20, {}, half, 0)), Cause::none);
  ASSERT_TRUE(move.hold(true, 99));
  EXPECT_EQ(added(move, 100)[0], 0);
  EXPECT_EQ(added(move, 5000)[0], 0);
}

}  // namespace
}  // namespace jounce::superimposed_move_test
