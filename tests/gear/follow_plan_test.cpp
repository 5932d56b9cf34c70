// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/follow_plan.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/follow_tables.hpp"
#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::follow_plan_test {
namespace {

using ::testing::HasSubstr;

FollowPlan shear() {
  return {.points = {{10000, 8000}},
          .zones = {{0, 1000, 1}, {9000, 10000, 1}},
          .periodic = true,
          .form = FollowForm::table};
}

const Finding* found(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return &f;
  return nullptr;
}

void expect_segments(const FollowTable& table, const std::vector<PtPoint>& expected) {
  ASSERT_EQ(table.segments.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(table.segments[i].x, expected[i].x, 1e-9) << i;
    EXPECT_NEAR(table.segments[i].position, expected[i].position, 1e-9) << i;
    EXPECT_EQ(table.segments[i].type, expected[i].type) << i;
  }
}

TEST(FollowPlan, TheShearOfExample76IsTwoZonesAndAPoint) {
  expect_segments(
      follow_table(shear()),
      {{1000, 1000, PtType::even}, {5000, 4000}, {9000, 7000}, {10000, 8000, PtType::even}});
  EXPECT_TRUE(check(shear()).findings.empty());
  EXPECT_EQ(master_period(shear()), 10000);
  const SyncCam slave = follow(shear());
  EXPECT_EQ(slave.cam.outside(), Extrapolation::advance);
  EXPECT_EQ(slave.zones.size(), 2U);
  test::expect_invariants(slave.cam, 1);
}

TEST(FollowPlan, WithTheManualsSlowZoneItIsTheManualsTable) {
  FollowPlan plan = shear();
  plan.zones.insert(plan.zones.begin() + 1, {4000, 6000, 0.6});
  const FollowTable table = follow_table(plan);
  const FollowTable manual = test::shear_cycle();
  ASSERT_EQ(table.segments.size(), manual.segments.size());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(table.segments[i].x, manual.segments[i].x);
    EXPECT_NEAR(table.segments[i].position, manual.segments[i].position, 1e-9);
  }
  EXPECT_EQ(table.loops, 0);
}

TEST(FollowPlan, Figure713IsAZoneToWhichARampLeads) {
  const FollowPlan plan{.zones = {{500, 1250, 1}}, .form = FollowForm::table};
  expect_segments(follow_table(plan), {{500, 250}, {1250, 1000, PtType::even}});
  EXPECT_NE(found(check(plan), "follow/open_end"), nullptr);
}

TEST(FollowPlan, EndsAtRestWithAStop) {
  const FollowPlan plan{
      .points = {{300, 200}}, .zones = {{100, 200, 1}}, .form = FollowForm::table};
  expect_segments(follow_table(plan),
                  {{100, 50}, {200, 150, PtType::even}, {300, 200, PtType::stop}});
}

TEST(FollowPlan, StandsStillRatherThanTurnBack) {
  const FollowPlan plan{.points = {{1000, 300}},
                        .zones = {{0, 100, 1}, {900, 1000, 1}},
                        .periodic = true,
                        .form = FollowForm::table};
  // 100 to go between 100 and 900, from ratio 1 to ratio 1: down within 100, stand, up within 100.
  expect_segments(follow_table(plan), {{100, 100, PtType::even},
                                       {200, 150},
                                       {800, 150, PtType::even},
                                       {900, 200},
                                       {1000, 300, PtType::even}});
  EXPECT_TRUE(check(plan).findings.empty());
  EXPECT_GE(extrema(follow(plan).cam, 1).min.value, -1e-15);

  FollowPlan smooth = plan;
  smooth.form = FollowForm::smooth;
  const Report report = check(smooth);
  const Finding* f = found(report, "follow/backwards");
  ASSERT_NE(f, nullptr);
  EXPECT_TRUE(f->broken);
  // The quintic of slope 1 at both ends is slowest in the middle: 1 + 15/8 (S/L - 1) = 0.
  EXPECT_THAT(f->advice, HasSubstr("let it travel at least 373.334 there, or use form"));
  EXPECT_NEAR(f->where, 500, 1e-9);
  EXPECT_NEAR(f->value, 1 + 15.0 / 8 * (100.0 / 800 - 1), 1e-12);
}

TEST(FollowPlan, WhatMustRunBackwardsIsNamed) {
  const FollowPlan plan{.points = {{1000, 100}},
                        .zones = {{0, 100, 1}, {900, 1000, 1}},
                        .periodic = true,
                        .form = FollowForm::table};
  const Report report = check(plan);
  const Finding* f = found(report, "follow/backwards");
  ASSERT_NE(f, nullptr);
  EXPECT_THAT(f->advice, HasSubstr("between master 100 and master 900, the slave travels -100"));
  EXPECT_LT(f->value, 0);
}

