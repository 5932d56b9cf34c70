// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/limits/limits.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

namespace jounce::limits_test {
namespace {

Trajectory move() {
  return trapezoid({.to = 10, .velocity = 2, .acceleration = 4}).curve();
}

TEST(Check, ReportsTheClosestLimit) {
  const Report report = check(move(), {.velocity = 2.5, .acceleration = 4});
  EXPECT_TRUE(report.ok());
  ASSERT_EQ(report.findings.size(), 2U);
  EXPECT_EQ(report.findings[0].rule, "limit/acceleration");
  EXPECT_NEAR(report.findings[0].margin, 0, 1e-15) << "a limit that is just met is met";
  EXPECT_EQ(report.findings[1].rule, "limit/velocity");
  EXPECT_NEAR(report.findings[1].margin, 0.2, 1e-15);
}

TEST(Check, NamesWhereAndByHowMuch) {
  const Report report = check(move(), {.position_max = 8, .velocity = 1.6});
  EXPECT_FALSE(report.ok());
  const Finding& worst = report.findings.front();
  EXPECT_EQ(worst.rule, "limit/velocity");
  EXPECT_DOUBLE_EQ(worst.value, 2);
  EXPECT_DOUBLE_EQ(worst.limit, 1.6);
  EXPECT_NEAR(worst.margin, -0.25, 1e-15);
  EXPECT_DOUBLE_EQ(worst.where, 0.5);
  ASSERT_TRUE(worst.segment);
  EXPECT_FALSE(worst.advice.empty());
  // One finding for each segment that breaks it: ramp up (its peak is the cruise's, too), ramp down;
  // position in the last two.
  EXPECT_EQ(report.broken(), 4U);
}

/// u of a segment of length 1 from 0 to 0 over 10 at its middle: 40 s (1 - s).
Segment hill() {
  Segment f;
  f.degree = 2;
  f.c[1] = 40;
  f.c[2] = -40;
  return f;
}

TEST(Check, AdvisesByThePlaceOfABrokenPosition) {
  const auto advice = [](const Segment& f) {
    return check(Cam({f}, 0), {.position_max = 8}).findings.front().advice;
  };
  EXPECT_EQ(advice(line(1, 0, 10)),
            "the knots here are outside the position range: move them, or widen the range");
  EXPECT_EQ(advice(hill()),
            "the curve overshoots between its knots: move the knots, or lower their velocities");
}

TEST(Check, ALimitBrokenByALittleIsBroken) {
  EXPECT_FALSE(check(move(), {.velocity = 2 * (1 - 1e-9)}).ok());
  EXPECT_TRUE(check(move(), {.velocity = 2 * (1 - 1e-14)}).ok()) << "rounding is forgiven";
}

TEST(Check, WithoutLimitsFindsNothing) {
  EXPECT_TRUE(check(move(), {}).findings.empty());
}

TEST(Check, RejectsLimitsThatAreNone) {
  EXPECT_THROW(static_cast<void>(check(move(), {.velocity = 0})), InputError);
  EXPECT_THROW(static_cast<void>(check(move(), {.acceleration = std::nan("")})), InputError);
  EXPECT_THROW(static_cast<void>(check(move(), {.position_min = 1, .position_max = 0})),
               InputError);
}

TEST(CheckContinuity, FindsTheFirstDerivativeThatJumps) {
  EXPECT_TRUE(check_continuity(move(), 1).ok());
  const Report report = check_continuity(move(), 2);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.findings.front().rule, "continuity/acceleration");
  EXPECT_DOUBLE_EQ(report.findings.front().value, 4) << "at the first joint the ramp's 4 end";
}

TEST(CheckContinuity, FindsAMotionThatIsLeftAtSpeed) {
  const Trajectory f({quintic(1, 0, 0, 0, 1, 3, 0)}, 0, Extrapolation::hold);
  const Report report = check_continuity(f, 1);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.findings.front().rule, "continuity/velocity");
  EXPECT_DOUBLE_EQ(report.findings.front().where, 1);
  EXPECT_NEAR(report.findings.front().value, 3, 1e-14);
}

TEST(CheckContinuity, IncludesTheWrap) {
  const Trajectory ramp({line(1, 0, 1)}, 0, Extrapolation::wrap);
  EXPECT_FALSE(check_continuity(ramp, 0).ok());
  EXPECT_TRUE(check_continuity(with(ramp, Extrapolation::hold), 0).ok());
}

TEST(Limits, AreBoundsAndBoundsAreLimits) {
  const Limits limits{.position_min = -1, .velocity = 2, .jerk = 100};
  const Bounds bounds = bounds_of(limits);
  EXPECT_EQ(bounds.position_min, -1);
  EXPECT_EQ(bounds.position_max, Bounds::none);
  EXPECT_EQ(bounds.velocity_min, -2);
  EXPECT_EQ(bounds.velocity_max, 2);
  EXPECT_EQ(bounds.acceleration_max, Bounds::none);
  EXPECT_EQ(bounds.jerk_min, -100);
  const Limits back = limits_of(bounds);
  EXPECT_EQ(back.position_min, limits.position_min);
  EXPECT_EQ(back.position_max, limits.position_max);
  EXPECT_EQ(back.velocity, limits.velocity);
  EXPECT_EQ(back.acceleration, limits.acceleration);
  EXPECT_EQ(back.jerk, limits.jerk);
  EXPECT_EQ(bounds_of({}), Bounds{});

  Bounds uneven = within(2, 10);
  uneven.acceleration_min = -5;
  try {
    (void)limits_of(uneven);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "acceleration_min");
  }
  EXPECT_THROW((void)limits_of(within(-2)), InputError);
}

}  // namespace
}  // namespace jounce::limits_test
