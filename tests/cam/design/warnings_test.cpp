// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/warnings.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"

#include "cam/laws/laws.hpp"

namespace jounce::warnings_test {
namespace {

std::size_t count(const Report& report, const std::string& rule) {
  std::size_t n = 0;
  for (const Finding& f : report.findings) n += f.rule == rule ? 1 : 0;
  return n;
}

const Finding& get(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return f;
  ADD_FAILURE() << "no " << rule;
  static const Finding none;
  return none;
}

/// Rest to slope k, quintic, stroke 1 over length 1: rho = k.
Report of_rho(double rho) {
  return warnings(Cam({quintic(1, 0, 0, 0, 1, rho, 0)}));
}

TEST(Warnings, TheDefaultCamOfCodesysOvershootsItsVelocity) {
  CamSpec spec;  // 0, 120, 240, 360; V 0, 1, 1, 0
  spec.start = {0, 0, 0.0, 0.0};
  spec.segments = {{Law::quintic, {120, 120, 1.0, 0.0}, ""},
                   {Law::quintic, {240, 240, 1.0, 0.0}, ""},
                   {Law::quintic, {360, 360, 0.0, 0.0}, ""}};
  const CamDesign made = design(spec);
  const Report odd = warnings(made.cam, made.origin);
  EXPECT_TRUE(odd.ok()) << "a warning is not broken";
  EXPECT_EQ(odd.warnings(), 2U) << "first and last segment, and nothing else";
  const Finding& first = get(odd, "warning/velocity_overshoot");
  EXPECT_EQ(first.limit, 1);
  // rho = 1: f'' = 12 z (1 - z)(3 - 5 z) is 0 at 3/5, f' = z^2 (18 - 32 z + 15 z^2) = 1.512 there.
  EXPECT_NEAR(first.value, 1.512, 1e-12);
  EXPECT_NEAR(first.where, 72, 1e-9);
  EXPECT_EQ(first.advice,
            "a quintic overshoots unless the slope of the moving end * length / stroke is 5/3 to "
            "5/2, here "
            "1: use a length from 200 to 300, or a stroke from 48 to 72");
}

TEST(Warnings, TheWindowOfRhoHasItsEdgesAt5Over3And5Over2) {
  for (const double rho : {5.0 / 3, 1.7, 2.0, 2.4, 2.5}) {
    SCOPED_TRACE(rho);
    EXPECT_EQ(of_rho(rho).warnings(), 0U);
  }
  EXPECT_EQ(count(of_rho(1.66), "warning/velocity_overshoot"), 1U);
  EXPECT_EQ(count(of_rho(1.66), "warning/reversal"), 0U);
  EXPECT_EQ(count(of_rho(2.51), "warning/velocity_overshoot"), 0U);
  EXPECT_EQ(count(of_rho(2.51), "warning/reversal"), 1U);
  EXPECT_EQ(count(of_rho(2.51), "warning/overshoot"), 1U) << "it dips below its start";
  // Mirrored and falling: the same.
  const Cam one({quintic(1, 0, 0, 0, 1, 1, 0)});
  EXPECT_EQ(count(warnings(reversed(one)), "warning/velocity_overshoot"), 1U);
  EXPECT_EQ(count(warnings(scaled(one, -7, 1e6)), "warning/velocity_overshoot"), 1U);
}

TEST(Warnings, ARiseThatEndsInASlowDriftMustBeFasterThanTheDrift) {
  // 80 in 110 deg, then 2 in 30 deg: the mean velocity of the rise is eleven times that of its end.
  const double k = 2.0 / 30;
  const Cam cam({line(60, 0, 0), quintic(110, 0, 0, 0, 80, k, 0), line(30, 80, 82),
                 quintic(160, 82, k, 0, 0, 0, 0)},
                0, Extrapolation::wrap);
  const Report odd = warnings(cam);
  const Finding& drift = get(odd, "warning/velocity_overshoot");
  EXPECT_EQ(drift.severity, Severity::note);
  EXPECT_EQ(drift.advice, "");
}

TEST(Warnings, NoRemedyIsLongerThanThePeriod) {
  // rho = 1.25 in 200 of 300: the lengths from 267 to 400 do not fit.
  const Cam cam(
      {quintic(200, 0, 0, 0, 160, 1, 0), line(50, 160, 210), quintic(50, 210, 1, 0, 0, 0, 0)}, 0,
      Extrapolation::wrap);
  const Report odd = warnings(cam);
  const Finding& f = get(odd, "warning/velocity_overshoot");
  EXPECT_EQ(f.severity, Severity::warning);
  EXPECT_EQ(
      f.advice,
      "a quintic overshoots unless the slope of the moving end * length / stroke is 5/3 to 5/2, "
      "here 1.25: use a stroke from 80 to 120");
}

TEST(Warnings, OvershootHasItsSizeAndWhetherItIsInevitable) {
  // Ends at rest but accelerating hard: the slave swings beyond.
  const Report swing = warnings(Cam({quintic(1, 0, 0, -80, 1, 0, 0)}));
  const Finding& below = get(swing, "warning/overshoot");
  EXPECT_EQ(below.severity, Severity::warning);
  EXPECT_LT(below.value, 0);
  EXPECT_EQ(below.limit, 0);
  EXPECT_NEAR(below.margin, below.value / (1 - below.value), 1e-12) << "share of the travel";
  // Starts upwards and must come down: it cannot but pass its start.
  const Report turn = warnings(Cam({quintic(1, 0, 1, 0, -1, 0, 0)}));
  EXPECT_EQ(get(turn, "warning/overshoot").severity, Severity::note);
}

TEST(Warnings, GroupThePiecesOfALaw) {
  CamSpec spec;
  spec.start = {0, 0, {}, {}};
  spec.segments = {{Law::modified_sine, {120, 50, {}, {}}, ""},
                   {Law::dwell, {240, 50, {}, {}}, ""},
                   {Law::modified_trapezoid, {360, 0, {}, {}}, ""}};
  spec.periodic = true;
  const CamDesign made = design(spec);
  EXPECT_EQ(warnings(made.cam, made.origin).warnings(), 0U);
}

TEST(Warnings, NameEachStepOnceByItsLowestOrder) {
  const auto law = [](const char* name) { return test::laws().at(name); };
  const Report sine = warnings(law("simple_sine"));  // holds: from rest and to rest
  EXPECT_EQ(count(sine, "joint/geo_acceleration"), 2U);
  EXPECT_NEAR(get(sine, "joint/geo_acceleration").value, 4.934802200544679, 1e-12);
  const Report poly = warnings(law("poly_345"));
  EXPECT_EQ(poly.warnings(), 0U);
  EXPECT_EQ(count(poly, "joint/geo_jerk"), 2U) << "a note each";
  const Report straight = warnings(Cam({line(1, 0, 1), line(1, 1.5, 2)}, 0, Extrapolation::wrap));
  EXPECT_EQ(count(straight, "joint/position"), 2U) << "inside and at the wrap";
  EXPECT_EQ(get(straight, "joint/position").where, 2) << "the worst first: back from 2 to 0";
  EXPECT_EQ(count(straight, "joint/geo_velocity"), 0U);
}

TEST(Warnings, RippleIsAnAccelerationThatTurnsBetweenEqualEnds) {
  EXPECT_EQ(count(warnings(Cam({quintic(1, 0, 0, 2, 1, 2, 2)})), "warning/ripple"), 0U)
      << "a parabola";
  EXPECT_EQ(count(warnings(Cam({quintic(1, 0, 0, 2, 1.5, 2, 2)})), "warning/ripple"), 1U);
}

}  // namespace
}  // namespace jounce::warnings_test
