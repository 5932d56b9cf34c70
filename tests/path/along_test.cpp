// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/along.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/path/paths.hpp"

namespace jounce::along_test {
namespace {

using path_tests::Random;
using path_tests::usual;

Plan circle(const GroupLimits& limits, double feed) {
  Program p(2);
  p.set({.velocity = feed});
  p.arc(arc_about({}, {50, 0}, {}, Plane{0, 1}, ArcRotation::counterclockwise), 7);
  return plan(p, limits);
}

/// The same motion, with other limits of the path.
Plan limited(const Plan& made, const PathLimits& path) {
  Plan::Given given = made.given();
  given.limits.path = path;
  return {made.path(), made.law(), {}, made.stop_duration(), given};
}

const Finding& worst(const Report& report) {
  return report.findings.front();
}

TEST(Along, AMotionOnACircle) {
  // At 100 mm/s the normal acceleration is v^2 / R = 200 mm/s^2.
  const Plan made = circle(usual(2), 100);
  const Report within = check_along(limited(made, {.velocity = 100, .normal_acceleration = 200}));
  ASSERT_EQ(within.findings.size(), 2u);
  EXPECT_TRUE(within.ok());
  for (const Finding& f : within.findings) EXPECT_NEAR(f.margin, 0, 1e-12);
  const Report above = check_along(limited(made, {.normal_acceleration = 199.99}));
  EXPECT_EQ(worst(above).rule, "limit/normal_acceleration");
  EXPECT_NEAR(worst(above).value, 200, 1e-9);
  EXPECT_TRUE(worst(above).broken);
  // The total acceleration against a million samples of both axes.
  const Report total = check_along(limited(made, {.total_acceleration = 1}));
  double sampled = 0;
  std::vector<Motion> now(2);
  PlanCursor cursor(made);
  for (int i = 0; i <= 1000000; ++i) {
    cursor.at(made.duration() * i / 1000000, now);
    sampled = std::max(sampled, std::hypot(now[0].acceleration, now[1].acceleration));
  }
  EXPECT_GE(worst(total).value, sampled * (1 - 1e-12));
  EXPECT_LE(worst(total).value, sampled * (1 + 1e-5));
}

TEST(Along, ALineInSevenPhases) {
  // 200 mm from rest to rest at 100 mm/s: the ramps take 0.2 s, in 0.1 s to 1000 mm/s^2 and back.
  Program p(1);
  p.set({.velocity = 100});
  p.line({200}, 3);
  const Plan made = plan(p, usual(1));
  const Report report = check_along(
      limited(made, {.velocity = 90, .acceleration = 900, .deceleration = 800, .jerk = 9000}));
  ASSERT_EQ(report.findings.size(), 4u);
  for (const Finding& f : report.findings) {
    EXPECT_TRUE(f.broken) << f.rule;
    const double value = f.quantity == "velocity" ? 100 : f.quantity == "jerk" ? 1e4 : 1000;
    const double where = f.quantity == "velocity"       ? 0.2
                         : f.quantity == "acceleration" ? 0.1
                         : f.quantity == "deceleration" ? 2.1
                                                        : f.where;
    EXPECT_NEAR(f.value, value, 1e-9 * value) << f.rule;
    EXPECT_NEAR(f.where, where, 1e-9) << f.rule;
  }
}

TEST(Along, ALimitOfACommandNamesItsLine) {
  const Plan made = circle(usual(2), 100);
  Plan::Given given = made.given();
  given.settings.front().velocity = 99;
  const Report report = check_along({made.path(), made.law(), {}, made.stop_duration(), given});
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(worst(report).rule, "limit/velocity");
  EXPECT_NE(worst(report).advice.find("line 7"), std::string::npos);
}

/// The axes of a plan whose commands lower the limits of one axis, at 200 000 samples.
TEST(Along, ALimitOfAnAxisInACommandIsAFindingIfThePlanBreaksIt) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.5});
  p.line({60, 20}, 3);
  PathSettings slower = p.settings().back();
  slower.axes = {{}, {.velocity = 30, .acceleration = 400, .jerk = 8000}};
  p.set(slower);
  p.arc(arc_about({60, 20}, {60, 50}, {60, 80}, Plane{0, 1}, ArcRotation::counterclockwise), 4);
  p.line({0, 80}, 5);
  const Plan made = plan(p, usual(2));
  EXPECT_TRUE(check_along(made).ok());

  double most = 0;  // greatest velocity of y on the lines 4 and 5
  std::vector<Motion> now(2);
  PlanCursor cursor(made);
  for (int i = 0; i <= 200000; ++i) {
    cursor.at(made.duration() * i / 200000, now);
    if (now[1].position > 20.5) most = std::max(most, std::abs(now[1].velocity));
  }
  EXPECT_NEAR(most, 30, 0.3) << "the limit decides";

  Plan::Given given = made.given();
  for (PathSettings& settings : given.settings)
    if (!settings.axes.empty()) settings.axes[1] = {.velocity = most * 0.99};
  const Report report = check_along({made.path(), made.law(), {}, made.stop_duration(), given});
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_TRUE(worst(report).broken);
  EXPECT_EQ(worst(report).rule, "limit/velocity");
  EXPECT_EQ(worst(report).axis, "2");
  EXPECT_NEAR(worst(report).value, most, 1e-3);
  EXPECT_NE(worst(report).advice.find("line 4"), std::string::npos) << worst(report).advice;
}

