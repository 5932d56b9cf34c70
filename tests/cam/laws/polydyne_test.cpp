// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/polydyne.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/invariants.hpp"
#include "support/random.hpp"
#include "support/spring.hpp"

namespace jounce::polydyne_test {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

Cam rise(Law law) {
  return Cam(normalized(law), 0, Extrapolation::hold);
}

/// The same segments over time.
Trajectory played(const Cam& cam) {
  return Trajectory({cam.segments().begin(), cam.segments().end()}, cam.start());
}

double residual(const Cam& cam, const Mode& mode) {
  return residual_vibration(played(cam), mode);
}

TEST(Polydyne, HasTheBenchmarksPeaksAndLeavesNothing) {
  const Mode mode{12 / two_pi, 0};
  const Polydyne made = polydyne(rise(Law::poly56789), mode);
  EXPECT_NEAR(std::abs(extrema(made.cam, 2).peak().value), 5.261407, 5e-7);
  EXPECT_NEAR(std::abs(extrema(made.cam, 1).peak().value), 315.0 / 128 - 78.75 / 144, 1e-12)
      << "1.914063";
  EXPECT_LT(residual(made.cam, mode), 1e-12);
  EXPECT_GT(residual(rise(Law::poly56789), mode), 1e-2) << "what the plain law leaves";
  EXPECT_TRUE(made.warnings.findings.empty());
  test::expect_invariants(made.cam, 2);
}

/// An integration that shares nothing with the closed form: the load is at the output's place, not
/// only at the end but everywhere on the way.
TEST(Polydyne, MovesTheLoadAlongTheOutput) {
  const Mode mode{9 / two_pi, 0.07};
  const Cam output = rise(Law::poly56789);
  const Cam cam = polydyne(output, mode).cam;
  for (const double until : {0.2, 0.5, 0.77, 1.0}) {
    const Segment& whole = cam.segments().front();
    const Segment head = until < 1 ? part(whole, 0, until) : whole;
    const test::Load load = test::after(Trajectory({head}), mode);
    EXPECT_NEAR(load.x, output.at(until).position, 1e-10) << until;
    EXPECT_NEAR(load.v, output.at(until).geo_velocity, 1e-9) << until;
  }
}

TEST(Polydyne, IsExactOnSinesAndEveryLengthStrokeAndPlace) {
  test::Random random(7);
  for (int n = 0; n < 50; ++n) {
    const double length = random.log_uniform(1e-3, 1e3);
    const double stroke = random.uniform(-5, 5) * random.log_uniform(1e-3, 1e3);
    const double start = random.uniform(-10, 10) * length;
    const Mode mode{random.log_uniform(0.4, 5) / length, random.uniform(0, 0.3)};
    SCOPED_TRACE(::testing::Message()
                 << "case " << n << ": length " << length << ", stroke " << stroke << ", frequency "
                 << mode.frequency << ", damping " << mode.damping);
    const Cam output = shifted(scaled(rise(Law::poly56789), stroke, length), start);
    const Polydyne made = polydyne(output, mode);
    EXPECT_LT(residual(made.cam, mode), 1e-12 * std::abs(stroke));
    const double w = two_pi * mode.frequency;
    const Transfer y = output.at(start + 0.3 * length);
    EXPECT_NEAR(made.cam.at(start + 0.3 * length).position,
                y.position + 2 * mode.damping / w * y.geo_velocity + y.geo_acceleration / (w * w),
                1e-12 * std::abs(stroke));
    EXPECT_EQ(made.cam.outside(), Extrapolation::hold);
  }
  // A periodic output of sines alone: its cam has the same sine, in the proportion of the response.
  Segment turn;
  turn.length = 360;
  turn.sines = 1;
  turn.sine[0] = {2, two_pi, 0.4};
  const Mode mode{3.0 / 360, 0};
  const Cam cam = polydyne(Cam({turn}, 0, Extrapolation::wrap), mode).cam;
  EXPECT_NEAR(extrema(cam, 0).max.value, 2 * (1 - 1.0 / 9), 1e-12);
}

/// The trap: with 4-5-6-7 as output the cam starts with f'' = 840 / w^2.
TEST(Polydyne, ReportsAnOutputThatIsNotSmoothEnough) {
  const Mode mode{12 / two_pi, 0};
  const Polydyne knocks = polydyne(rise(Law::poly4567), mode);
  ASSERT_EQ(knocks.warnings.findings.size(), 1U);
  const Finding& step = knocks.warnings.findings.front();
  EXPECT_EQ(step.rule, "polydyne/geo_acceleration");
  EXPECT_NEAR(step.value, 840.0 / 144, 1e-10);
  EXPECT_EQ(step.severity, Severity::warning);
  EXPECT_NEAR(knocks.cam.at(0).geo_acceleration, 840.0 / 144, 1e-12);
  EXPECT_LT(residual(knocks.cam, mode), 1e-9) << "it is exact all the same";

  const auto refused = [&](Law law, const char* word) {
    try {
      (void)polydyne(rise(law), mode);
      ADD_FAILURE() << name(law);
    } catch (const InputError& error) {
      EXPECT_EQ(error.key(), "polydyne");
      EXPECT_NE(error.rule().find(word), std::string::npos) << error.what();
    }
  };
  refused(Law::poly345, "the cam's geo_velocity");  // y''' = 60 at its ends
  refused(Law::simple_sine, "output's geo_acceleration");
  refused(Law::line, "output's geo_velocity");
}

TEST(Polydyne, RejectsAModeOutOfRange) {
  for (const Mode mode : {Mode{0, 0}, Mode{-1, 0}, Mode{NAN, 0}, Mode{1, 1}, Mode{1, -0.1}})
    EXPECT_THROW((void)polydyne(rise(Law::poly56789), mode), InputError);
}

}  // namespace
}  // namespace jounce::polydyne_test
