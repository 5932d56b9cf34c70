// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/slave_check.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/laws/laws.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::slave_check_test {
namespace {

using std::numbers::pi;

Cam placed(const char* name, double stroke, double length) {
  return scaled(test::laws().at(name), stroke, length);
}

const Finding& finding(const Report& report, const char* rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return f;
  throw std::logic_error(rule);
}

TEST(CheckSlave, HasTheClosedFormsOfALawAtASteadySpeed) {
  // The 3-4-5 polynomial over 90 deg at 720 deg/s: 0.125 s.
  const Cam cam = placed("poly_345", 40, 90);
  const Report report =
      check_slave(cam, {.velocity = 1000, .acceleration = 14000, .jerk = 2e6}, 720);
  const double t = 0.125;
  const Finding& v = finding(report, "limit/velocity");
  EXPECT_EQ(v.quantity, "velocity");
  EXPECT_NEAR(v.value, 15.0 / 8 * 40 / t, 1e-9);
  EXPECT_NEAR(v.where, 45, 1e-6) << "on the master";
  EXPECT_FALSE(v.broken);
  const Finding& a = finding(report, "limit/acceleration");
  EXPECT_NEAR(std::abs(a.value), 10 / std::sqrt(3) * 40 / (t * t), 1e-8);
  EXPECT_TRUE(a.broken) << a.value;
  EXPECT_EQ(a.segment, 0U);
  const Finding& j = finding(report, "limit/jerk");
  EXPECT_NEAR(j.value, 60 * 40 / (t * t * t), 1e-6);
  EXPECT_FALSE(j.broken);
}

TEST(CheckSlave, AddsTheAccelerationOfTheMaster) {
  // y = z - sin(2 pi z) / (2 pi): the greatest 2 pi w^2 sin t + a (1 - cos t) is a + sqrt((2 pi w^2)^2 + a^2).
  const Cam cam = placed("inclined_sine", 1, 1);
  for (const double a : {0.1, 1.0, 10.0}) {
    const double w = 0.7;
    const Report report = check_slave(cam, {.acceleration = 1}, w, {a, 0});
    EXPECT_NEAR(std::abs(report.findings.front().value), a + std::hypot(2 * pi * w * w, a), 1e-12)
        << a;
  }
  // A line of ratio 10 passes on the rates of its master, and their signs.
  const Report gear = check_slave(Cam({line(10, 0, 20)}),
                                  {.velocity = 5, .acceleration = 50, .jerk = 1}, 1, {3, 7});
  EXPECT_DOUBLE_EQ(finding(gear, "limit/velocity").value, 2);
  EXPECT_DOUBLE_EQ(std::abs(finding(gear, "limit/acceleration").value), 6);
  EXPECT_DOUBLE_EQ(std::abs(finding(gear, "limit/jerk").value), 14);
}

TEST(CheckSlave, JustMeetsALimitAtTheGreatestMasterVelocity) {
  test::Random random(25);
  const std::vector<const char*> names{"poly_345", "modified_sine", "inclined_sine", "gutman_13"};
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE(n);
    const Cam cam = placed(names[static_cast<std::size_t>(random.below(4))],
                           random.log_uniform(1e-3, 1e3), random.log_uniform(1e-3, 1e3));
    const Limits slave{.velocity = random.log_uniform(1e-3, 1e3),
                       .acceleration = random.log_uniform(1e-3, 1e3),
                       .jerk = random.log_uniform(1e-3, 1e3)};
    const double most = greatest_master_acceleration(cam, slave, 0).value;
    const MasterRates rates{random.uniform(0, 0.9) * most, 0};
    const MasterLimit limit = greatest_master_velocity(cam, slave, rates);
    ASSERT_GT(limit.value, 0);
    const Report at = check_slave(cam, slave, limit.value, rates);
    EXPECT_NEAR(at.findings.front().margin, 0, 1e-9);
    EXPECT_EQ(at.findings.front().quantity, limit.quantity);
    EXPECT_TRUE(check_slave(cam, slave, limit.value * (1 - 1e-6), rates).ok());
    EXPECT_FALSE(check_slave(cam, slave, limit.value * (1 + 1e-6), rates).ok());
  }
}

TEST(CheckSlave, NamesEachSegmentThatBreaksALimit) {
  const Cam up = placed("poly_345", 40, 90);
  const Cam down = placed("poly_345", -40, 60);
  const Cam cam({up.segments().front(), *sum(down.segments().front(), line(60, 40, 40))});
  const Report report = check_slave(cam, {.velocity = 500}, 720);
  ASSERT_EQ(report.findings.size(), 2U);
  EXPECT_EQ(report.findings[0].segment, 1U) << "the worst first";
  EXPECT_NEAR(report.findings[0].value, -15.0 / 8 * 40 / 60 * 720, 1e-9);
  EXPECT_EQ(report.findings[1].segment, 0U);
}

TEST(CheckSlave, RejectsRatesThatAreNone) {
  const Cam cam = placed("poly_345", 1, 1);
  EXPECT_EQ(test::key_of([&] { (void)check_slave(cam, {.velocity = 1}, 0); }), "velocity");
  EXPECT_EQ(test::key_of([&] {
              (void)check_slave(cam, {.velocity = 1}, 1, {-1, 0});
            }),
            "acceleration");
  EXPECT_EQ(test::key_of([&] { (void)check_slave(cam, {.velocity = 1}, 1, {0, -1}); }), "jerk");
  EXPECT_EQ(test::key_of([&] { (void)check_slave(cam, {.velocity = -1}, 1); }), "velocity");
}

}  // namespace
}  // namespace jounce::slave_check_test