TEST(Along, BlendsAndAveragesKeepTheTotalAcceleration) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    GroupLimits limits = usual(2, random.log_between(1e4, 1e6));
    limits.path = {.acceleration = random.log_between(200, 2000),
                   .normal_acceleration = random.log_between(200, 2000),
                   .total_acceleration = random.log_between(200, 2000)};
    Program p(2);
    const bool average = seed % 2 == 0;
    p.set({.velocity = random.log_between(10, 300),
           .corner = average ? Corner::average : Corner::deviation,
           .value = random.log_between(0.01, 0.5)});
    Point at{};
    double angle = 0;
    for (int i = 1; i <= 40; ++i) {
      angle += random.between(-0.4, 0.4);
      const Point from = at;
      const double length = random.log_between(0.5, 5);
      at = {from[0] + length * std::cos(angle), from[1] + length * std::sin(angle)};
      if (!average && i % 5 == 0)
        p.arc(arc_of_radius(from, length, at, Plane{0, 1}, ArcRotation::clockwise), i);
      else
        p.line(at, i);
    }
    const Plan made = plan(p, limits);
    const Report report = check_along(made);
    EXPECT_TRUE(report.ok()) << worst(report).rule << " " << worst(report).value;
    // The bound holds for samples of the axes.
    std::vector<Motion> now(2);
    PlanCursor cursor(made);
    double sampled = 0;
    for (int i = 0; i <= 5000; ++i) {
      cursor.at(made.duration() * i / 5000, now);
      sampled = std::max(sampled, std::hypot(now[0].acceleration, now[1].acceleration));
    }
    EXPECT_LE(sampled, limits.path.total_acceleration * (1 + 1e-9));
  }
}

TEST(Cursor, EvaluatesAsThePlan) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::average, .value = 0.05});
  for (int i = 1; i <= 200; ++i) p.line({0.5 * i, 10 * std::sin(0.05 * i)});
  p.set({.velocity = 50, .corner = Corner::deviation, .value = 0.5});
  p.dwell(0.2);
  p.line({120, 40});
  p.line({120, 0});
  const Plan made = plan(p, usual(2));
  PlanCursor cursor(made);
  Random random(1);
  std::vector<Motion> expected(2);
  std::vector<Motion> got(2);
  for (int i = 0; i < 20000; ++i) {
    const double t = i < 10000 ? made.duration() * i / 10000 : random.between(0, made.duration());
    made.at(t, expected);
    cursor.at(t, got);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(got[k].position, expected[k].position);
      EXPECT_EQ(got[k].velocity, expected[k].velocity);
      EXPECT_EQ(got[k].acceleration, expected[k].acceleration);
      EXPECT_EQ(got[k].jerk, expected[k].jerk);
    }
    if (HasFailure()) break;
  }
}