TEST(FollowPlan, WhereTheSlaveTurnsItMayTurn) {
  const FollowPlan plan{
      .points = {{1000, 0, 1}}, .zones = {{0, 300, 1}, {500, 800, -0.5}}, .periodic = true};
  EXPECT_EQ(found(check(plan), "follow/backwards"), nullptr);
}

TEST(FollowPlan, PointsWithoutARatioArePassedBetweenTheirMeanRatios) {
  const FollowPlan plan{.points = {{100, 100}, {200, 150}, {300, 150}, {400, 250}}};
  const CamSpec spec = cam_spec(plan);
  EXPECT_NEAR(*spec.segments[0].end.geo_velocity, 2 / (1 / 1.0 + 1 / 0.5), 1e-15);
  EXPECT_EQ(spec.segments[1].end.geo_velocity, 0) << "it stands after it";
  EXPECT_EQ(spec.segments[2].law, Law::dwell);
  EXPECT_EQ(spec.segments[3].end.geo_velocity, 0) << "the end";
  EXPECT_TRUE(check(plan).ok());
  test::expect_invariants(follow(plan).cam, 2);
}

TEST(FollowPlan, AZoneFarOutHasTheRatioOfItsOwnLine) {
  for (const bool periodic : {false, true}) {
    FollowPlan plan{
        .points = {{360, 1000001, 0}}, .zones = {{90, 91, 0.001, 1e6}}, .periodic = periodic};
    const SyncCam far = follow(plan);
    EXPECT_NEAR(far.cam.jet(90.5)[1], 0.001, 1e-9);
    EXPECT_TRUE(check_continuity(far.cam, 2).ok());
    plan = {.points = {{360, 1000001}}, .zones = {{0, 1, 0.001}, {90, 91, 0.001, 1e6}}};
    plan.periodic = periodic;
    EXPECT_NEAR(follow(plan).cam.jet(0.5)[1], 0.001, 1e-9) << periodic;
  }
}

TEST(FollowPlan, SmoothIsExactInItsZonesAndContinuousInAcceleration) {
  FollowPlan plan = shear();
  plan.form = FollowForm::smooth;
  for (const Law law : {Law::quintic, Law::septic, Law::modified_sine}) {
    plan.law = law;
    const SyncCam slave = follow(plan);
    test::expect_invariants(slave.cam, 2);
    EXPECT_EQ(slave.cam.outside(), Extrapolation::advance);
    EXPECT_NEAR(slave.cam.advance(), 8000, 1e-9);
    for (const double m : {0.0, 500.0, 999.0, 9000.0, 9500.0}) {
      EXPECT_NEAR(slave.cam.jet(m)[1], 1, 1e-12) << name(law);
      EXPECT_NEAR(slave.cam.jet(m)[0], m < 5000 ? m : m - 2000, 1e-9);
    }
    EXPECT_TRUE(check(plan).ok()) << name(law);
  }
}

struct Slopes {
  double greatest = 0;
  double ratio = 0;
};

/// Two pieces of length a and L - a, by the definition.
Slopes two_pieces(double L, double S, double r0, double r1, double a) {
  const double r = (2 * S - r0 * a - r1 * (L - a)) / L;
  return {std::max(std::abs(r - r0) / a, std::abs(r1 - r) / (L - a)), r};
}

TEST(FollowPlan, NoTwoPiecesAreGentler) {
  test::Random random(413);
  int compared = 0;
  for (int n = 0; n < 300; ++n) {
    const double r0 = random.uniform(0, 2);
    const double r1 = random.uniform(0, 2);
    const double L = random.log_uniform(1, 1e5);
    const double S = random.uniform(0.2, 2) * L;
    const FollowPlan plan{.points = {{100 + L, S, r1}, {300 + L, S + 100 * r1}},
                          .start_ratio = r0,
                          .form = FollowForm::table};
    FollowPlan one = plan;
    one.points = {{L, S, r1}};
    const FollowTable table = follow_table(one);
    if (table.segments.size() != 2) continue;
    ++compared;
    const Slopes made = two_pieces(L, S, r0, r1, table.segments[0].x);
    for (int i = 1; i < 200; ++i)
      EXPECT_LE(made.greatest, two_pieces(L, S, r0, r1, L * i / 200).greatest * (1 + 1e-9))
          << n << ": " << number(L) << ' ' << number(S) << ' ' << number(r0) << ' ' << number(r1);
  }
  EXPECT_GT(compared, 200);
}

