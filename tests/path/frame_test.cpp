// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/frame.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/path/rotary.hpp"
#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

namespace jounce::frame_test {
namespace {

Point at(const Frame& frame, const Point& part) {
  return placed(frame, part);
}

void expect_point(const Point& p, const Point& wanted, double tolerance = 1e-12) {
  for (std::size_t i = 0; i < max_axes; ++i) EXPECT_NEAR(p[i], wanted[i], tolerance) << i;
}

TEST(Frame, TurnsFromTheFirstAxisToTheSecond) {
  expect_point(at(turned_frame({10, 20, 5}, 90), {1, 0, 2}), {10, 21, 7}, 0);
  expect_point(at(turned_frame({10, 20, 5}, 30), {2, 0, 0}), {10 + std::sqrt(3.0), 21, 5});
  EXPECT_TRUE(turned_frame({1, 2, 3}, 0).shifts());
}

TEST(Frame, EulerAnglesAreAboutZThenYThenZ) {
  // R = Rz(a) Ry(b) Rz(c), columns written out; b alone tilts Z towards X.
  expect_point(at(euler_frame({}, {0, 90, 0}), {0, 0, 1}), {1, 0, 0}, 0);
  expect_point(at(euler_frame({}, {90, 90, 0}), {0, 0, 1}), {0, 1, 0}, 0);
  expect_point(at(euler_frame({}, {0, 90, 90}), {1, 0, 0}), {0, 1, 0}, 0);
  const double a = 0.3, b = -0.7, c = 1.1;
  const double deg = 180 / std::numbers::pi;
  expect_point(at(euler_frame({}, {a * deg, b * deg, c * deg}), {1, 0, 0}),
               {std::cos(a) * std::cos(b) * std::cos(c) - std::sin(a) * std::sin(c),
                std::sin(a) * std::cos(b) * std::cos(c) + std::cos(a) * std::sin(c),
                -std::sin(b) * std::cos(c)});
}

TEST(Frame, WithinIsTheInverse) {
  const Frame frame = euler_frame({10, -20, 30, 4}, {20, 40, -60});
  const Point p{1.5, -2, 7, 9};
  expect_point(within(frame, placed(frame, p)), p);
}

Program shapes() {
  Program p(3);
  p.set({.velocity = 100, .acceleration = 1000, .jerk = 1e4});
  p.line({50, 0, 5}, 1);
  p.arc(arc_about(p.position(), {50, 30, 0}, {80, 30, 15}, Plane{0, 1},
                  ArcRotation::counterclockwise),
        2);
  p.dwell(0.2, 3);
  p.curve(ellipse(p.position(), {80, 60}, {80, 90, 15}, Plane{0, 1}, 90, 0.5,
                  ArcRotation::counterclockwise, 3),
          4);
  const std::vector<Point> points{p.position(), {100, 120, 0}, {140, 90, -10}};
  p.curve(spline_through(points, 3), 5);
  p.line({0, 0, 0}, 6);
  return p;
}

TEST(Frame, ATurnedProgramTakesTheSameTimeAndIsTheTurnedPath) {
  const Frame frame = euler_frame({100, 200, -50}, {25, 35, -70});
  const GroupLimits free{.axes = std::vector<Limits>(3)};
  const Plan plain = plan(shapes(), free);
  const Plan turned = plan(placed(frame, shapes()), free);
  EXPECT_NEAR(turned.duration(), plain.duration(), 1e-7 * plain.duration());
  EXPECT_EQ(turned.corners().size(), plain.corners().size());
  const Curve<OverLength> axes[] = {plain.path().curve(0), plain.path().curve(1),
                                    plain.path().curve(2)};
  for (int i = 0; i <= 300; ++i) {
    const double q = plain.path().length() * i / 300;
    const Point part{axes[0].at(q).position, axes[1].at(q).position, axes[2].at(q).position};
    const Point wanted = placed(frame, part);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(turned.path().curve(k).at(q).position, wanted[k], 1e-9);
  }
  path_tests::expect_whole(turned, to_axes(turned), placed(frame, shapes()));
}

TEST(Frame, AFollowerIsNotTurned) {
  Program p(3, {}, 2);
  p.set({.velocity = 100});
  p.line({10, 0, 90}, 1);
  const Program turned = placed(turned_frame({0, 0, 5}, 90), p);
  expect_point(turned.position(), {0, 10, 95}, 0);
  EXPECT_THROW(placed(euler_frame({}, {0, 10, 0}), p), InputError);
}

TEST(Rotary, TakesTheShortestWay) {
  EXPECT_EQ(shortest_way(350, 10, 360), 370);
  EXPECT_EQ(shortest_way(10, 350, 360), -10);
  EXPECT_EQ(shortest_way(0, 180, 360), 180);
  EXPECT_EQ(shortest_way(180, 0, 360), 360) << "half a turn goes upwards";
  EXPECT_EQ(shortest_way(0, -180, 360), 180);
  EXPECT_EQ(shortest_way(725, 4, 360), 724);
  EXPECT_EQ(shortest_way(5, 5 + 3600, 360), 5);
  EXPECT_EQ(shortest_way(10, 350, 0), 350) << "a linear axis";
}

}  // namespace
}  // namespace jounce::frame_test
