// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"

#include "validate/references.hpp"

namespace jounce::tolerances_test {
namespace {

Drive strong() {
  Drive drive = servo_400w();
  drive.motor.torque_limit = 1e3;
  return drive;
}

ToleranceSpec three_numbers() {
  ToleranceSpec spec;
  spec.numbers = {{.key = "mass[1].inertia", .share = 0.2},
                  {.key = "mass[1].stiffness", .share = 0.1},
                  {.key = "controller.velocity_gain", .absolute = 0.005}};
  return spec;
}

const ToleranceSpread& figure(const ToleranceResult& result, const std::string& name) {
  return *std::find_if(result.figures.begin(), result.figures.end(),
                       [&](const ToleranceSpread& f) { return f.figure == name; });
}

TEST(Tolerances, CornersAreAllCombinationsOfEnds) {
  const auto rows = tolerance_cases(strong(), three_numbers());
  ASSERT_EQ(rows.size(), 8u);
  for (const auto& row : rows) {
    EXPECT_NEAR(std::abs(row[0] - 2e-4), 4e-5, 1e-18);
    EXPECT_NEAR(std::abs(row[1] - 50), 5, 1e-12);
    EXPECT_NEAR(std::abs(row[2] - 0.05), 0.005, 1e-15);
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(rows[i], rows[k]);
}

TEST(Tolerances, OfMoreThanTenNumbersEachEndIsRunAlone) {
  ToleranceSpec spec;
  for (const char* key :
       {"motor.inertia", "motor.friction.viscous", "motor.torque_limit", "mass[1].inertia",
        "mass[1].stiffness", "mass[1].damping", "mass[1].friction.viscous",
        "controller.position_gain", "controller.velocity_gain", "controller.integral_time",
        "controller.velocity_feed_forward"})
    spec.numbers.push_back({.key = key, .share = 0.01});
  spec.cases = 30;
  const auto rows = tolerance_cases(strong(), spec);
  EXPECT_EQ(rows.size(), 22u + 30u);
}

TEST(Tolerances, WorstCaseIsTheRunOfItsNumbers) {
  const Trajectory move = test::s_curve_move();
  const ToleranceResult result = over_tolerances(move, strong(), {}, three_numbers());
  EXPECT_EQ(result.cases, 8u);
  EXPECT_TRUE(result.all_corners);
  EXPECT_EQ(result.failed, 0u);
  const DriveResult nominal = exact_through(move, strong()).value();
  const ToleranceSpread& torque = figure(result, "torque");
  EXPECT_EQ(torque.nominal, std::abs(nominal.torque.value));
  EXPECT_GT(torque.worst.value, torque.nominal);
  EXPECT_LT(torque.least, torque.nominal);
  // A heavier load needs more torque: the worst corner has the greatest inertia.
  ASSERT_EQ(torque.worst.numbers[0].first, "mass[1].inertia");
  EXPECT_NEAR(torque.worst.numbers[0].second, 2.4e-4, 1e-18);
  for (const ToleranceSpread& f : result.figures) {
    Drive drive = strong();
    drive.train[0].inertia = f.worst.numbers[0].second;
    drive.train[0].stiffness = f.worst.numbers[1].second;
    drive.controller.velocity_gain = f.worst.numbers[2].second;
    const DriveResult again = exact_through(move, drive).value();
    if (f.figure == "torque") {
      EXPECT_EQ(std::abs(again.torque.value), f.worst.value);
    }
    if (f.figure == "following_error") {
      EXPECT_EQ(std::abs(again.following_error.value), f.worst.value);
    }
    if (f.figure == "residual") {
      EXPECT_EQ(std::abs(again.residual.value), f.worst.value);
    }
  }
}

TEST(Tolerances, MonteCarloIsTheSameForASeedAndInAnyOrder) {
  ToleranceSpec spec = three_numbers();
  spec.method = ToleranceSpec::Method::monte_carlo;
  spec.cases = 40;
  const Trajectory move = test::s_curve_move();
  const ToleranceResult a = over_tolerances(move, strong(), {}, spec);
  const ToleranceResult b =
      over_tolerances(move, strong(), {}, spec, [](std::size_t count, const auto& body) {
        for (std::size_t i = count; i-- > 0;) body(i);
      });
  for (std::size_t i = 0; i < a.figures.size(); ++i) {
    EXPECT_EQ(a.figures[i].worst.value, b.figures[i].worst.value);
    EXPECT_EQ(a.figures[i].mean, b.figures[i].mean);
    EXPECT_EQ(a.figures[i].worst.numbers, b.figures[i].worst.numbers);
  }
  spec.seed = 2;
  EXPECT_NE(over_tolerances(move, strong(), {}, spec).figures[0].worst.value,
            a.figures[0].worst.value);
}

TEST(Tolerances, DrawsHaveTheDistributionAskedFor) {
  ToleranceSpec spec;
  spec.method = ToleranceSpec::Method::monte_carlo;
  spec.cases = 20'000;
  for (const bool normal : {false, true}) {
    spec.numbers = {{.key = "mass[1].stiffness", .share = 0.1, .normal = normal}};
    double sum = 0, squares = 0, most = 0;
    for (const auto& row : tolerance_cases(strong(), spec)) {
      const double x = (row[0] - 50) / 5;
      sum += x;
      squares += x * x;
      most = std::max(most, std::abs(x));
    }
    EXPECT_LE(most, 1);
    EXPECT_NEAR(sum / 20'000, 0, 0.02);
    // Uniform: 1/sqrt(3); normal cut at three deviations: 0.98658 of a third.
    EXPECT_NEAR(std::sqrt(squares / 20'000), normal ? 0.98658 / 3 : 1 / std::sqrt(3.0), 0.006);
  }
}

TEST(Tolerances, RmsTorqueOfARigidAxisIsProportionalToItsInertia) {
  // The feed-forward takes the nominal inertia from its drive, so it follows a change. Without
  // friction the torque is then J a exactly, and the rms torque is linear in J.
  Drive drive = strong();
  drive.motor.friction = {};
  drive.train[0].friction = {};
  drive.train[0].stiffness = drive.train[0].damping = 0;
  ToleranceSpec spec;
  spec.numbers = {{.key = "mass[1].inertia", .share = 0.3}};
  const Trajectory move = test::s_curve_move();
  const ToleranceResult result = over_tolerances(move, drive, {}, spec);
  const ToleranceSpread& rms = figure(result, "rms_torque");
  EXPECT_NEAR(rms.worst.value / rms.nominal, (4e-5 + 2.6e-4) / 2.4e-4, 1e-6);
  EXPECT_NEAR(rms.least / rms.nominal, (4e-5 + 1.4e-4) / 2.4e-4, 1e-6);
}

TEST(Tolerances, LimitsAreCheckedAtTheWorst) {
  const Trajectory move = test::s_curve_move();
  const DriveResult nominal = drive_through(move, strong());
  DriveOptions options;
  options.limits.torque =
      1.05 * std::abs(nominal.torque.value);  // met on paper, not by a heavy load
  const ToleranceResult result = over_tolerances(move, strong(), options, three_numbers());
  ASSERT_EQ(result.report.findings.size(), 1u);
  const Finding& finding = result.report.findings[0];
  EXPECT_EQ(finding.rule, "tolerance/torque");
  EXPECT_TRUE(finding.broken);
  EXPECT_EQ(finding.value, figure(result, "torque").worst.value);
  EXPECT_GT(figure(result, "torque").beyond, 0u);
  EXPECT_LT(figure(result, "torque").beyond, 8u);
  EXPECT_NE(finding.advice.find("mass[1].inertia = 0.00024"), std::string::npos) << finding.advice;
}

template <class Change>
std::string refused(Change change) {
  ToleranceSpec spec = three_numbers();
  change(spec);
  try {
    over_tolerances(test::law_345(36, 0.1), strong(), {}, spec);
  } catch (const InputError& error) {
    return error.key() + " = " + error.value();
  }
  return "nothing";
}

TEST(Tolerances, RejectsWhatIsNoTolerance) {
  EXPECT_EQ(refused([](auto& s) { s.numbers[0].key = "mass[2].inertia"; }),
            "tolerances.key = mass[2].inertia");
  EXPECT_EQ(refused([](auto& s) { s.numbers[1].key = s.numbers[0].key; }),
            "tolerances.key = mass[1].inertia");
  EXPECT_EQ(refused([](auto& s) { s.numbers[0].share = -0.1; }), "tolerances.share = -0.1");
  EXPECT_EQ(refused([](auto& s) { s.numbers[0].share = 1; }), "tolerances.mass[1].inertia = 0");
  EXPECT_EQ(refused([](auto& s) {
              s.numbers[0].absolute = std::numeric_limits<double>::infinity();
            }).substr(0, 19),
            "tolerances.absolute");
  EXPECT_EQ(refused([](auto& s) { s.numbers.clear(); }), "tolerances.number = ");
  EXPECT_EQ(refused([](auto& s) { s.cases = 0; }), "tolerances.cases = 0");
}

TEST(Tolerances, IntegrateTheCasesThatMeetTheTorqueLimit) {
  const Trajectory move = test::s_curve_move();
  Drive drive = strong();
  const double peak = std::abs(exact_through(move, drive).value().torque.value);
  drive.motor.torque_limit = peak;  // peak of the nominal one: about half of the cases are beyond
  const ToleranceSpec spec{.numbers = {{.key = "mass[1].inertia", .share = 0.1}}};
  const ToleranceResult all = over_tolerances(move, drive, {}, spec);
  EXPECT_EQ(all.cases, 2u);
  EXPECT_EQ(all.saturated, 1u);
  EXPECT_EQ(all.failed, 0u);
  EXPECT_NEAR(figure(all, "torque").worst.value, peak, 1e-12);
}

}  // namespace
}  // namespace jounce::tolerances_test
