// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/arc.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce::arc_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Plane xy{0, 1};

void expect_point(const Point& p, const Point& q, double tolerance = 1e-9) {
  for (std::size_t i = 0; i < max_axes; ++i) EXPECT_NEAR(p[i], q[i], tolerance) << i;
}

TEST(Arc, ThroughAPoint) {
  // HMPL manual 8.2.13: a clockwise half circle.
  const Arc arc = arc_through({}, {100, 100}, {200, 0}, 2);
  expect_point(arc.center, {100, 0});
  EXPECT_NEAR(arc.radius, 100, 1e-12);
  EXPECT_NEAR(arc.sweep, pi, 1e-12);
  expect_point(point_at(arc, pi / 2), {100, 100});
  expect_point(point_at(arc, arc.sweep), {200, 0});
  const Arc major = arc_through({1, 0}, {-1, 0}, {0, -1}, 2);
  EXPECT_NEAR(major.sweep, 1.5 * pi, 1e-12);
  EXPECT_NEAR(arc_through({1, 0}, {-1, 0}, {0, -1}, 2, 2).sweep, 5.5 * pi, 1e-12);
}

TEST(Arc, InSpaceHasTheSameDistanceFromItsCenter) {
  const Point from{1, 2, 3}, via{4, -1, 2}, to{0, 5, 7};
  const Arc arc = arc_through(from, via, to, 3);
  expect_point(point_at(arc, 0), from);
  expect_point(point_at(arc, arc.sweep), to);
  double nearest = 1e9;
  for (int i = 0; i <= 100000; ++i) {
    const Point p = point_at(arc, arc.sweep * i / 100000);
    nearest = std::min(nearest, std::hypot(p[0] - via[0], p[1] - via[1], p[2] - via[2]));
  }
  EXPECT_LT(nearest, 1e-3);
}

TEST(Arc, AboutACenter) {
  // HMPL manual 8.2.17.
  const Arc arc = arc_about({}, {100, 0}, {200, 0}, xy, ArcRotation::counterclockwise);
  expect_point(point_at(arc, pi / 2), {100, -100});
  EXPECT_NEAR(arc_about({}, {100, 0}, {}, xy, ArcRotation::clockwise).sweep, 2 * pi, 1e-12);
  const Arc moved = arc_about({}, {100.002, 0}, {200, 0}, xy, ArcRotation::clockwise);
  EXPECT_NEAR(moved.center_moved, 0.002, 1e-9);
  expect_point(moved.center, {100, 0});
  EXPECT_THROW(arc_about({}, {100.2, 0}, {200, 0}, xy, ArcRotation::clockwise), InputError);
  EXPECT_THROW(arc_about({}, {}, {200, 0}, xy, ArcRotation::clockwise), InputError);
}

TEST(Arc, HimcTurns) {
  // HMPL manual 8.2.17: theta = 210 degrees, turns -2, -1, 0, 1, 2.
  const Point from{100, 0};
  const double theta = 210 * pi / 180;
  const Point to{100 * std::cos(theta), 100 * std::sin(theta)};
  const int turns[] = {-2, -1, 0, 1, 2};
  const double sweeps[] = {-510, -150, 210, 210, 570};
  for (std::size_t i = 0; i < 5; ++i) {
    const CircleTurns how = himc_turns(turns[i]);
    const Arc arc = arc_about(from, {}, to, xy, how.rotation, how.extra_turns);
    const double sign = how.rotation == ArcRotation::counterclockwise ? 1 : -1;
    EXPECT_NEAR(sign * arc.sweep * 180 / pi, sweeps[i], 1e-9);
  }
}

TEST(Arc, OfARadius) {
  const Arc minor = arc_of_radius({}, 100, {100, 0}, xy, ArcRotation::clockwise);
  const Arc major = arc_of_radius({}, -100, {100, 0}, xy, ArcRotation::clockwise);
  EXPECT_NEAR(minor.sweep, pi / 3, 1e-12);
  EXPECT_NEAR(major.sweep, 2 * pi - pi / 3, 1e-12);
  EXPECT_GT(point_at(minor, minor.sweep / 2)[1],
            0);  // clockwise from left to right: above the chord
  // PMC600 Example 8.3: centers (5000, 0) and (20000, 0), extremes (5000, 5000) and (20000, -10000).
  expect_point(point_at(arc_of_radius({}, 5000, {10000, 0}, xy, ArcRotation::clockwise), pi / 2),
               {5000, 5000}, 1e-8);
  expect_point(
      point_at(arc_of_radius({10000, 0}, 10000, {30000, 0}, xy, ArcRotation::counterclockwise),
               pi / 2),
      {20000, -10000}, 1e-8);
  EXPECT_THROW(arc_of_radius({}, 49, {100, 0}, xy, ArcRotation::clockwise), InputError);
  EXPECT_THROW(arc_of_radius({}, 49, {}, xy, ArcRotation::clockwise), InputError);
  EXPECT_THROW(arc_of_radius({300, 100}, 5, {300 + 1e-10, 100}, xy, ArcRotation::clockwise),
               InputError)
      << "a rounded end at the start";
}

TEST(Arc, ByAnAngle) {
  // HMPL manual 8.2.16: from (0, 0) about (10, 10) by 45 degrees.
  const Arc arc = arc_by_angle({}, {10, 10}, 45, {}, xy);
  expect_point(arc.to, {10, 10 - 10 * std::sqrt(2.0)});
  expect_point(point_at(arc, arc.sweep), arc.to);
  EXPECT_NEAR(arc_by_angle({}, {10, 10}, -750, {}, xy).sweep, 750 * pi / 180, 1e-12);
}

TEST(Arc, RejectsPointsOnALine) {
  EXPECT_THROW(arc_through({}, {1, 1}, {2, 2}, 2), InputError);
  EXPECT_THROW(arc_through({}, {}, {2, 2}, 2), InputError);
  EXPECT_THROW(arc_through({}, {1, 1}, {}, 2), InputError);
  EXPECT_THROW(arc_through({}, {1, 1e-12}, {2, 0}, 2), InputError);
}

TEST(Arc, OtherPlanesAndHelices) {
  const Arc arc =
      arc_about({0, 0, 0}, {0, 0, 10}, {5, 10, 10}, Plane{1, 2}, ArcRotation::counterclockwise);
  expect_point(point_at(arc, 0), {});
  expect_point(point_at(arc, arc.sweep), {5, 10, 10});
  EXPECT_NEAR(arc.sweep, pi / 2, 1e-12);
  EXPECT_THROW(arc_about({}, {1, 0}, {2, 0}, Plane{1, 1}, ArcRotation::clockwise), InputError);
}

}  // namespace
}  // namespace jounce::arc_test
