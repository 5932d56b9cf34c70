// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/warnings.hpp"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/pvt/table.hpp"

#include "support/random.hpp"

namespace jounce::warnings_test {
namespace {

using test::Random;
using ::testing::HasSubstr;

Trajectory cubics(Columns columns, Extrapolation outside = Extrapolation::hold) {
  return Table(Domain::time, Interpolation::cubic_hermite, outside, std::move(columns))
      .curve<OverTime>();
}

/// HIMC HMPL manual 5.2.8, in s.
Trajectory hmpl() {
  return cubics({{0, 2, 3, 4, 6, 11},
                 {0, 153.333, 42.123, 161.21, 177, 83.333},
                 {0, 1000, 800, 1660, 450, 0},
                 {}});
}

TEST(Overshoot, OfHmplsExampleIsNamedSegmentBySegment) {
  const Report report = overshoot(hmpl());
  EXPECT_TRUE(report.ok());
  ASSERT_EQ(report.findings.size(), 5U);  // every one of its segments
  const Finding& worst = report.findings.front();
  EXPECT_EQ(worst.segment, 3U);
  EXPECT_NEAR(worst.limit, 177, 1e-12);
  EXPECT_NEAR(worst.value, 596.1, 0.05);
  EXPECT_NEAR(worst.margin, -(596.1 - 177) / (596.1 + 188.7), 1e-4);
  for (const Finding& f : report.findings) {
    EXPECT_EQ(f.rule, "warning/overshoot");
    EXPECT_EQ(f.severity, Severity::warning);
    if (f.segment != 0U) continue;
    EXPECT_NEAR(f.value, -188.7, 0.05);
    EXPECT_EQ(f.limit, 0);
    EXPECT_THAT(f.advice, HasSubstr("the velocity is 0 at the start of the segment and 1000 at its "
                                    "end, on average 76.6665"));
    EXPECT_THAT(f.advice, HasSubstr("does not overshoot if both velocities are between 0 and 230"));
  }
}

TEST(Overshoot, IsNoneWhereBothVelocitiesAreWithinThreeTimesTheMean) {
  Random random(5281);
  for (int n = 0; n < 2000; ++n) {
    const double length = random.log_uniform(1e-6, 1e6);
    const double stroke = random.uniform(-1, 1) * random.log_uniform(1e-6, 1e6);
    const double mean = stroke / length;
    const double a = 3 * mean * random.uniform(0, 1);
    const double b = 3 * mean * random.uniform(0, 1);
    EXPECT_TRUE(overshoot(cubics({{0, length}, {7, 7 + stroke}, {a, b}, {}})).findings.empty())
        << "case " << n << ": length " << length << ", stroke " << stroke << ", " << a << ", " << b;
  }
}

TEST(Overshoot, OfOneCubicIsItsClosedForm) {
  // p = 4 s^2 (s - 1) from 0 to 0 with end velocity 4: least at s = 2/3.
  const Report report = overshoot(cubics({{0, 1}, {0, 0}, {0, 4}, {}}));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NEAR(report.findings[0].where, 2.0 / 3, 1e-15);
  EXPECT_NEAR(report.findings[0].value, -16.0 / 27, 1e-15);
  EXPECT_THAT(report.findings[0].advice, HasSubstr("let both velocities be 0"));
}

TEST(Overshoot, IsANoteWhereTheMotionHasToTurn) {
  const Report report = overshoot(cubics({{0, 1}, {0, 0}, {4, -4}, {}}));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].severity, Severity::note);
  EXPECT_EQ(report.findings[0].value, 1);
}

TEST(Overshoot, DoesNotDependOnUnits) {
  for (const double k : {1e-9, 1e9}) {
    const Report report = overshoot(cubics({{0, k}, {0, 0}, {0, 4}, {}}));
    ASSERT_EQ(report.findings.size(), 1U);
    EXPECT_NEAR(report.findings[0].value, -16.0 / 27 * k, 1e-15 * k);
  }
}

TEST(VelocitySteps, OfALinearTableAreItsCornersAndBothEnds) {
  const Trajectory f = Table(Domain::time, Interpolation::linear, Extrapolation::hold,
                             {{0, 1, 3, 4}, {0, 2, 2, 5}, {}, {}})
                           .curve<OverTime>();
  const Report report = velocity_steps(f);
  ASSERT_EQ(report.findings.size(), 4U);
  double sum = 0;
  for (const Finding& step : report.findings)
    sum += step.rule == "pt/end_velocity" ? -step.value : step.value;
  EXPECT_EQ(sum, 0);  // from rest to rest
  EXPECT_EQ(std::abs(report.findings.front().value), 3);
}

TEST(VelocitySteps, AtTheWrapAreReportedOnce) {
  const Report report =
      velocity_steps(cubics({{0, 1}, {0, 4}, {1, 3}, {}}, Extrapolation::advance));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].rule, "pt/wrap");
  EXPECT_EQ(report.findings[0].value, -2);
  EXPECT_TRUE(velocity_steps(cubics({{0, 1}, {0, 4}, {3, 3}, {}}, Extrapolation::advance))
                  .findings.empty());
}

}  // namespace
}  // namespace jounce::warnings_test