FollowPlan random_plan(test::Random& random) {
  FollowPlan plan{.form = FollowForm::table, .whole_master = random.below(2) == 0};
  double master = 0;
  double slave = 0;
  for (int i = 0, n = 1 + random.below(5); i < n; ++i) {
    master += 20 + random.below(500);
    slave += random.uniform(1, 800);
    if (random.below(2) == 0) {
      const double length = 10 + random.below(300);
      const double ratio = random.uniform(0, 3);
      plan.zones.push_back({master, master + length, ratio, slave});
      master += length;
      slave += ratio * length;
    } else {
      plan.points.push_back({master, slave});
      if (random.below(2) == 0) plan.points.back().ratio = random.uniform(0, 3);
    }
  }
  plan.points.push_back({master + 50, slave + random.uniform(0, 100)});
  return plan;
}

TEST(FollowPlan, RandomTablesMeetEveryPointAndRatioAndNeverTurnBack) {
  test::Random random(414);
  int not_whole = 0;  // a slave that has to stop within one pulse
  for (int n = 0; n < 1000 && !::testing::Test::HasFailure(); ++n) {
    const FollowPlan plan = random_plan(random);
    const Cam cam = follow(plan).cam;
    SCOPED_TRACE(n);
    const double scale = std::abs(cam.at(cam.end()).position);
    for (const FollowPoint& p : plan.points) {
      EXPECT_NEAR(cam.jet(p.master)[0], p.slave, 1e-12 * scale);
      if (p.ratio) {
        EXPECT_NEAR(cam.jet(p.master, Side::left)[1], *p.ratio, 1e-9);
      }
    }
    for (const FollowZone& z : plan.zones) {
      EXPECT_NEAR(cam.jet(z.from)[0], *z.slave, 1e-12 * scale);
      EXPECT_NEAR(cam.jet(z.from)[1], z.ratio, 1e-9);
      EXPECT_NEAR(cam.jet(z.to, Side::left)[1], z.ratio, 1e-9);
    }
    const double peak = extrema(cam, 1).peak().value;
    EXPECT_LE(std::abs(largest_jump(with(cam, Extrapolation::refuse), 1).step), 1e-9 * peak);
    EXPECT_GE(extrema(cam, 1).min.value, -1e-9 * peak);
    const Report report = check(plan);
    const auto segments = follow_table(plan).segments;
    const bool whole = std::all_of(segments.begin(), segments.end(),
                                   [](const PtPoint& p) { return p.x == std::round(p.x); });
    not_whole += plan.whole_master && !whole ? 1 : 0;
    EXPECT_EQ(found(report, "follow/whole_master") != nullptr, plan.whole_master && !whole);
    for (const Finding& f : report.findings)
      EXPECT_EQ(f.rule, "follow/whole_master") << number(f.where) << ": " << f.advice;
  }
  EXPECT_LT(not_whole, 60);
}

TEST(FollowPlan, RejectsContradictions) {
  const auto text = [](const FollowPlan& plan) -> std::string {
    return test::error_of([&] { (void)cam_spec(plan); });
  };
  EXPECT_EQ(text({}), "point: is missing: add a [[point]] or a [[zone]] after the start");
  EXPECT_EQ(text({.points = {{0, 1}}}),
            "point[1].master = 0: must be greater than 0, the place of the start, of a point or of "
            "a zone");
  EXPECT_EQ(text({.zones = {{5, 5, 1}}}), "zone[1].to = 5: must be greater than from = 5");
  EXPECT_EQ(text({.zones = {{0, 50, 1}, {40, 60, 1}}}),
            "zone[2].from = 40: must be at least 50, the end of the previous zone");
  EXPECT_EQ(
      text({.zones = {{0, 50, 1}, {50, 60, 2}}}),
      "zone[2].ratio = 2: must be 1, the ratio that the slave has there: let it reach the new "
      "ratio before this zone");
  EXPECT_EQ(text({.zones = {{0, 50, 1, 3}}}),
            "zone[1].slave = 3: must be 0, the position that the slave has there: leave slave "
            "out, or change the previous point or zone");
  EXPECT_EQ(text({.points = {{20, 30}, {30, 35}}, .zones = {{10, 40, 1}}}),
            "point[2].slave = 35: must be 40, the position of the slave in zone 1 at master = 30 "
            "(zone[1].from = 10, zone[1].to = 40): correct the master, or leave the point out");
  EXPECT_THAT(text({.points = {{20, 30}}, .zones = {{30, 40, 1}}}), HasSubstr("zone[1].slave"));
  EXPECT_EQ(text({.points = {{100, 50, 1}}, .periodic = true, .start_ratio = 0}),
            "periodic = true: needs the same ratio at start and end: at the start, ratio = 0; at "
            "the end, ratio = 1");
  EXPECT_THAT(text({.points = {{NAN, 0}}}), HasSubstr("point[1].master = nan"));
}

}  // namespace
}  // namespace jounce::follow_plan_test
