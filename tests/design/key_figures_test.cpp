// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/key_figures.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace jounce::key_figures_test {
namespace {

using test::error_of;
using ::testing::HasSubstr;

double figure(const Assessment& all, const std::string& name) {
  return all.value(name).value_or(std::nan(name.c_str()));
}

const char* const move = R"(jounce = 1
kind = "move"
units = { position = "mm" }
move = { profile = "trapezoid", to = 30, velocity = 10, acceleration = 20 }
[limits]
velocity = 12.5
)";

TEST(KeyFigures, OfATrapezoidAreItsClosedForms) {
  const Assessment all = assess(parse_spec(move, "move.toml"));
  EXPECT_NEAR(figure(all, "duration"), 3.5, 1e-12);  // 30/10 + 10/20
  EXPECT_NEAR(figure(all, "stroke"), 30, 1e-12);
  EXPECT_NEAR(figure(all, "peak velocity"), 10, 1e-12);
  EXPECT_NEAR(figure(all, "peak acceleration"), 20, 1e-12);
  // Two ramps of 0.5 s (mean square v^2/3) and 2.5 s at v; two ramps at a.
  EXPECT_NEAR(figure(all, "rms velocity"), std::sqrt((100.0 / 3 + 250) / 3.5), 1e-12);
  EXPECT_NEAR(figure(all, "rms acceleration"), std::sqrt(400 / 3.5), 1e-12);
  EXPECT_NEAR(figure(all, "margin"), 0.2, 1e-12);
  EXPECT_TRUE(all.report.ok());
  EXPECT_EQ(all.figures[2].unit, "s");
  EXPECT_EQ(all.figures[3].unit, "mm/s");
  EXPECT_EQ(all.value("peak torque"), std::nullopt);
}

std::string cam(const std::string& more) {
  return R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm", time = "ms" }
periodic = true
start = { master = 0, slave = 0 }
segment = [
  { law = "quintic", end = { master = 180, slave = 50 } },
  { law = "quintic", end = { master = 360, slave = 0 } },
]
)" + more;
}

/// 72 m/min over 1800 mm: 40 cuts in a minute; a list of 1500 mm and 2100 mm has the same mean.
TEST(KeyFigures, OfACutterCountItsCuts) {
  const auto cuts = [](const std::string& pieces) {
    return figure(
        assess(parse_spec("jounce = 1\nkind = \"shear\"\n"
                          "units = { position = \"mm\", master = \"mm\" }\n"
                          "[shear]\nline_speed = \"72 m/min\"\nsync_time = \"0.2 s\"\n" +
                              pieces + "\n[limits.slave]\nvelocity = 3000\nacceleration = 15000\n",
                          "shear.toml")),
        "cuts");
  };
  EXPECT_NEAR(cuts("cut_length = 1800"), 40, 1e-9);
  EXPECT_NEAR(cuts("lengths = [1500, 2100]"), 40, 1e-9);
}

TEST(KeyFigures, OfAQuinticCamAreItsCoefficients) {
  const Assessment all = assess(parse_spec(cam(R"([master]
velocity = "360 deg/s"
distance = 360
[limits.slave]
velocity = "200 mm/s"
)"),
                                           "cam.toml"));
  const double peak = 1.875 * 50 / 180;  // Cv h / b
  EXPECT_NEAR(figure(all, "peak geo_velocity"), peak, 1e-13);
  EXPECT_NEAR(figure(all, "peak geo_acceleration"), 10 / std::sqrt(3.0) * 50 / (180 * 180), 1e-13);
  EXPECT_NEAR(figure(all, "rms geo_velocity"), std::sqrt(10.0 / 7) * 50 / 180, 1e-13);
  EXPECT_NEAR(figure(all, "rms geo_acceleration"), std::sqrt(120.0 / 7) * 50 / (180 * 180), 1e-13);
  EXPECT_NEAR(figure(all, "duration"), 1000, 1e-9);
  EXPECT_NEAR(figure(all, "cycle time"), 1000, 1e-9);
  EXPECT_NEAR(figure(all, "master velocity"), 0.36, 1e-15);
  EXPECT_NEAR(figure(all, "peak velocity"), peak * 0.36, 1e-10);
  EXPECT_NEAR(figure(all, "rms velocity"), std::sqrt(10.0 / 7) * 50 / 180 * 0.36, 1e-10);
  EXPECT_NEAR(figure(all, "fastest master"), 0.2 / peak, 1e-12);
  // The limit of the slave binds: 187.5 of 200 mm/s.
  EXPECT_NEAR(figure(all, "margin"), 1 - 187.5 / 200, 1e-9);
}

