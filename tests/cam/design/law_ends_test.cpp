// SPDX-License-Identifier: Apache-2.0
// Laws between velocities, to a reversal, and with a jerk at their ends, against tests/oracle/cam_then.json.
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"

namespace jounce::law_ends_test {
namespace {

using std::numbers::pi;

const nlohmann::json& laws() {
  static const auto all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/cam_then.json"))["laws"];
  return all;
}

/// One segment of a law from 0 to 1 over a master from 0 to 1.
CamSpec one(Law law, std::optional<double> from, std::optional<double> to, const LawForm& form) {
  CamSpec spec;
  spec.start.geo_velocity = from;
  spec.segments = {{law, {1, 1, to, {}}, "", form}};
  return spec;
}

void expect_oracle(const Cam& cam, const std::string& name) {
  SCOPED_TRACE(name);
  const auto& expected = laws().at(name);
  const auto& x = expected["x"];
  ASSERT_GT(x.size(), 30U);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Jet jet = cam.jet(x[i]);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(jet[k], expected["f" + std::to_string(k)][i].get<double>(),
                  2e-14 * std::pow(20, static_cast<double>(k)))
          << "derivative " << k << " at " << x[i];
  }
}

TEST(LawEnds, AModifiedSineJoinsTwoVelocitiesBySinesOnly) {
  for (const auto& [name, values] : laws().items()) {
    if (!name.starts_with("modified_sine_gg")) continue;
    std::istringstream words(name.substr(16));
    double v0 = 0;
    double v1 = 0;
    double lambda = 0;
    words >> v0 >> v1 >> lambda;
    const Cam cam = design(one(Law::modified_sine_gg, v0, v1, {.inflection = lambda})).cam;
    expect_oracle(cam, name);
    EXPECT_EQ(cam.segments().size(), 4U) << "as LCamHdl needs";
    EXPECT_TRUE(check_continuity(with(cam, Extrapolation::refuse), 2).ok());
  }
}

TEST(LawEnds, BetweenTwoRestsItIsTheModifiedSine) {
  const Cam cam(normalized(Law::modified_sine_gg));
  const Ranges peaks = extrema(cam);
  EXPECT_NEAR(peaks[1].max.value, 4 * pi / (4 + pi), 1e-14);
  EXPECT_NEAR(peaks[2].max.value, 4 * pi * pi / (4 + pi), 1e-13);
  EXPECT_NEAR(peaks[3].max.value, 16 * pi * pi * pi / (4 + pi), 1e-11);
  const Cam plain(normalized(Law::modified_sine));
  for (double z = 0; z < 1; z += 0.03) EXPECT_EQ(cam.at(z).position, plain.at(z).position);
}

TEST(LawEnds, AHarmonicCombinationLeadsFromAVelocityToAReversal) {
  for (const auto& [name, values] : laws().items()) {
    if (!name.starts_with("harmonic_combination_gu")) continue;
    std::istringstream words(name.substr(23));
    double v0 = 0;
    double lambda = 0;
    words >> v0 >> lambda;
    CamSpec spec = one(Law::harmonic_combination_gu, v0, 0, {.inflection = lambda});
    if (v0 == 0) spec.start.geo_acceleration = 0;  // the reversal is at the other end
    const Cam cam = design(spec).cam;
    expect_oracle(cam, name);
    EXPECT_EQ(cam.segments().size(), 3U) << "as LCamHdl needs";
    // The velocity at the inflection, in closed form: m1 and m2 of a half modified sine and a quarter cosine.
    const double m1 = (4 + pi) / (4 * pi);
    const double top = (1 - v0 * lambda * (1 - m1)) / (lambda * m1 + (1 - lambda) * 2 / pi);
    EXPECT_NEAR(cam.at(lambda).geo_velocity, top, 1e-14);
    EXPECT_NEAR(cam.jet(1, Side::left)[2], -pi * top / (2 * (1 - lambda)), 1e-13);
  }
}

TEST(LawEnds, TheReversalIsAtTheEndWithoutVelocity) {
  CamSpec spec;
  spec.segments = {{Law::line, {60, 18}},
                   {Law::harmonic_combination_gu, {120, 32}},
                   {Law::harmonic_combination_gu, {180, 18}},
                   {Law::line, {240, 0}}};
  const CamDesign made = design(spec);
  EXPECT_EQ(transition(made, 1), "G-U");
  EXPECT_EQ(transition(made, 2), "U-G");
  EXPECT_TRUE(check_continuity(with(made.cam, Extrapolation::refuse), 2).ok())
      << "mirrored about the reversal";
  for (const double u : {7., 30., 59.})
    EXPECT_NEAR(made.cam.at(120 - u).position, made.cam.at(120 + u).position, 1e-12);
}

TEST(LawEnds, AnAccelerationAtTheReversalDeterminesTheInflection) {
  for (const double wanted : {-0.010, -0.02, -0.08}) {
    CamSpec spec;
    spec.segments = {{Law::line, {60, 18}}, {Law::harmonic_combination_gu, {120, 32, {}, wanted}}};
    const Cam cam = design(spec).cam;
    EXPECT_NEAR(cam.jet(120, Side::left)[2], wanted, 1e-15);
    EXPECT_NEAR(cam.jet(120, Side::left)[1], 0, 1e-15);
    EXPECT_NEAR(cam.jet(60)[1], 0.3, 1e-15);
  }
}

TEST(LawEnds, AVelocityAtBothEndsLeavesNoReversal) {
  CamSpec spec;
  spec.start.geo_velocity = 0.5;
  spec.segments = {{Law::harmonic_combination_gu, {100, 30, 0.2, {}}}};
  EXPECT_EQ(test::error_of([&] { (void)design(spec); }, "no error"),
            "start.geo_velocity = 0.5: must be 0, the value of the adjacent law "
            "`harmonic_combination_gu`: change this number or that law");
}

TEST(LawEnds, ATripleHarmonicHasTheStrokeOfItsThreeAmplitudes) {
  expect_oracle(Cam(normalized(Law::triple_harmonic)), "triple_harmonic");
  expect_oracle(Cam(normalized(Law::triple_harmonic, {.harmonics = {{6, 0.75}}})),
                "triple_harmonic 6.0 0.75");
  expect_oracle(Cam(normalized(Law::triple_harmonic, {.harmonics = {{5.25, 1.75}}})),
                "triple_harmonic 5.25 1.75");
  // The cycloid and both Freudenstein laws of two harmonics are of this family.
  const auto expect_same = [](double a1, Law law) {
    const Cam cam(normalized(Law::triple_harmonic, {.harmonics = {{a1, 0}}}));
    const Cam same(normalized(law));
    for (double z = 0; z < 1; z += 0.04)
      EXPECT_NEAR(cam.at(z).position, same.at(z).position, 1e-15);
  };
  expect_same(2 * pi, Law::inclined_sine);
  expect_same(27. / 28 * 2 * pi, Law::freudenstein13);
  expect_same(15. / 16 * 2 * pi, Law::gutman13);
  EXPECT_EQ(test::key_of([] {
              (void)normalized(Law::modified_sine, {.harmonics = {{1, 2}}});
            }),
            "harmonics");
}

TEST(LawEnds, ASepticHasTheJerkOfItsKnots) {
  CamSpec spec;
  spec.start = {0, 0, 1, -2, 30};
  spec.segments = {{Law::septic, {1, 1, 0.5, 3, -12}}};
  const Cam cam = design(spec).cam;
  expect_oracle(cam, "septic with jerk");
  spec.segments.front().law = Law::nonic;
  const Cam nonic = design(spec).cam;
  EXPECT_NEAR(nonic.jet(0)[3], 30, 1e-12);
  EXPECT_NEAR(nonic.jet(1, Side::left)[3], -12, 1e-10);
  EXPECT_EQ(resolved_knots(spec).front().geo_jerk, 30);
  spec.segments.front().law = Law::quintic;
  EXPECT_EQ(test::error_of([&] { (void)design(spec); }, "no error"),
            "start.geo_jerk = 30: needs a law with a given jerk before or after this knot: septic "
            "or nonic");
}

TEST(LawEnds, TwoSepticsMeetWithTheJerkOfTheirKnotInAnyUnits) {
  CamSpec spec;
  spec.periodic = true;
  spec.segments = {{Law::septic, {150, 30, 0.2, -0.004, 1e-4}}, {Law::septic, {360, 0}}};
  const Cam cam = design(spec).cam;
  EXPECT_TRUE(check_continuity(cam, 3).ok());
  EXPECT_NEAR(cam.at(150).geo_jerk, 1e-4, 1e-17);
}

TEST(LawEnds, TwoLinesMeetAtAnAngleIfTheControllerJoinsPositionsByLines) {
  CamSpec spec;
  spec.segments = {{Law::line, {100, 10}}, {Law::line, {200, 40}}, {Law::dwell, {300, 40}}};
  EXPECT_NE(test::error_of([&] { (void)design(spec); }, "").find("[table] rule = \"linear\""),
            std::string::npos);
  spec.velocity_steps = true;
  const Cam cam = design(spec).cam;
  EXPECT_EQ(cam.jet(50)[1], 0.1);
  EXPECT_EQ(cam.jet(150)[1], 0.3);
  EXPECT_FALSE(check_continuity(cam, 1).ok()) << "the step is reported";
  EXPECT_TRUE(check_continuity(cam, 0).ok());
  spec.segments[2] = {Law::modified_sine, {300, 80}};  // joins the second line
  EXPECT_NEAR(design(spec).cam.jet(200)[1], 0.3, 1e-15);
  spec.segments[1] = {Law::harmonic_combination, {200, 40}};  // begins at rest
  EXPECT_EQ(test::key_of([&] { (void)design(spec); }), "segment[1].law");
}

TEST(LawEnds, ABSplineHasTheSlopesOfItsControlValues) {
  CamSpec spec;
  spec.segments = {{Law::b_spline, {100, 20}}, {Law::line, {140, 30}}, {Law::quintic, {200, 40}}};
  spec.segments[0].control.values = {0, 0, 0, 10, 15, 20};
  const Cam cam = design(spec).cam;
  EXPECT_EQ(cam.segments().size(), 3U);
  EXPECT_NEAR(cam.jet(100, Side::left)[1], 0.25, 1e-15) << "5 (20 - 15) / 100";
  const auto error = [&] { return test::error_of([&] { (void)design(spec); }, "no error"); };
  spec.segments[0].control.values.back() = 21;
  EXPECT_EQ(error(),
            "segment[1].control[6] = 21: must be 20, the slave position of the knot at this end of "
            "the segment");
  spec.segments[0].control = {{0, 20}, {50}};
  EXPECT_EQ(error(),
            "segment[1].control = 2 values: must be 3 to 13 values with 1 inner knots, because the "
            "degree is values - knots - 1, from 1 to 11");
  spec.segments[0].control = {{0, 5, 20}, {130}};
  EXPECT_EQ(test::key_of([&] { (void)design(spec); }), "segment[1].knots[1]");
  spec.segments[0].control = {{0, 0, 0, 10, 12, 20}, {}};
  EXPECT_NE(error().find("slope"), std::string::npos) << "0.4 beside a line of 0.25";
}

}  // namespace
}  // namespace jounce::law_ends_test
