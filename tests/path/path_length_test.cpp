// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/path_length.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/path/shapes.hpp"

#include "tests/path/paths.hpp"

namespace jounce::path_length_test {
namespace {

using path_tests::usual;

/// The length of a piece from many points of it, with the second-order error removed.
double by_points(const Path& path, std::size_t piece, std::size_t path_axes) {
  const auto sum = [&](int n) {
    double length = 0;
    Point last = path.point(piece, 0);
    for (int i = 1; i <= n; ++i) {
      const Point next = path.point(piece, path.pieces()[piece].length * i / n);
      double square = 0;
      for (std::size_t k = 0; k < path_axes; ++k)
        square += (next[k] - last[k]) * (next[k] - last[k]);
      length += std::sqrt(square);
      last = next;
    }
    return length;
  };
  return (4 * sum(4000) - sum(2000)) / 3;
}

void expect_the_length_of_points(const Plan& plan) {
  const Path& path = plan.drawn();
  const PathLength length(plan);
  double sum = 0;
  for (std::size_t k = 0; k < path.pieces().size(); ++k) {
    const PathPiece& piece = path.pieces()[k];
    EXPECT_NEAR(length.at(piece.start).length, sum, 1e-9 * path.length()) << k;
    const bool plain = piece.kind == PieceKind::line || piece.kind == PieceKind::arc;
    sum += plain ? piece.length : by_points(path, k, plan.given().path_axes);
  }
  EXPECT_NEAR(length.whole(), sum, 1e-9 * path.length());
  EXPECT_LE(length.error(), 1e-10 * path.length());
}

Program corner_of(double angle, Corner corner, double value) {
  Program p(2);
  p.set({.velocity = 100, .corner = corner, .value = value});
  p.line({50, 0}, 1);
  p.line({50 + 50 * std::cos(angle), 50 * std::sin(angle)}, 2);
  return p;
}

TEST(PathLength, OfACornerWithoutJerkLimitIsThatOfAParabola) {
  // r' = u + D x over the length l, x from 0 to 1. With y = x - 1/2, d = |D| and C the cosine of half the angle,
  // |r'| = (C^2 + d^2 y^2)^(1/2), and the integral is [y |r'| + C^2 / d asinh(d y / C)] / 2.
  for (const double angle : {0.1, 0.9, std::numbers::pi / 2, 2.3, 3.0}) {
    const Plan made = plan(corner_of(angle, Corner::distance, 5),
                           {.axes = std::vector<Limits>(2, {.acceleration = 1000})});
    ASSERT_EQ(made.path().pieces().size(), 3U) << angle;
    const double l = made.path().pieces()[1].length;
    const double cosine = std::cos(angle / 2);
    const double d = 2 * std::sin(angle / 2);
    const double whole = 0.5 + cosine * cosine / d * std::asinh(d / 2 / cosine);
    const PathLength length(made);
    EXPECT_NEAR(length.whole(), 100 - l * (1 - whole), 1e-11) << angle;
    const double middle = made.path().pieces()[1].start + l / 2;
    EXPECT_NEAR(length.at(middle).length, length.whole() / 2, 1e-11);
    EXPECT_NEAR(length.at(middle).slope, cosine, 1e-11);
    EXPECT_NEAR(length.at(middle + l / 2).slope, 1, 1e-11);
  }
}

TEST(PathLength, OfCornersAndCurvesIsThatOfTheirPoints) {
  for (const double angle : {0.02, 0.7, 1.5, 2.6, 3.1})
    for (const Corner corner : {Corner::distance, Corner::deviation})
      expect_the_length_of_points(plan(corner_of(angle, corner, 0.5), usual(2, 1e5)));
  Program mixed(3, {}, 2);
  mixed.set({.velocity = 100, .corner = Corner::deviation, .value = 0.2});
  mixed.line({30, 0, 5}, 1);
  mixed.arc(
      arc_about(mixed.position(), {30, 20}, {50, 20}, Plane{0, 1}, ArcRotation::counterclockwise),
      2);
  mixed.line({20, 40, 9}, 3);
  mixed.line({-20, 50, 9}, 4);
  expect_the_length_of_points(plan(mixed, usual(3, 1e5)));
  Program average(2);
  average.set({.velocity = 100, .corner = Corner::average, .value = 0.05});
  for (int i = 1; i <= 40; ++i) average.line({0.5 * i, std::sin(0.5 * i)}, i);
  expect_the_length_of_points(plan(average, usual(2, 1e5)));
}

TEST(PathLength, IsQOnLinesAndArcs) {
  Program p(2);
  p.set({.velocity = 100});
  p.line({30, 0}, 1);
  p.arc(arc_about(p.position(), {30, 20}, {50, 20}, Plane{0, 1}, ArcRotation::counterclockwise), 2);
  const Plan made = plan(p, usual(2));
  const PathLength length(made);
  EXPECT_DOUBLE_EQ(length.whole(), 30 + 10 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(length.at(37).length, 37);
  EXPECT_EQ(length.at(37).slope, 1);
  EXPECT_EQ(length.error(), 0);
}

TEST(PathLength, KeepsQWhereOnlyFollowersMove) {
  Program p(3, {}, 2);
  p.set({.velocity = 100, .corner = Corner::distance, .value = 1});
  p.line({30, 0, 0}, 1);
  p.line({30, 0, 20}, 2);
  p.line({60, 0, 20}, 3);
  const Plan made = plan(p, usual(3));
  EXPECT_NEAR(PathLength(made).whole(), 80, 1e-12);
}

TEST(PathLength, OverTimeHasTheSpeedOfTheTool) {
  const Plan made = plan(corner_of(std::numbers::pi / 2, Corner::distance, 5), usual(2, 1e5));
  const Fitted<OverTime> length = length_over_time(made);
  EXPECT_NEAR(length.curve.end(), made.duration(), 1e-12);
  EXPECT_NEAR(length.curve.at(made.duration(), Side::left).position, PathLength(made).whole(),
              1e-11);
  EXPECT_LE(length.error[0], 1e-9);
  std::array<Motion, 2> axes;
  for (int i = 0; i <= 1000; ++i) {
    const double t = made.duration() * (i + 0.5) / 1001;
    made.at(t, axes);
    EXPECT_NEAR(length.curve.at(t).velocity, std::hypot(axes[0].velocity, axes[1].velocity), 1e-8)
        << t;
  }
}

}  // namespace
}  // namespace jounce::path_length_test
