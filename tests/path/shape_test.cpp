// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/path/shapes.hpp"
#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

namespace jounce::shape_test {
namespace {

constexpr Plane xy{0, 1};

/// PMC600 Example 8.4: axes 10000 x 8000.
PathCurve seed_ellipse() {
  return ellipse({}, {5000, 0}, {10000, 0}, xy, 0, 0.8, ArcRotation::clockwise, 2);
}

TEST(Ellipse, OfTheSeed) {
  const PathCurve half = seed_ellipse();
  EXPECT_NEAR(half.length, 14180.834, 5e-4);
  EXPECT_LT(half.deviation, 1e-6);
  EXPECT_LT(half.speed_error, 1e-9);
  Program p(2);
  p.set({.velocity = 10000, .acceleration = 20000});
  p.curve(half);
  EXPECT_NEAR(plan(p, {.axes = std::vector<Limits>(2)}).duration(), 1.918083, 5e-7);
  const PathCurve turned = ellipse({10000, 0}, {10000, 5000}, {10000, 10000}, xy, 90, 0.8,
                                   ArcRotation::counterclockwise, 2);
  EXPECT_NEAR(turned.length, half.length, 1e-6);
  // It passes (14000, 5000), half way.
  double x = 0;
  for (std::size_t k = 0; k < turned.segments.size(); k += 2)
    x = std::max(x, value(turned.segments[k], 1));
  EXPECT_NEAR(x, 14000, 1e-6);
}

TEST(Ellipse, ItsDeviationIsABound) {
  path_tests::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double ratio = random.log_between(0.05, 1);
    const double K = random.between(0, 360);
    const Point from{random.between(-1, 1), random.between(-1, 1)};
    const Point center{random.between(-1, 1), random.between(-1, 1)};
    const PathCurve e = ellipse(from, center, from, xy, K, ratio, ArcRotation::counterclockwise, 2);
    const double cs = std::cos(K * std::numbers::pi / 180);
    const double sn = std::sin(K * std::numbers::pi / 180);
    double major = 0;
    double farthest = 0;
    const auto radius = [&](const Point& p) {
      const double x = p[0] - center[0];
      const double y = p[1] - center[1];
      return std::hypot(cs * x + sn * y, (cs * y - sn * x) / ratio);
    };
    major = radius(from);
    for (std::size_t k = 0; k < e.segments.size(); k += 2)
      for (int s = 0; s <= 10; ++s)
        farthest = std::max(
            farthest,
            std::abs(radius({value(e.segments[k], s / 10.0), value(e.segments[k + 1], s / 10.0)}) -
                     major));
    // The affine distance, at most 1 / ratio of the true one.
    EXPECT_LE(farthest * ratio, e.deviation + 1e-14);
    EXPECT_NEAR(value(e.segments[e.segments.size() - 2], 1), from[0], 1e-13);
  }
}

TEST(Ellipse, ACircleIsACircle) {
  const PathCurve circle =
      ellipse({50, 0}, {}, {50, 0}, xy, 30, 1, ArcRotation::clockwise, 2, {.extra_turns = 1});
  EXPECT_NEAR(circle.length, 4 * std::numbers::pi * 50, 1e-10);
}

TEST(Ellipse, RejectsAnEndOffIt) {
  EXPECT_THROW(ellipse({}, {5000, 0}, {10001, 0}, xy, 0, 0.8, ArcRotation::clockwise, 2),
               InputError);
  EXPECT_THROW(ellipse({}, {5000, 0}, {10000, 0}, xy, 0, 1.2, ArcRotation::clockwise, 2),
               InputError);
}

TEST(Curves, KeepLimitsAndMeetTheirPoints) {
  const GroupLimits limits = path_tests::usual(3, 1e5);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    path_tests::Random random(seed);
    std::vector<Point> points{{}};
    for (int i = 0; i < 12; ++i) {
      Point p = points.back();
      p[0] += random.between(2, 12);
      p[1] += random.between(-6, 6);
      p[2] += random.between(-6, 6);
      points.push_back(p);
    }
    SplineDirections ends;
    if (seed % 2 == 0) ends.start = Point{1, 1, 0};
    const PathCurve spline = spline_through(points, 3, ends);
    Program p(3);
    p.set({.velocity = 200});
    p.curve(spline, 1);
    const Plan made = plan(p, limits);
    const PlanAxes axes = to_axes(made);
    path_tests::expect_whole(made, axes, p);
    EXPECT_LE(path_tests::worst_ratio(axes, limits), 1 + 1e-12);
    EXPECT_GE(made.duration(), lower_bound(made, 32) * (1 - 1e-12));
    EXPECT_TRUE(made.corners().empty());
    if (HasFailure()) break;
  }
}

