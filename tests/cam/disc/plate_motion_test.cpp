// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/disc/plate_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "cam/disc/disc_cams.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::plate_motion_test {
namespace {

constexpr double deg = std::numbers::pi / 180;

std::vector<double> masters(int n) {
  std::vector<double> all;
  for (int i = 0; i <= n; ++i) all.push_back(360.0 * i / n);
  return all;
}

/// A circle of two arcs.
Contour circle(double x, double y, double radius) {
  return {{x + radius, y, 1}, {x - radius, y, 1}};
}

// An eccentric circle of radius R at the distance s, at the angle b at master 0, and a roller of
// radius r on the line x = e: the centers are R + r apart, so y = s sin(b + t) + sqrt((R + r)^2 -
// (e - s cos(b + t))^2).
TEST(PlateMotion, AnEccentricCircleHasAClosedForm) {
  constexpr double big = 30, s = 7, b = 0.4, e = 2.5;
  const Contour plate = circle(s * std::cos(b), s * std::sin(b), big);
  const std::vector<double> at = masters(100'000);
  for (const double r : {0.0, 8.0}) {
    for (const int sign : {1, -1}) {
      const Rotation rotation = sign > 0 ? Rotation::counterclockwise : Rotation::clockwise;
      const PlateMotion motion =
          plate_motion(plate, {.roller_radius = r, .offset = e, .rotation = rotation}, at);
      const auto y = [&](double master) {
        const double angle = b + sign * master * deg;
        const double across = e - s * std::cos(angle);
        return s * std::sin(angle) + std::sqrt((big + r) * (big + r) - across * across);
      };
      double least = 1e9, greatest = 0;
      for (const double master : at) least = std::min(least, y(master));
      for (std::size_t i = 0; i < at.size(); ++i)
        greatest = std::max(greatest, std::abs(motion.slave[i] - (y(at[i]) - least)));
      EXPECT_LE(greatest, 1e-13 * big) << r << " " << sign;
      EXPECT_NEAR(motion.base_radius, std::hypot(e, least) - r, 1e-13 * big);
    }
  }
}

// Under an arm: the triangle of pivot, roller and center of the circle gives its angle.
TEST(PlateMotion, AnEccentricCircleUnderAnArmHasAClosedForm) {
  constexpr double big = 30, s = 6, r = 8, arm = 60, pivot = 70;
  const Contour plate = circle(0, s, big);
  const std::vector<double> at = masters(100'000);
  const PlateMotion motion = plate_motion(plate,
                                          {.follower = Follower::oscillating,
                                           .roller_radius = r,
                                           .arm_length = arm,
                                           .center_distance = pivot,
                                           .arm_angle = deg},
                                          at);
  const auto psi = [&](double master) {
    const double x = s * std::cos(90 * deg + master * deg),
                 y = s * std::sin(90 * deg + master * deg);
    const double d = std::hypot(pivot - x, y);
    const double toward = std::atan2(y, pivot - x);  // from the line of centers to the circle
    return (toward + std::acos((arm * arm + d * d - (big + r) * (big + r)) / (2 * arm * d))) / deg;
  };
  double least = 1e9, greatest = 0;
  for (const double master : at) least = std::min(least, psi(master));
  for (std::size_t i = 0; i < at.size(); ++i)
    greatest = std::max(greatest, std::abs(motion.slave[i] - (psi(at[i]) - least)));
  EXPECT_LE(greatest, 1e-11);
}

// A square: a roller above an edge is at a + r; at a corner it turns around the corner.
TEST(PlateMotion, ASquareHasAClosedForm) {
  constexpr double a = 20, r = 5;
  const Contour square{{a, -a}, {a, a}, {-a, a}, {-a, -a}};
  const PlateMotion motion = plate_motion(square, {.base_radius = a, .roller_radius = r},
                                          std::vector{0.0, 90.0, 10.0, 45.0, 50.0});
  const auto above_edge = [&](double t) { return (a + r) / std::cos(t * deg) - (a + r); };
  EXPECT_NEAR(motion.slave[0], 0, 1e-13);
  EXPECT_NEAR(motion.slave[1], 0, 1e-13);
  EXPECT_NEAR(motion.slave[2], above_edge(10), 1e-13);
  EXPECT_NEAR(motion.slave[3], a * std::sqrt(2.0) + r - (a + r), 1e-13);
  const double x = a * std::sqrt(2.0) * std::sin(5 * deg),
               y = a * std::sqrt(2.0) * std::cos(5 * deg);
  // At 50 deg (as at 40 deg) the foot of the roller would be (a + r) tan 40 deg from the middle of the
  // edge, beyond the corner.
  EXPECT_GT((a + r) * std::tan(40 * deg), a);
  EXPECT_NEAR(motion.slave[4], y + std::sqrt(r * r - x * x) - (a + r), 1e-13);
}

// A roller that is larger than a round hollow rests on its two corners.
TEST(PlateMotion, ARollerBridgesANarrowHollow) {
  constexpr double a = 20, half = 3;
  // Square with a half-circle cut out of its upper edge: at master 0 the roller is above it.
  const Contour plate{{a, -a}, {a, a}, {half, a, -1}, {-half, a}, {-a, a}, {-a, -a}};
  const auto at_0 = [&](double r) {
    return plate_motion(plate, {.base_radius = a, .roller_radius = r}, std::vector{0.0}).slave[0];
  };
  EXPECT_NEAR(at_0(2), -half, 1e-13) << "at the bottom of the hollow";
  EXPECT_NEAR(at_0(5), std::sqrt(25.0 - half * half) - 5, 1e-13) << "on both corners";
}

// The plate of a disc, drawn within a tolerance, gives back the motion of the disc.
TEST(PlateMotion, IsTheInverseOfTheContour) {
  constexpr double tolerance = 1e-5;
  test::Random random(25);
  int plates = 0;
  for (int i = 0; i < 200; ++i) {
    const auto [disc, text] = test::random_disc(random);
    SCOPED_TRACE(text);
    const DiscSpec& spec = disc.spec();
    const DiscExtremes e = extremes(disc);
    const double steepest = std::abs(e.pressure_angle.peak().value);
    const bool is_cut = e.pitch_curvature.max.value * spec.roller_radius > 0.99 || steepest > 1.3 ||
                        interference(disc, spec.roller_radius);
    if (is_cut) continue;
    ++plates;
    const std::vector<double> at = masters(500);
    const PlateMotion motion =
        plate_motion(contour(disc, -spec.roller_radius, tolerance), spec, at);
    double greatest = 0;
    for (std::size_t k = 0; k < at.size(); ++k)
      greatest = std::max(greatest, std::abs(motion.slave[k] - disc.lift().jet(at[k])[0]));
    EXPECT_LE(greatest, 1.2 * tolerance / std::cos(steepest));
  }
  EXPECT_GT(plates, 20);
}

TEST(PlateMotion, RejectsAPlateThatTheFollowerDoesNotMeet) {
  const auto error = [](const Contour& plate, const DiscSpec& spec) {
    return test::error_of([&] { (void)plate_motion(plate, spec, masters(8)); });
  };
  EXPECT_EQ(error({{1, 0}}, {.base_radius = 1}), "profile = 1 vertices: must be at least 2");
  EXPECT_EQ(error(circle(0, 0, 10), {.offset = 12}),
            "profile: is not met by the follower at master 0: check the place of the "
            "center and the lengths of the follower");
}

}  // namespace
}  // namespace jounce::plate_motion_test
