// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/pt.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::pt_test {
namespace {

using test::expect_invariants;
using test::Random;
using ::testing::HasSubstr;

using Points = std::vector<PtPoint>;

/// Googol iDEABOX Pro manual, example 7-3: increments 1024, 2048, 1024 in 1024 ms each.
const Points ex_7_3{{1024, 1024}, {2048, 3072}, {3072, 4096}};

/// Example 7-4 by its own recipe: 50 sin(2 pi t) in 16 ms steps with the manual's pi, positions by the
/// trapezoid rule, and a STOP at position 0 and the full second; two loops.
Points ex_7_4() {
  constexpr double pi = 3.1415926;
  Points points;
  for (int loop = 0; loop < 2; ++loop) {
    double position = 0;
    double before = 0;
    for (int k = 1; k <= 62; ++k) {
      const double v = 50 * std::sin(2 * pi * 0.016 * k);
      position += (before + v) * 16 / 2;
      points.push_back({1000.0 * loop + 16 * k, position});
      before = v;
    }
    points.push_back({1000.0 * (loop + 1), 0, PtType::stop});
  }
  return points;
}

const Finding* find(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return &f;
  return nullptr;
}

std::size_t count(const Report& report, const std::string& rule) {
  std::size_t n = 0;
  for (const Finding& f : report.findings) n += f.rule == rule ? 1 : 0;
  return n;
}

std::string message(const Points& points, double start_rate = 0) {
  return test::error_of([&] { (void)pt<OverTime>(points, start_rate); });
}

TEST(Pt, Example73IsATrapezoid) {
  const auto rates = pt_rates<OverTime>(ex_7_3);
  ASSERT_EQ(rates.size(), 3U);
  EXPECT_EQ(rates[0].start, 0);
  EXPECT_EQ(rates[0].end, 2);
  EXPECT_EQ(rates[1].end, 2);
  EXPECT_EQ(rates[2].end, 0);
  const Trajectory f = pt<OverTime>(ex_7_3, 0, Extrapolation::hold);
  EXPECT_EQ(f.at(512).position, 256);  // 2 / 1024 / 2 * 512^2
  EXPECT_EQ(f.at(1536).position, 2048);
  EXPECT_EQ(f.at(3072).position, 4096);
  EXPECT_EQ(f.at(5000).velocity, 0);
  EXPECT_TRUE(check_pt<OverTime>(ex_7_3, 0, Extrapolation::hold).findings.empty());
  expect_invariants(f, 1);
}

TEST(Pt, Example74IsAsTheManualMakesIt) {
  const Points points = ex_7_4();
  ASSERT_EQ(points.size(), 126U);
  const auto rates = pt_rates<OverTime>(points);
  EXPECT_NEAR(points[0].position, 40.1447, 5e-5);
  EXPECT_NEAR(rates[0].end, 5.0181, 5e-5);
  EXPECT_NEAR(points[14].position, 7451.79, 5e-3);
  EXPECT_NEAR(rates[14].end, 49.9013, 5e-5);
  EXPECT_NEAR(points[61].position, 10.0426, 5e-5);
  EXPECT_EQ(points[61].x, 992);
  EXPECT_NEAR(rates[61].end, -2.5122, 5e-5);
  EXPECT_NEAR(rates[62].start, -2.5106, 5e-5);
  EXPECT_EQ(rates[62].end, 0);
  std::size_t top = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].position > points[top].position) top = i;
  EXPECT_NEAR(points[top].position, 15899.5772, 5e-5);
  EXPECT_EQ(points[top].x, 496);
  // Between the points the parabola goes on a little: by v^2 / (2 a) with the rates at its ends.
  const PtRate& turn = rates[top + 1];
  const double beyond = 16 * turn.start * turn.start / (2 * (turn.start - turn.end));
  EXPECT_NEAR(extrema(pt<OverTime>(points), 0).max.value, points[top].position + beyond, 1e-9);
}

TEST(Pt, Example74StepsWhereTheStopBeginsInBothLoops) {
  const Report report = check_pt<OverTime>(ex_7_4(), 0, Extrapolation::hold);
  EXPECT_TRUE(report.ok());
  ASSERT_EQ(count(report, "pt/velocity_step"), 2U);
  EXPECT_EQ(report.findings.size(), 2U);
  for (const Finding& f : report.findings) {
    EXPECT_NEAR(f.value, 0.0016, 5e-5);
    EXPECT_NEAR(std::fmod(f.where, 1000), 992, 1e-9);
    EXPECT_THAT(f.advice, HasSubstr("a stop segment always begins at 2P/T"));
    EXPECT_EQ(f.quantity, "step of velocity");
  }
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
}

