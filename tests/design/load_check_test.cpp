// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/load_check.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/design/detail/load_figures.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::load_check_test {
namespace {

/// A rise of 30 mm over 90 deg by the inclined sine, a dwell until 360 deg, at 720 deg/s.
std::string spec(const std::string& load, bool master = true) {
  return "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
         "start = { master = 0, slave = 0 }\n"
         "[[segment]]\nlaw = \"inclined_sine\"\nend = { master = 90, slave = 30 }\n"
         "[[segment]]\nlaw = \"dwell\"\nend = { master = 360, slave = 30 }\n" +
         (master ? std::string("[master]\nvelocity = 720\ndistance = 360\n") : std::string()) +
         "[load]\nposition_per_rev = 100\ninertia = \"4 kg cm^2\"\n" + load;
}

Report checked(const std::string& load) {
  const Spec made = parse_spec(spec(load), "a.toml");
  return check_load(made, std::get<Cam>(*make(made).curve));
}

/// f'' = 2 pi h / beta^2 sin(2 pi x / beta), so that T = J (2 pi / position_per_rev) w^2 f''.
constexpr double pi = std::numbers::pi;
const double peak = 4e-4 * (2 * pi / 100) * 720 * 720 * (2 * pi * 30 / (90.0 * 90.0));

TEST(LoadCheck, PeakAndRmsAreThoseOfTheClosedForm) {
  const Report report = checked("[load.limits]\ntorque = 0.3\nrms_torque = 0.15\n");
  ASSERT_EQ(report.findings.size(), 2U);
  const Finding& torque = report.findings[0];
  EXPECT_EQ(torque.rule, "limit/load_torque");
  EXPECT_NEAR(std::abs(torque.value), peak, 1e-12 * peak);
  EXPECT_NEAR(std::abs(std::sin(2 * pi * torque.where / 90)), 1, 1e-9);
  EXPECT_EQ(torque.segment, 0U);
  EXPECT_EQ(torque.broken, peak > 0.3);
  EXPECT_NEAR(torque.margin, 1 - peak / 0.3, 1e-12);
  const Finding& rms = report.findings[1];
  EXPECT_EQ(rms.rule, "limit/load_rms_torque");
  EXPECT_NEAR(rms.value, peak * std::sqrt(0.5 * 90 / 360), 1e-9 * peak);
}

// P = T w_m, with f' = h / beta (1 - cos(2 pi x / beta)): sin(a) (1 - cos(a)) is greatest at 120 deg,
// 3 sqrt(3) / 4.
TEST(LoadCheck, FiguresAreThoseOfTheClosedForm) {
  const Spec made = parse_spec(spec("winding_loss = 1.5\n"), "a.toml");
  const Cam cam = std::get<Cam>(*make(made).curve);
  const std::vector<LoadFigure> all = load_figures(made, cam);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].name, "peak torque");
  EXPECT_NEAR(all[0].value, peak, 1e-12 * peak);
  EXPECT_EQ(all[1].name, "rms torque");
  const double rms = peak * std::sqrt(0.5 * 90 / 360);
  EXPECT_NEAR(all[1].value, rms, 1e-9 * peak);
  EXPECT_EQ(all[2].name, "peak power");
  const double power = peak * (2 * pi / 100) * 720 * (30 / 90.0) * 3 * std::sqrt(3.0) / 4;
  EXPECT_NEAR(all[2].value, power, 2e-9 * power);
  EXPECT_NEAR(std::abs(all[2].where.value_or(0) - 45), 15, 1e-2);
  EXPECT_EQ(all[3].name, "motor heating");
  EXPECT_NEAR(all[3].value, 1.5 * rms * rms, 1e-8);
  EXPECT_TRUE(load_figures(parse_spec(spec("", false), "a.toml"), cam).empty());
}

// The curves of a polynomial law: the power is the product of torque and speed everywhere.
TEST(LoadCheck, CurvesAreTorqueAndPower) {
  std::string text = spec("mass = 2\n");
  text.replace(text.find("inclined_sine"), 13, "345");
  const Spec made = parse_spec(text, "a.toml");
  const Cam cam = std::get<Cam>(*make(made).curve);
  const auto curves = load_curves(made, cam);
  ASSERT_TRUE(curves && curves->power);
  const double radius = 0.1 / (2 * pi);  // m per rad
  for (double x = 0; x <= 90; x += 0.37) {
    const Jet f = cam.jet(x);
    const double speed = 2 * pi / 100 * 720 * f[1];
    const double torque = (4e-4 + 2 * radius * radius) * 2 * pi / 100 * 720 * 720 * f[2];
    EXPECT_NEAR(curves->torque.jet(x)[0], torque, 1e-12);
    EXPECT_NEAR(curves->power->jet(x)[0], torque * speed, 1e-10);
  }
}

TEST(LoadCheck, DryFrictionAddsToTheTorqueThatDrives) {
  const Report report = checked("coulomb = 0.05\n[load.limits]\ntorque = 2\n");
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NEAR(report.findings[0].value, peak + 0.05, 1e-12 * peak);
  EXPECT_NEAR(report.findings[0].where, 22.5, 1e-6) << "where it speeds up";
  EXPECT_FALSE(report.findings[0].broken);
}

TEST(LoadCheck, NeedsLimitsAndASpeed) {
  EXPECT_TRUE(checked("").findings.empty());
  const auto read = [](const std::string& load, bool master) {
    return test::error_of([&] { (void)parse_spec(spec(load, master), "a.toml"); });
  };
  EXPECT_NE(read("[load.limits]\ntorque = 1\n", false).find("add [master]"), std::string::npos);
  EXPECT_NE(read("[load.limits]\ntorque = 0\n", true).find("must be greater than 0"),
            std::string::npos);
}

}  // namespace
}  // namespace jounce::load_check_test