TEST(Curves, AnEllipseKeepsItsFeed) {
  Program p(2, {50, 0});
  p.set({.velocity = 100});
  p.curve(ellipse({50, 0}, {}, {50, 0}, xy, 0, 0.5, ArcRotation::counterclockwise, 2), 1);
  const GroupLimits limits = path_tests::usual(2);
  const Plan made = plan(p, limits);
  const PlanAxes axes = to_axes(made);
  path_tests::expect_whole(made, axes, p);
  EXPECT_LE(path_tests::excess(axes, limits), 1e-12);
  for (int i = 0; i <= 1000; ++i) {
    const double t = made.duration() * i / 1000;
    EXPECT_LE(std::hypot(axes.curves[0].at(t, Side::left).velocity,
                         axes.curves[1].at(t, Side::left).velocity),
              100 + 1e-6);
  }
}

// The third axis is a follower. The curve of the first two is the curve without it.
void expect_same_in_plane(const PathCurve& with, const PathCurve& without) {
  EXPECT_EQ(with.length, without.length);
  EXPECT_EQ(with.speed_error, without.speed_error);
  ASSERT_EQ(with.segments.size(), without.segments.size() / 2 * 3);
  for (std::size_t k = 0; k < without.segments.size(); ++k)
    for (const double s : {0.0, 0.3, 1.0})
      EXPECT_EQ(value(with.segments[k / 2 * 3 + k % 2], s), value(without.segments[k], s));
  EXPECT_NEAR(value(with.segments.back(), 1), with.to[2], 1e-12 * std::abs(with.to[2]));
}

TEST(Curves, AFollowerAddsNoLength) {
  const auto half = [](double c, std::size_t axes) {
    return ellipse({}, {100, 0}, {200, 0, c}, xy, 0, 0.5, ArcRotation::clockwise, axes,
                   {.path_axes = 2});
  };
  expect_same_in_plane(half(360, 3), half(0, 2));
  const std::vector<Point> points{{}, {70, 50, 120}, {130, 60, 240}, {200, 0, 360}};
  const SplineDirections ends{.start = Point{1, 0, 3}};
  const PathCurve spline = spline_through(points, 3, ends, 2);
  expect_same_in_plane(spline, spline_through(points, 2, ends));
  // Over arc length, the follower only adds pieces.
  EXPECT_NEAR(over_length(spline, 1e-6, 2).length,
              over_length(spline_through(points, 2, ends), 1e-6).length, 1e-6);
  EXPECT_NEAR(over_length(b_spline(points, 3), 1e-6, 2).length,
              over_length(b_spline(points, 2), 1e-6).length, 1e-6);
}

TEST(Curves, FollowersAloneDetermineTheLength) {
  const std::vector<Point> points{{5, 5}, {5, 5, 30}, {5, 5, 40}, {5, 5, 100}};
  EXPECT_NEAR(spline_through(points, 3, {}, 2).length, 100, 1e-12);
  EXPECT_NEAR(over_length(b_spline(points, 3), 1e-9, 2).length, 100, 1e-9);
}

TEST(Curves, RejectPoints) {
  const std::vector<Point> one{{}};
  EXPECT_THROW(spline_through(one, 2), InputError);
  const std::vector<Point> twice{{}, {1, 1}, {1, 1}};
  EXPECT_THROW(spline_through(twice, 2), InputError);
  const std::vector<Point> follows{{}, {1}, {1, 0, 5}, {2}};  // only the follower moves
  EXPECT_THROW(spline_through(follows, 3, {}, 2), InputError);
  EXPECT_THROW(ellipse({}, {100, 0}, {200, 0}, Plane{0, 2}, 0, 1, ArcRotation::clockwise, 3,
                       {.path_axes = 2}),
               InputError);
}

}  // namespace
}  // namespace jounce::shape_test