TEST(Pt, TypesBeginAndEndAsInTheirTable) {
  const Points points{{2, 2, PtType::continued}, {4, 8},  {5, 10, PtType::even}, {7, 11},
                      {9, 14, PtType::stop},     {10, 15}};
  const auto rates = pt_rates<OverMaster>(points, 3);
  const std::array<PtRate, 6> expected{{{3, -1}, {-1, 7}, {2, 2}, {2, -1}, {3, 0}, {0, 2}}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(rates[i].start, expected[i].start) << i + 1;
    EXPECT_EQ(rates[i].end, expected[i].end) << i + 1;
  }
  const Cam f = pt<OverMaster>(points, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(value(f.segments()[i], 1), points[i].position);
    EXPECT_EQ(evaluate(f.segments()[i], 0)[1], expected[i].start);
    EXPECT_EQ(evaluate(f.segments()[i], 1)[1], expected[i].end);
  }
  EXPECT_EQ(f.segments()[2].degree, 1);
  expect_invariants(f, 0);
}

TEST(Pt, ANormalFirstSegmentBeginsAtRestWhateverWasBefore) {
  EXPECT_EQ(pt_rates<OverTime>(ex_7_3, 77)[0].start, 0);
  Points points = ex_7_3;
  points[0].type = PtType::continued;
  EXPECT_EQ(pt_rates<OverTime>(points, 77)[0].start, 77);
}

TEST(Pt, RandomChainsMeetTheirPointsAndStepOnlyWhereTheirTypeAllows) {
  Random random(7401);
  for (int n = 0; n < 300; ++n) {
    const double t = random.log_uniform(1e-6, 1e6);
    const double u = random.log_uniform(1e-6, 1e6);
    Points points;
    PtPoint last;
    for (int i = 0; i < 12; ++i) {
      last.x += t * random.uniform(0.1, 1);
      last.position += u * random.uniform(-1, 1);
      last.type = static_cast<PtType>(random.below(4));
      points.push_back(last);
    }
    const double start = random.uniform(-1, 1) * u / t;
    SCOPED_TRACE("case " + std::to_string(n) + " of seed 7401: t = " + number(t) +
                 ", u = " + number(u));
    const Trajectory f = pt<OverTime>(points, start);
    const double speed = std::abs(extrema(f, 1).peak().value);
    const auto rates = pt_rates<OverTime>(points, start);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(value(f.segments()[i], 1), points[i].position, 1e-14 * 100 * u);
      // the area under the rate is the increment
      const double length = points[i].x - (i > 0 ? points[i - 1].x : 0);
      const double stroke = points[i].position - (i > 0 ? points[i - 1].position : 0);
      EXPECT_NEAR((rates[i].start + rates[i].end) / 2 * length, stroke, 1e-13 * speed * t);
      const bool chained = points[i].type == PtType::normal || points[i].type == PtType::continued;
      if (chained && i > 0) {
        EXPECT_NEAR(evaluate(f.segments()[i], 0)[1], evaluate(f.segments()[i - 1], 1)[1],
                    1e-13 * speed);
      }
    }
    expect_invariants(f, 0);
  }
}

TEST(Pt, CumulativeTimesOf1e12KeepTheResolutionTheyHave) {
  Points points{{1e12, 1e12}};  // 1 pulse/ms on average
  for (int i = 1; i <= 1000; ++i)
    points.push_back({1e12 + 16.0 * i, 1e12 + 32.0 * i, PtType::even});
  const auto rates = pt_rates<OverTime>(points);
  for (std::size_t i = 1; i < rates.size(); ++i) EXPECT_EQ(rates[i].end, 2) << i;
  const Trajectory f = pt<OverTime>(points);
  EXPECT_EQ(f.end(), 1e12 + 16000);
  EXPECT_EQ(f.at(1e12 + 16 * 500 + 8).position, 1e12 + 16016);
}

TEST(Pt, LoopsGoOnInTimeAndPositionAndANormalStartBeginsAtRestAgain) {
  const Trajectory five = pt_loops<OverTime>(ex_7_3, 5);
  ASSERT_EQ(five.segments().size(), 15U);
  EXPECT_EQ(five.end(), 5 * 3072);
  EXPECT_EQ(five.at(five.end()).position, 5 * 4096);
  EXPECT_EQ(five.at(3072 + 512).position, 4096 + 256);
  const Trajectory endless = pt<OverTime>(ex_7_3, 0, Extrapolation::advance);
  EXPECT_EQ(endless.at(4 * 3072 + 512).position, five.at(4 * 3072 + 512).position);
  EXPECT_TRUE(check_pt<OverTime>(ex_7_3, 0, Extrapolation::advance).findings.empty());
  const Points moving{{1, 1}, {2, 3}, {3, 5}};  // rates 2, 2, 2: never comes to rest
  const Trajectory two = pt_loops<OverTime>(moving, 2);
  EXPECT_EQ(two.at(3, Side::left).velocity, 2);
  EXPECT_EQ(two.at(3).velocity, 0);
  const Report report = check_pt<OverTime>(moving, 0, Extrapolation::advance);
  ASSERT_NE(find(report, "pt/wrap"), nullptr);
  EXPECT_EQ(find(report, "pt/wrap")->value, -2);
  EXPECT_EQ(find(report, "pt/wrap")->where, 3);
}