TEST(KeyFigures, OfACamAloneAreNotOverTime) {
  const Assessment all = assess(parse_spec(cam(""), "cam.toml"));
  EXPECT_EQ(all.value("duration"), std::nullopt);
  EXPECT_TRUE(std::isinf(figure(all, "margin")));
}

TEST(KeyFigures, OfADriveAreThoseOfItsRun) {
  const std::string driven = std::string(move) + R"([drive]
model = "servo_400w"
position_per_rev = 10
[drive.limits]
torque = 0.001
)";
  const Spec spec = parse_spec(driven, "move.toml");
  const Assessment all = assess(spec);
  EXPECT_GT(figure(all, "peak torque"), 0.001);
  EXPECT_LT(figure(all, "rms torque"), figure(all, "peak torque"));
  EXPECT_NEAR(figure(all, "margin"), 1 - figure(all, "peak torque") / 0.001, 1e-9);
  EXPECT_FALSE(all.report.ok());
  // These figures need no drive run: then the report omits the limits of the drive.
  const Assessment quick = assess(spec, {"peak velocity", "duration"});
  ASSERT_EQ(quick.figures.size(), 2U);
  EXPECT_EQ(quick.figures[0].name, "peak velocity");
  EXPECT_TRUE(quick.report.ok());
  EXPECT_FALSE(assess(spec, {"peak velocity", "margin"}).report.ok());
}

TEST(KeyFigures, OfARigidDriveAreItsEnergies) {
  // The speed w over two ramps of 0.5 s and 2.5 s between, without an error of following.
  const Assessment all = assess(parse_spec(std::string(move) + R"([drive]
position_per_rev = 10
[drive.motor]
inertia = 1e-3
friction.viscous = 1e-4
torque_limit = 1
[drive.controller]
position_gain = 50
velocity_gain = 0.1
velocity_feed_forward = 1
torque_feed_forward = 1
friction_feed_forward = 1
)",
                                           "move.toml"));
  const double w = 2 * 3.14159265358979323846;
  const double kinetic = 1e-3 * w * w / 2;
  const double ramp = 1e-4 * w * w * 0.5 / 3;
  EXPECT_NEAR(figure(all, "energy"), kinetic + ramp + 1e-4 * w * w * 2.5, 1e-6 * kinetic);
  EXPECT_NEAR(figure(all, "regenerated energy"), kinetic - ramp, 1e-6 * kinetic);
  EXPECT_EQ(all.value("copper loss"), std::nullopt);
  EXPECT_EQ(all.value("sync following error"), std::nullopt);
  EXPECT_EQ(all.value("settling time"), std::nullopt);
}

TEST(KeyFigures, OfSeveralAxesHaveTheirNames) {
  const Assessment all = assess(parse_spec(R"(jounce = 1
kind = "axes"
units = { position = "mm" }
sync = "phase"
[[axis]]
name = "x"
to = 30
velocity = 10
acceleration = 20
limits = { velocity = 12.5 }
[[axis]]
name = "y"
to = 60
velocity = 100
acceleration = 200
)",
                                           "axes.toml"));
  EXPECT_NEAR(figure(all, "x peak velocity"), 10, 1e-9);
  EXPECT_NEAR(figure(all, "y peak velocity"), 20, 1e-9);  // on a straight line with x
  EXPECT_NEAR(figure(all, "duration"), 3.5, 1e-9);
  EXPECT_NEAR(figure(all, "margin"), 0.2, 1e-9);
}

TEST(KeyFigures, RejectANameTheyDoNotHave) {
  const Spec spec = parse_spec(move, "move.toml");
  EXPECT_THAT(error_of([&] { assess(spec, {"peak speed"}); }),
              HasSubstr("figure = \"peak speed\": must be one of stroke, knots, duration"));
  EXPECT_THAT(error_of([&] { assess(spec, {"peak velocit"}); }),
              HasSubstr("did you mean \"peak velocity\"?"));
}

}  // namespace
}  // namespace jounce::key_figures_test