TEST(Arcs, ACircleUsesItsLimits) {
  // R = 50: v^2 / R = A at 223.6 mm/s, which the jerk along the circle permits above 4472 mm/s^3.
  const double most = std::sqrt(1000.0 * 50);
  for (const double jerk : {1e4, 3e4, 1e5, 1e6}) {
    SCOPED_TRACE(jerk);
    const GroupLimits limits = usual(2, jerk);
    for (const double feed : {PathSettings::none, 220.0, 150.0}) {
      const Plan made = circle(limits, feed);
      EXPECT_LE(path_tests::excess(to_axes(made), limits), 1e-12);
      double fastest = 0;
      for (const LawInterval& s : made.law().stretches()) fastest = std::max(fastest, s.peak);
      EXPECT_GE(fastest, 0.97 * std::min(feed, most));
    }
  }
}

TEST(Arcs, HelicesKeepTheLimits) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    GroupLimits limits;
    for (int k = 0; k < 3; ++k)
      limits.axes.push_back(
          {.velocity = random.log_between(20, 500),
           .acceleration = random.log_between(100, 1e4),
           .jerk = seed % 5 == 0 ? std::optional<double>{} : random.log_between(1e3, 1e6)});
    Program p(3);
    p.set({.velocity = random.log_between(5, 500),
           .corner = Corner::deviation,
           .value = random.log_between(1e-3, 1)});
    p.line({random.between(1, 20), random.between(-5, 5), 0}, 1);
    const Point from = p.position();
    const double r = random.log_between(0.1, 50);
    const double a = random.between(0, 6);
    const Point center{from[0] - r * std::cos(a), from[1] - r * std::sin(a), from[2]};
    const double b = a + random.between(0.1, 6);
    p.arc(arc_about(from, center,
                    {center[0] + r * std::cos(b), center[1] + r * std::sin(b),
                     from[2] + r * random.log_between(0.01, 30)},
                    Plane{0, 1}, ArcRotation::counterclockwise, seed % 3 == 0 ? 2 : 0),
          2);
    const Plan made = plan(p, limits);
    ASSERT_LE(path_tests::excess(to_axes(made), limits), 1e-12);
    ASSERT_LE(made.duration(), made.stop_duration() * (1 + 1e-12));
    ASSERT_GE(made.duration(), lower_bound(made, 8) * (1 - 1e-12));
  }
}

TEST(Arcs, ACircleIsNearTheBoundWhereTheJerkPermits) {
  // spec/path.md, 3, row 6: 1.640032 s with a total acceleration of 1000 and no limit of jerk.
  for (const double jerk : {1e5, 1e6, 1e8}) {
    const GroupLimits limits{.axes = std::vector<Limits>(2, {.jerk = jerk}),
                             .path = {.total_acceleration = 1000}};
    const Plan made = circle(limits, PathSettings::none);
    EXPECT_LE(made.duration(), 1.640032 / 0.97) << jerk;
    EXPECT_GE(made.duration(), 1.640032) << jerk;
    EXPECT_TRUE(check_along(made).ok());
    EXPECT_LE(path_tests::excess(to_axes(made), limits), 1e-12);
  }
}

TEST(Records, ATangentJointHasNoAngle) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.01});
  p.line({100, 0}, 1);
  p.arc(arc_about({100, 0}, {100, 50}, {100, 100}, Plane{0, 1}, ArcRotation::counterclockwise), 2);
  p.line({100, 200}, 3);
  const std::vector<CornerRecord> corners = plan(p, usual(2)).corners();
  ASSERT_EQ(corners.size(), 2u);
  EXPECT_NEAR(corners[0].angle, 0, 1e-9);
  EXPECT_GT(corners[0].trim, 0);
  EXPECT_NEAR(corners[1].angle, std::numbers::pi / 2, 1e-9);
}

TEST(Records, ANoteHasSixDigitsAndUnits) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.1 / 3});
  p.line({10, 0}, 1);
  p.line({10, 10}, 2);
  const std::vector<CornerRecord> corners = plan(p, usual(2)).corners();
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(
      explain(corners[0], "mm"),
      "Rounding within a deviation of 0.0333333 mm takes longer than a stop: the motion stops "
      "here.");
  EXPECT_EQ(corners[0].text, explain(corners[0]));
}

}  // namespace
}  // namespace jounce::along_test