TEST(Pt, AContinuedFirstSegmentTakesOverFromThePassBefore) {
  // Googol manual, example 7-9, last table: increments 16000, 20000, 16000 for 20000 of the master.
  const Points points{{20000, 16000, PtType::continued}, {40000, 36000}, {60000, 52000}};
  const Cam three = pt_loops<OverMaster>(points, 3, 0.6);
  for (const auto& [x, rate] : {std::pair{0.0, 0.6},
                                {20000.0, 1.0},
                                {40000.0, 1.0},
                                {60000.0, 0.6},
                                {80000.0, 1.0},
                                {120000.0, 0.6}})
    EXPECT_NEAR(three.at(x).geo_velocity, rate, 1e-12) << x;
  EXPECT_TRUE(check_continuity(three, 1, 1e-12).ok());
}

TEST(Pt, BadInputNamesThePoint) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message({}), "point: is missing: a PT table needs at least one point");
  EXPECT_EQ(message({{0, 1}}), "point[1].time = 0: must be greater than 0, the start of the table");
  EXPECT_EQ(message({{1, 1}, {3, 2}, {3, 4}}),
            "point[3].time = 3: must be greater than 3, the previous point");
  EXPECT_EQ(message({{1, 1}, {nan, 2}}), "point[2].time = nan: must be a finite number");
  EXPECT_EQ(message({{1, nan}}), "point[1].position = nan: must be a finite number");
  EXPECT_EQ(message({{1, 1}}, nan), "start_rate = nan: must be a finite number");
  try {
    (void)pt_loops<OverMaster>(Points{{1, 1}, {1, 2}}, 2);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "point[2].master");
  }
  EXPECT_THROW((void)pt_loops<OverTime>(ex_7_3, 0), InputError);
}

TEST(Pt, EvenSegmentsFromRestReportTheirStep) {
  const Points points{{1, 2, PtType::even}, {2, 4, PtType::even}, {3, 5, PtType::even}};
  const Report report = check_pt<OverTime>(points, 0, Extrapolation::hold);
  ASSERT_EQ(count(report, "pt/velocity_step"), 2U);  // rest to 2, then 2 to 1; not 2 to 2
  EXPECT_EQ(report.findings[0].value, 2);
  EXPECT_EQ(report.findings[0].where, 0);
  EXPECT_THAT(report.findings[0].advice, HasSubstr("an even segment runs at P/T"));
  const Finding* end = find(report, "pt/end_velocity");
  ASSERT_NE(end, nullptr);
  EXPECT_EQ(end->value, 1);
  EXPECT_EQ(end->severity, Severity::warning);
  EXPECT_EQ(find(check_pt<OverTime>(points), "pt/end_velocity")->severity, Severity::note);
}

TEST(Pt, APlateauFromRestWithoutARampOscillates) {
  Points points;
  for (int i = 1; i <= 10; ++i) points.push_back({1.0 * i, 1.0 * i});
  const Report report = check_pt<OverTime>(points, 0, Extrapolation::hold);
  const Finding* found = find(report, "pt/oscillation");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(std::abs(found->value), 2);
  EXPECT_THAT(found->advice, HasSubstr("from segment 1 to 10"));
  // Half the increment first, and it runs smoothly.
  for (PtPoint& point : points) point.position -= 0.5;
  EXPECT_EQ(find(check_pt<OverTime>(points), "pt/oscillation"), nullptr);
}

TEST(Pt, PositionsRoundedToPulsesOscillateAndThoseOfTheManualDoNot) {
  EXPECT_EQ(find(check_pt<OverTime>(ex_7_4()), "pt/oscillation"), nullptr);
  Points rounded = ex_7_4();
  for (PtPoint& point : rounded) point.position = std::round(point.position);
  EXPECT_NE(find(check_pt<OverTime>(rounded), "pt/oscillation"), nullptr);
}

}  // namespace
}  // namespace jounce::pt_test
