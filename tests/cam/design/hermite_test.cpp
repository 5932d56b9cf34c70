// SPDX-License-Identifier: Apache-2.0
#include "cam/src/laws/hermite.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "support/errors.hpp"

namespace jounce::hermite_test {
namespace {

/// x^7 - 3 x^5 + x^2 and its derivatives.
HermitePoint seventh(double x) {
  return {x, std::pow(x, 7) - 3 * std::pow(x, 5) + x * x,
          7 * std::pow(x, 6) - 15 * std::pow(x, 4) + 2 * x,
          42 * std::pow(x, 5) - 60 * std::pow(x, 3) + 2, 210 * std::pow(x, 4) - 180 * x * x};
}

TEST(Hermite, OfDegreeSevenIsThePolynomialItself) {
  const std::vector<HermitePoint> points{seventh(-1), seventh(-0.25), seventh(0.5), seventh(2)};
  const Cam cam(hermite(points), -1);
  for (double x = -1; x <= 2; x += 0.0625) {
    const HermitePoint wanted = seventh(x);
    const Jet f = cam.jet(x);
    EXPECT_NEAR(f[0], wanted.slave, 1e-13 * 40);
    EXPECT_NEAR(f[1], wanted.geo_velocity, 1e-12 * 200);
    EXPECT_NEAR(f[2], wanted.geo_acceleration, 1e-11 * 900);
    EXPECT_NEAR(f[3], *wanted.geo_jerk, 1e-11 * 3000);
  }
}

TEST(Hermite, WithoutJerkIsOfDegreeFive) {
  const auto at = [](double x) {
    return HermitePoint{x, std::pow(x, 5), 5 * std::pow(x, 4), 20 * std::pow(x, 3), {}};
  };
  const std::vector<HermitePoint> points{at(0), at(0.5), at(2)};
  const Cam cam(hermite(points), 0);
  for (const double x : {0.125, 0.5, 0.75, 1.5})
    EXPECT_NEAR(cam.jet(x)[3], 60 * x * x, 1e-11 * 240) << x;
}

CamSpec rise_and_fall() {
  CamSpec spec;
  spec.periodic = true;
  CamSegment rise{Law::hermite, {120, 50}};
  rise.points = {{.master = 60, .slave = 30, .geo_velocity = 0.6, .geo_acceleration = 0},
                 {.master = 120, .geo_velocity = 0.1, .geo_acceleration = -0.01}};
  spec.segments = {rise, {Law::quintic, {240, 0}}, {Law::dwell, {360, 0}}};
  return spec;
}

TEST(Hermite, LawBringsTheDerivativesThatItsKnotsLeaveOut) {
  const CamSpec spec = rise_and_fall();
  const auto knots = resolved_knots(spec);
  EXPECT_EQ(knots[0].geo_velocity, 0);  // the dwell's, over the seam
  EXPECT_EQ(knots[1].geo_velocity, 0.1);
  EXPECT_EQ(knots[1].geo_acceleration, -0.01);
  const Cam cam = design(spec).cam;
  EXPECT_NEAR(cam.jet(60)[0], 30, 1e-14 * 30);
  EXPECT_NEAR(cam.jet(120, Side::left)[1], 0.1, 1e-14);
  EXPECT_NEAR(cam.jet(120)[1], 0.1, 1e-14);
  EXPECT_TRUE(check_continuity(cam, 2).ok());
}

std::string complaint(const CamSpec& spec) {
  return test::error_of([&] { (void)design(spec); });
}

TEST(Hermite, LawNamesWhatIsMissingOrContradicts) {
  CamSpec spec = rise_and_fall();
  spec.segments[0].points[0].geo_velocity.reset();
  EXPECT_EQ(
      complaint(spec),
      "segment[1].points[1].geo_velocity: is missing: the law hermite needs it at every point");

  spec = rise_and_fall();
  spec.segments[0].end.geo_velocity = 0.2;
  EXPECT_EQ(complaint(spec),
            "segment[1].points[2].geo_velocity = 0.1: must be 0.2, as at its knot");

  spec = rise_and_fall();
  spec.segments[0].points[0].geo_jerk = 0.1;
  EXPECT_EQ(complaint(spec),
            "segment[1].points = 2: must all have a geo_jerk or none, points at both ends of the "
            "segment included: at 0 there is none");

  spec = rise_and_fall();
  spec.segments[0].points[0].tolerance = 0.1;
  EXPECT_EQ(complaint(spec),
            "segment[1].points[1].tolerance = 0.1: a hermite law passes through its points "
            "exactly: use `quintic_spline` for a tolerance");
  EXPECT_THROW((void)hermite(std::vector<HermitePoint>{{0, 0}}), InputError);
  EXPECT_THROW((void)hermite(std::vector<HermitePoint>{{0, 0}, {0, 1}}), InputError);
  EXPECT_THROW((void)hermite(std::vector<HermitePoint>{{0, 0}, {1, std::nan("")}}), InputError);
}

}  // namespace
}  // namespace jounce::hermite_test
