// SPDX-License-Identifier: Apache-2.0
// Poles and margins of loops, against closed forms and tests/oracle/loop.py.
#include "jounce/validate/loop.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"
#include "jounce/validate/tolerances.hpp"

#include "validate/references.hpp"

namespace jounce::loop_test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;

/// J s^2 alone: both loops make a system of second order of it, the integral part one of third.
Drive rigid(double inertia, double position_gain, double velocity_gain, double integral_time) {
  Drive drive;
  drive.motor.inertia = inertia;
  drive.motor.torque_limit = 1e6;
  drive.controller.position_gain = position_gain;
  drive.controller.velocity_gain = velocity_gain;
  drive.controller.integral_time = integral_time;
  drive.position_per_rev = 360;
  return drive;
}

Drive drive_of(const Json& c) {
  const Json& k = c.at("controller");
  Drive drive = rigid(c.at("bodies")[0][0], k.at("kp"), k.at("kv"), k.at("ti"));
  drive.motor.friction.viscous = c.at("bodies")[0][1];
  drive.motor.current_lag = c.at("lag");
  drive.controller.delay = k.at("delay");
  drive.controller.cycle = k.at("cycle");
  for (std::size_t i = 1; i < c.at("bodies").size(); ++i) {
    const Json& b = c.at("bodies")[i];
    Mass mass;
    mass.inertia = b[0];
    mass.friction.viscous = b[1];
    mass.stiffness = b[2];
    mass.damping = b[3];
    drive.train.push_back(mass);
  }
  return drive;
}

/// A drive of the oracle by its name.
Drive oracle_drive(const std::string& name) {
  static const Json all = Json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/loop.json"));
  for (const Json& c : all.at("cases"))
    if (c.at("name") == name) return drive_of(c);
  ADD_FAILURE() << name;
  return {};
}

// ---- closed forms -------------------------------------------------------------------------------

/// J s^2 + K_v s + K_v K_p: w_n^2 = K_v K_p / J, 2 D w_n = K_v / J. L = K_v (s + K_p) / (J s^2) never reaches the
/// negative real axis, and |L| = 1 where J^2 w^4 = K_v^2 (w^2 + K_p^2).
TEST(Loop, OfSecondOrderHasItsClosedForm) {
  const double j = 2e-4, kp = 50, kv = 0.016;
  const LoopStability loop = loop_stability(rigid(j, kp, kv, 0));
  ASSERT_EQ(loop.poles.size(), 1u);
  const double wn = std::sqrt(kv * kp / j), damping = kv / j / (2 * wn);
  EXPECT_NEAR(loop.poles[0].damping, damping, 1e-12);
  EXPECT_NEAR(loop.poles[0].growth, -damping * wn, 1e-12 * wn);
  EXPECT_NEAR(loop.poles[0].frequency, wn * std::sqrt(1 - damping * damping) / (2 * pi),
              1e-12 * wn);
  EXPECT_TRUE(loop.stable);
  EXPECT_FALSE(loop.gain.has_value());
  const double a = kv * kv / (2 * j * j);
  const double crossing = std::sqrt(a + std::sqrt(a * a + std::pow(kv * kp / j, 2)));
  ASSERT_TRUE(loop.phase.has_value());
  EXPECT_NEAR(loop.phase->frequency, crossing / (2 * pi), 1e-10 * crossing);
  EXPECT_NEAR(loop.phase->value, std::atan(crossing / kp) * 180 / pi, 1e-10);
}

