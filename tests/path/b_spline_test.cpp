// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/path/shapes.hpp"
#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

// B-splines over their arc length against tests/oracle/b_splines.py, which sums basis functions and integrates.
namespace jounce::b_spline_test {
namespace {

std::vector<Point> points_of(const nlohmann::json& rows) {
  std::vector<Point> points;
  for (const auto& row : rows) {
    Point p{};
    for (std::size_t i = 0; i < row.size(); ++i) p[i] = row[i];
    points.push_back(p);
  }
  return points;
}

/// One axis at a length from the start.
Jet at_length(const PathCurve& curve, std::size_t axis, double q) {
  std::size_t k = 0;
  for (; k + curve.axes < curve.segments.size() && q > curve.segments[k].length; k += curve.axes)
    q -= curve.segments[k].length;
  return evaluate(curve.segments[k + axis], q / curve.segments[k].length);
}

TEST(BSpline, OverItsLengthIsThatOfTheOracle) {
  std::ifstream file(JOUNCE_SOURCE_DIR "/tests/oracle/b_splines.json");
  const nlohmann::json rows = nlohmann::json::parse(file).at("b_splines");
  ASSERT_GE(rows.size(), 6u);
  for (const auto& row : rows) {
    const std::vector<Point> points = points_of(row.at("points"));
    const std::size_t axes = row.at("points")[0].size();
    const auto knots = row.at("knots").get<std::vector<double>>();
    const PathCurve over_knots = b_spline(points, axes, row.at("degree"), knots);
    const double length = row.at("length");
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      const PathCurve curve = over_length(over_knots, tolerance);
      EXPECT_LE(curve.deviation, tolerance);
      EXPECT_LE(curve.speed_error, 1e-2 * std::sqrt(tolerance));
      EXPECT_NEAR(curve.length, length, tolerance);
      for (const auto& place : row.at("places"))
        for (std::size_t i = 0; i < axes; ++i) {
          const Jet jet = at_length(curve, i, place.at("share").get<double>() * length);
          EXPECT_NEAR(jet[0], place.at("point")[i].get<double>(), 2 * tolerance);
          EXPECT_NEAR(jet[1], place.at("tangent")[i].get<double>(), 10 * std::pow(tolerance, 0.75));
        }
    }
  }
}

TEST(BSpline, EvenKnotsAreTheDefault) {
  const std::vector<Point> points{{0, 0}, {10, 20}, {30, -10}, {50, 10}, {60, 0}};
  const std::vector<double> even{0, 0, 0, 0, 1, 2, 2, 2, 2};
  const PathCurve a = b_spline(points, 2, 3, even);
  const PathCurve b = b_spline(points, 2);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t k = 0; k < a.segments.size(); ++k) EXPECT_EQ(a.segments[k].c, b.segments[k].c);
}

TEST(BSpline, ATangentLineIsPassedAndAStepOfTheCurvatureIsStated) {
  // The first and the last two control points are on the x axis: tangent to both lines. The curvature of a clamped
  // cubic at its end is that of its first three points, here not 0.
  Program p(2);
  p.set({.velocity = 100});
  p.line({50, 0}, 1);
  const std::vector<Point> points{{50, 0}, {70, 0}, {90, 40}, {110, 40}, {130, 0}, {150, 0}};
  p.curve(over_length(b_spline(points, 2), 1e-9), 2);
  p.line({200, 0}, 3);
  const GroupLimits limits = path_tests::usual(2);
  const Plan motion = plan(p, limits);
  const PlanAxes axes = to_axes(motion);
  EXPECT_LE(path_tests::worst_ratio(axes, limits), 1 + 1e-12);
  ASSERT_EQ(motion.corners().size(), 2u);
  for (const CornerRecord& corner : motion.corners()) {
    EXPECT_FALSE(corner.stop);
    EXPECT_EQ(corner.note, JunctionNote::steps);
  }
  // Three points on each line: the curvature is 0 there, too, and there is no corner.
  Program smooth(2);
  smooth.set({.velocity = 100});
  smooth.line({50, 0}, 1);
  const std::vector<Point> flat{{50, 0}, {60, 0}, {70, 0}, {90, 40}, {130, 0}, {140, 0}, {150, 0}};
  smooth.curve(over_length(b_spline(flat, 2), 1e-9), 2);
  smooth.line({200, 0}, 3);
  const Plan passed = plan(smooth, limits);
  EXPECT_TRUE(passed.corners().empty());
  path_tests::expect_whole(passed, to_axes(passed), smooth);
}

TEST(OverLength, ASplineThroughPointsKeepsItsShapeAndRunsAtItsFeed) {
  const std::vector<Point> points{{0, 0}, {40, 30}, {50, -20}, {120, 10}};
  const PathCurve chords = spline_through(points, 2, {.start = Point{1, 0}, .end = Point{1, 0}});
  const PathCurve even = over_length(chords, 1e-8);
  EXPECT_GT(chords.speed_error, 0.05);
  EXPECT_LT(even.speed_error, 1e-6);
  EXPECT_NEAR(at_length(even, 1, 0)[1], 0, 1e-12);
  EXPECT_NEAR(at_length(even, 0, even.length)[0], 120, 1e-9);
  // It passes the points: the ends of the pieces of the spline are ends of pieces.
  for (const Point& p : points) {
    double nearest = 1e9;
    for (std::size_t k = 0; k < even.segments.size(); k += 2)
      for (const double s : {0.0, 1.0})
        nearest = std::min(nearest, std::hypot(value(even.segments[k], s) - p[0],
                                               value(even.segments[k + 1], s) - p[1]));
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(BSpline, AContradictionIsRejected) {
  const std::vector<Point> points{{0, 0}, {10, 20}, {30, -10}, {50, 10}};
  EXPECT_THROW(b_spline(points, 2, 2), InputError);
  EXPECT_THROW(b_spline(points, 2, 8), InputError);
  EXPECT_THROW(b_spline(points, 2, 4), InputError);
  const std::vector<double> twice{0, 0, 0, 0, 1, 1, 2, 2, 2, 2};
  const std::vector<Point> six{{0, 0}, {1, 2}, {3, -1}, {5, 1}, {6, 0}, {8, 2}};
  EXPECT_THROW(b_spline(six, 2, 3, twice), InputError);
  EXPECT_THROW(b_spline(six, 2, 3, std::span(twice).first(9)), InputError);
  // A cusp: the curve stops and turns back.
  const std::vector<Point> back{{0, 0}, {10, 0}, {-10, 0}, {0, 0}};
  EXPECT_THROW(over_length(b_spline(back, 2), 1e-6), InputError);
}

}  // namespace
}  // namespace jounce::b_spline_test
