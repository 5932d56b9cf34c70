// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/cam/disc/disc.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/disc/disc_cams.hpp"

namespace jounce::disc_check_test {
namespace {

using test::harmonic;
using test::random_disc;
using test::rise_dwell_return;
using ::testing::HasSubstr;

constexpr double deg = std::numbers::pi / 180;

// tan(max) = a / sqrt(b^2 - a^2) = tan A, so b = a / sin A, and the base radius is b - a - roller.
TEST(DiscCheck, LeastBaseRadiusOfTheLimacon) {
  const DiscSpec spec{.roller_radius = 3};
  for (const double limit : {10 * deg, 20 * deg}) {
    const auto base = least_base_radius(harmonic(5), spec, {.pressure_angle = limit});
    ASSERT_TRUE(base);
    EXPECT_NEAR(*base, 5 / std::sin(limit) - 5 - 3, 1e-9 * *base);
  }
}

// The limacon is most convex where r = (b^2 - a^2)/b: 1/kappa = sqrt(b^2 - a^2).
TEST(DiscCheck, LeastBaseRadiusForARadiusOfTheProfile) {
  const auto base = least_base_radius(harmonic(5), {.roller_radius = 6}, {.profile_radius = 34});
  ASSERT_TRUE(base);
  EXPECT_NEAR(*base, std::sqrt(40 * 40 + 5 * 5) - 5 - 6, 1e-8);
}

TEST(DiscCheck, LeastBaseRadiusKeepsTheLimitsAndOneBelowDoesNot) {
  test::Random random(7);
  int found = 0;
  for (int n = 0; n < 12; ++n) {
    const auto made = random_disc(random);
    SCOPED_TRACE(made.text);
    const DiscLimits limits{.pressure_angle = random.uniform(15, 45) * deg};
    const auto base = least_base_radius(made.disc.lift(), made.disc.spec(), limits);
    if (!base) continue;
    ++found;
    DiscSpec spec = made.disc.spec();
    const auto holds = [&](double radius) {
      spec.base_radius = radius;
      try {
        const DiscExtremes e = extremes(Disc(made.disc.lift(), spec));
        return std::abs(e.pressure_angle.peak().value) <= *limits.pressure_angle &&
               e.pitch_curvature.max.value * spec.roller_radius < 1;
      } catch (const InputError&) {
        return false;
      }
    };
    EXPECT_TRUE(holds(*base));
    const double least = std::max(0.0, std::abs(spec.offset) - spec.roller_radius);
    if (*base > 1.001 * least && *base > 1e-3) {
      EXPECT_FALSE(holds(*base * (1 - 2e-9)));
    }
  }
  EXPECT_GT(found, 4);
}

TEST(DiscCheck, PressureAngleOverItsLimitNamesTheBaseThatWouldDo) {
  const Cam cam = rise_dwell_return(Law::modified_sine, 20);
  DiscSpec spec{.base_radius = 15, .roller_radius = 5};
  const DiscLimits limits{.pressure_angle = 30 * deg};
  const Report report = check(Disc(cam, spec), limits);
  ASSERT_FALSE(report.ok());
  const Finding& f = report.findings.front();
  EXPECT_EQ(f.rule, "disc/pressure_angle");
  EXPECT_EQ(f.unit, "deg");
  EXPECT_GT(std::abs(f.value), 30);
  ASSERT_THAT(f.advice, HasSubstr("base_radius = "));
  spec.base_radius = std::stod(f.advice.substr(14));
  EXPECT_TRUE(check(Disc(cam, spec), limits).ok())
      << f.advice << check(Disc(cam, spec), limits).findings[0].rule;
  spec.base_radius *= 0.998;
  EXPECT_FALSE(check(Disc(cam, spec), limits).ok()) << f.advice;
}

TEST(DiscCheck, UndercutIsAFindingWhateverIsLimited) {
  CamSpec spec;
  spec.start = {0, 0, {}, {}};
  spec.periodic = true;
  spec.segments = {{Law::inclined_sine, {40, 20, {}, {}}, ""},
                   {Law::inclined_sine, {80, 0, {}, {}}, ""},
                   {Law::dwell, {360, 0, {}, {}}, ""}};
  const Cam cam = design(spec).cam;
  const Disc disc(cam, {.base_radius = 20, .roller_radius = 10});
  const double radius = 1 / extremes(disc).pitch_curvature.max.value;
  ASSERT_LT(radius, 10);
  const Report report = check(disc, {});
  ASSERT_EQ(report.broken(), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.rule, "disc/profile_radius");
  EXPECT_NEAR(f.value, radius - 10, 1e-12);
  ASSERT_THAT(f.advice, ::testing::StartsWith("the roller undercuts the profile: base_radius = "));
  const double base = std::stod(f.advice.substr(f.advice.find('=') + 1));
  EXPECT_TRUE(check(Disc(cam, {.base_radius = base, .roller_radius = 10}), {}).ok());
  EXPECT_FALSE(check(Disc(cam, {.base_radius = 0.998 * base, .roller_radius = 10}), {}).ok());
}

TEST(DiscCheck, CutterMustGetIntoTheHollow) {
  const Cam cam = rise_dwell_return(Law::inclined_sine, 40);
  const Disc disc(cam, {.base_radius = 20, .roller_radius = 5});
  const double kappa = extremes(disc).pitch_curvature.min.value;
  ASSERT_LT(kappa, 0);
  const double widest = 5 - 1 / kappa;
  EXPECT_TRUE(check(disc, {.cutter_radius = widest * 0.999}).ok());
  const Report report = check(disc, {.cutter_radius = widest * 1.001});
  ASSERT_EQ(report.broken(), 1U);
  EXPECT_EQ(report.findings[0].rule, "disc/cutter_radius");
  EXPECT_NEAR(report.findings[0].value, widest, 1e-9);
}

/// The least of |q(t2) - p(t1)| over all pairs of a grid, by places alone.
double least_gap(const Disc& disc, double radius, int n) {
  std::vector<DiscPoint> points;
  for (int i = 0; i < n; ++i) points.push_back(disc.at(360.0 * i / n));
  double least = std::numeric_limits<double>::infinity();
  const double out = radius - disc.spec().roller_radius;
  for (const DiscPoint& a : points)
    for (const DiscPoint& b : points)
      least = std::min(least, std::hypot(a.center.x + out * a.normal.x - b.contact.x,
                                         a.center.y + out * a.normal.y - b.contact.y));
  return least;
}

// The neck of a lobe that is narrower than the roller, though no place is too convex.
TEST(DiscCheck, RollerThatCutsThroughANeckIsFound) {
  CamSpec spec;
  spec.start = {0, 0, {}, {}};
  spec.periodic = true;
  spec.segments = {{Law::inclined_sine, {55, 80, {}, {}}, ""},
                   {Law::dwell, {75, 80, {}, {}}, ""},
                   {Law::inclined_sine, {130, 0, {}, {}}, ""},
                   {Law::dwell, {360, 0, {}, {}}, ""}};
  const Disc disc(design(spec).cam, {.base_radius = 0.5, .roller_radius = 8});
  ASSERT_LT(extremes(disc).pitch_curvature.max.value, 1.0 / 8) << "no undercut";
  ASSERT_LT(least_gap(disc, 8, 720), 8 - 0.1);
  const auto found = interference(disc, 8);
  ASSERT_TRUE(found);
  const DiscPoint circle = disc.at(found->circle);
  const DiscPoint covered = disc.at(found->covered);
  EXPECT_NEAR(std::hypot(circle.center.x - covered.contact.x, circle.center.y - covered.contact.y),
              8 - found->depth, 1e-9);
  EXPECT_NEAR(8 - found->depth, least_gap(disc, 8, 1440), 0.01);
  const Report report = check(disc, {});
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.findings[0].rule, "disc/interference");
}

TEST(DiscCheck, InterferenceAgreesWithAGridOfPairs) {
  test::Random random(99);
  int clear = 0;
  for (int n = 0; n < 60; ++n) {
    const auto made = random_disc(random);
    SCOPED_TRACE(made.text);
    const double roller = made.disc.spec().roller_radius;
    const Range kappa = extremes(made.disc).pitch_curvature;
    for (const double radius : {roller, 3 * roller}) {
      if (kappa.max.value * roller >= 1 || kappa.min.value * (radius - roller) <= -1) continue;
      const double gap = least_gap(made.disc, radius, 180);
      const auto found = interference(made.disc, radius);
      if (found) {
        EXPECT_LT(found->depth, radius);
      } else {
        EXPECT_GT(gap, radius * (1 - 1e-9));
        ++clear;
      }
    }
  }
  EXPECT_GT(clear, 20);
}

TEST(DiscCheck, LimitsOutOfRangeAreRejected) {
  const Disc disc(harmonic(5), {.base_radius = 20, .roller_radius = 8});
  EXPECT_THROW(static_cast<void>(check(disc, {.pressure_angle = 0})), InputError);
  EXPECT_THROW(static_cast<void>(check(disc, {.pressure_angle = 1.6})), InputError);
  EXPECT_THROW(static_cast<void>(check(disc, {.profile_radius = -1})), InputError);
  EXPECT_THROW(static_cast<void>(check(disc, {.cutter_radius = NAN})), InputError);
}

}  // namespace
}  // namespace jounce::disc_check_test