/// Routh: J s^3 + K_v s^2 + K_v (K_p + 1/T_i) s + K_v K_p / T_i is stable for K_v > J K_p / (1 + K_p T_i), and swings
/// with w^2 = K_p / T_i at the limit.
TEST(Loop, WithAnIntegralPartHasTheLimitOfRouth) {
  const double j = 2e-4, kp = 50, ti = 0.004;
  const double least = j * kp / (1 + kp * ti);
  for (const double share : {0.5, 0.999, 1.001, 3.0}) {
    const LoopStability loop = loop_stability(rigid(j, kp, share * least, ti));
    EXPECT_EQ(loop.stable, share > 1) << share;
    ASSERT_TRUE(loop.gain.has_value());
    EXPECT_NEAR(loop.gain->value, -std::abs(20 * std::log10(share)), 1e-9) << share;
    EXPECT_NEAR(loop.gain->frequency, std::sqrt(kp / ti) / (2 * pi), 1e-8);
    EXPECT_EQ(loop.velocity_gain.has_value(), share < 1);
    if (loop.velocity_gain) {
      EXPECT_NEAR(*loop.velocity_gain, least, 1e-12);
    }
  }
}

// ---- the oracle ---------------------------------------------------------------------------------

void expect_margin(const std::optional<LoopMargin>& margin, const Json& expected,
                   const std::string& of) {
  ASSERT_EQ(margin.has_value(), !expected.is_null()) << of;
  if (!margin) return;
  EXPECT_NEAR(margin->value, expected[0], 1e-7 * (1 + std::abs(expected[0].get<double>()))) << of;
  EXPECT_NEAR(margin->frequency, expected[1], 1e-7 * expected[1].get<double>()) << of;
}

TEST(Loop, AgreesWithTheOracle) {
  const Json all = Json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/loop.json"));
  ASSERT_EQ(all.at("cases").size(), 11u);
  for (const Json& c : all.at("cases")) {
    const std::string name = c.at("name");
    const LoopStability loop = loop_stability(drive_of(c));
    EXPECT_EQ(loop.stable, c.at("stable").get<bool>()) << name;
    expect_margin(loop.gain, c.at("gain"), name + ": gain");
    expect_margin(loop.phase, c.at("phase"), name + ": phase");
    const Json& poles = c.at("poles");
    ASSERT_EQ(loop.poles.size(), poles.size()) << name;
    double fastest = 0;
    for (const Json& p : poles)
      fastest = std::max(fastest, std::hypot(p[0].get<double>(), 2 * pi * p[1].get<double>()));
    for (std::size_t i = 0; i < poles.size(); ++i) {
      EXPECT_NEAR(loop.poles[i].growth, poles[i][0], 1e-9 * fastest) << name << " pole " << i;
      EXPECT_NEAR(loop.poles[i].frequency, poles[i][1], 1e-9 * fastest) << name << " pole " << i;
    }
  }
}

TEST(Loop, ResponseIsTheOracles) {
  const Json all = Json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/loop.json"));
  for (const Json& c : all.at("cases")) {
    const std::vector<LoopPoint> points = loop_response(drive_of(c));
    for (const Json& known : c.at("loop")) {
      const double f = known[0];
      const auto after =
          std::lower_bound(points.begin(), points.end(), f,
                           [](const LoopPoint& p, double x) { return p.frequency < x; });
      if (after == points.end() || after == points.begin()) continue;
      // between two neighbors of the grid, a hundredth of a decade apart
      const LoopPoint& a = *(after - 1);
      const LoopPoint& b = *after;
      const std::complex<double> exact(known[1].get<double>(), known[2].get<double>());
      const double share = std::log(f / a.frequency) / std::log(b.frequency / a.frequency);
      const std::complex<double> between = a.value + share * (b.value - a.value);
      EXPECT_LT(std::abs(between - exact),
                0.5 * std::abs(b.value - a.value) + 1e-9 * std::abs(exact))
          << c.at("name") << " at " << f;
    }
  }
}

/// An unstable loop moves by itself as its first pole predicts: the exact run does not use poles.
TEST(Loop, GrowsWithItsFirstPole) {
  for (const char* name : {"two masses, delay 1.1 ms", "sampled, delay of cycles"}) {
    const Drive drive = oracle_drive(name);
    const LoopPole pole = loop_poles(drive).front();
    ASSERT_GT(pole.growth, 0) << name;
    const Trajectory move = test::s_curve_move();
    const double span = 20 / pole.frequency;
    std::vector<double> times;
    for (int i = 0; i <= 4000; ++i) times.push_back(move.end() + 0.3 + span * i / 2000);
    const ExactRun run = exact_run(move, drive, times);
    double first = 0, second = 0;
    for (std::size_t i = 0; i < 2000; ++i) {
      first = std::max(first, std::abs(run.samples[i].torque));
      second = std::max(second, std::abs(run.samples[i + 2000].torque));
    }
    EXPECT_NEAR(std::log(second / first), pole.growth * span, 0.02 * pole.growth * span) << name;
  }
}

// ---- what is made of it --------------------------------------------------------------------------

const Finding* found(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return &f;
  return nullptr;
}

TEST(Loop, IsAFindingWhereItIsUnstable) {
  const DriveResult run = drive_through(test::s_curve_move(),
                                        oracle_drive("two masses, delay 1.1 ms"), {.samples = 101});
  const Finding* unstable = found(run.report, "drive/stability");
  ASSERT_NE(unstable, nullptr);
  EXPECT_TRUE(unstable->broken);
  EXPECT_EQ(unstable->where_unit, "Hz");
  EXPECT_NEAR(unstable->where, loop_poles(oracle_drive("two masses, delay 1.1 ms"))[0].frequency,
              1e-9);
  EXPECT_THAT(unstable->advice, HasSubstr("lower controller.velocity_gain from 0.05 to less than"));
  EXPECT_EQ(&run.report.findings.front(), unstable);
  EXPECT_EQ(found(run.report, "drive/exact"), nullptr);
  const DriveResult calm = drive_through(test::s_curve_move(), oracle_drive("two masses"));
  EXPECT_EQ(found(calm.report, "drive/stability"), nullptr);
}

TEST(Loop, ReportsAStableVelocityGain) {
  Drive drive = oracle_drive("two masses, delay 1.1 ms");
  const std::optional<double> gain = loop_stability(drive).velocity_gain;
  ASSERT_TRUE(gain.has_value());
  drive.controller.velocity_gain = 0.9999 * *gain;
  EXPECT_TRUE(is_stable(loop_poles(drive)));
  drive.controller.velocity_gain = 1.0001 * *gain;
  EXPECT_FALSE(is_stable(loop_poles(drive)));
}

/// 5 % above Routh's limit, a tenth more inertia makes the loop unstable.
TEST(Loop, OfADriveWithTolerancesIsLookedAtInEachCase) {
  const double j = 2e-4, kp = 50, ti = 0.004;
  const Drive drive = rigid(j, kp, 1.05 * j * kp / (1 + kp * ti), ti);
  const ToleranceSpec spec{.numbers = {{.key = "motor.inertia", .share = 0.1}}};
  const ToleranceResult all = over_tolerances(test::s_curve_move(), drive, {}, spec);
  EXPECT_EQ(all.cases, 2u);
  EXPECT_EQ(all.unstable, 1u);
  const Finding* unstable = found(all.report, "tolerance/stability");
  ASSERT_NE(unstable, nullptr);
  EXPECT_TRUE(unstable->broken);
  EXPECT_EQ(unstable->value, 1);
}

TEST(Loop, IsLookedAtWithoutItsNonlinearParts) {
  Drive drive = oracle_drive("two masses");
  const LoopStability linear = loop_stability(drive);
  drive.motor.friction.coulomb = 0.1;
  drive.train[0].backlash = 1e-3;
  drive.train[0].efficiency = 0.8;
  const LoopStability same = loop_stability(drive);
  EXPECT_EQ(same.gain->value, linear.gain->value);
  EXPECT_EQ(same.poles.front().growth, linear.poles.front().growth);
}

TEST(Loop, RejectsADelayOfTooManyCycles) {
  Drive drive = oracle_drive("sampled");
  drive.controller.delay = 101 * drive.controller.cycle;
  EXPECT_THROW(loop_stability(drive), InputError);
  EXPECT_FALSE(unstable_loop(drive).has_value());
}

}  // namespace
}  // namespace jounce::loop_test
