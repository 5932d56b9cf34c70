// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "path/src/timing/window.hpp"
#include "tests/path/paths.hpp"

namespace jounce::average_test {
namespace {

using path_tests::Random;
using path_tests::usual;

Program polyline(const std::vector<Point>& points, double deviation, double feed = 100) {
  Program p(2, points.front());
  p.set({.velocity = feed, .corner = Corner::average, .value = deviation});
  for (std::size_t i = 1; i < points.size(); ++i) p.line(points[i], static_cast<int>(i));
  return p;
}

std::vector<Point> chords_of_a_circle(double chord) {
  const int n = static_cast<int>(std::lround(2 * std::numbers::pi * 50 / chord));
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    points.push_back({50 * std::cos(a), 50 * std::sin(a)});
  }
  return points;
}

/// Distance from a point to a polyline.
double distance(const Point& p, const std::vector<Point>& line) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double ux = line[i + 1][0] - line[i][0];
    const double uy = line[i + 1][1] - line[i][1];
    const double px = p[0] - line[i][0];
    const double py = p[1] - line[i][1];
    const double t = std::clamp((px * ux + py * uy) / (ux * ux + uy * uy), 0.0, 1.0);
    least = std::min(least, std::hypot(px - t * ux, py - t * uy));
  }
  return least;
}

void expect_planned(const Program& p, const GroupLimits& limits, const std::vector<Point>& points,
                    double deviation) {
  const Plan made = plan(p, limits);
  const PlanAxes axes = to_axes(made);
  path_tests::expect_whole(made, axes, p);
  EXPECT_LE(path_tests::excess(axes, limits), 1e-12);
  EXPECT_LE(made.duration(), made.stop_duration());
  for (int i = 0; i <= 500; ++i) {  // sampled: a distance that is found must be allowed
    const double t = made.duration() * i / 500;
    const Point at{axes.curves[0].at(t, Side::left).position,
                   axes.curves[1].at(t, Side::left).position};
    EXPECT_LE(distance(at, points), deviation * (1 + 1e-9)) << t;
    std::vector<Motion> now(2);
    made.at(t, now);
    EXPECT_NEAR(now[0].position, at[0], 1e-8);
    EXPECT_NEAR(now[1].position, at[1], 1e-8);
  }
}

TEST(Average, ACircleOfChordsIsAsFastAsACircle) {
  // spec/path.md 3 and 4: 36.8 s with a blend at each corner, 70.9 s with stops, 3.370 s by a window, bound 3.238 s.
  const std::vector<Point> points = chords_of_a_circle(0.5);
  const Program p = polyline(points, 0.05);
  const Plan made = plan(p, usual(2));
  EXPECT_LT(made.duration(), 3.45);
  EXPECT_GT(made.duration(), 3.238);
  EXPECT_GE(made.duration(), lower_bound(made, 4) * (1 - 1e-12));
  EXPECT_GT(made.stop_duration(), 60);
  expect_planned(p, usual(2), points, 0.05);
}

TEST(Average, RandomPolylines) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Point> points{{0, 0}};
    double angle = random.between(0, 6);
    const double chord = random.log_between(0.05, 5);
    const double bend = random.log_between(0.01, 0.6);
    for (int i = 0; i < 60; ++i) {
      angle += random.between(-bend, bend);
      const double length = chord * random.log_between(0.3, 3);
      points.push_back({points.back()[0] + length * std::cos(angle),
                        points.back()[1] + length * std::sin(angle)});
    }
    const double deviation = chord * random.log_between(0.001, 0.3);
    expect_planned(polyline(points, deviation, random.log_between(5, 500)),
                   usual(2, random.log_between(1e3, 1e6)), points, deviation);
    if (HasFailure()) break;
  }
}

TEST(Average, SharpCornersAreNotAveraged) {
  std::vector<Point> points;
  for (int i = 0; i <= 50; ++i) points.push_back({i * 0.5, 0});
  for (int i = 1; i <= 50; ++i) points.push_back({25, i * 0.5 + 0.001 * i * i});
  const Program p = polyline(points, 0.01);
  expect_planned(p, usual(2), points, 0.01);
}

TEST(Window, KeepsItsCapsItsAccelerationAndItsJerk) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<CappedLength> caps;
    const auto count = static_cast<std::size_t>(random.between(1, 40));
    double whole = 0;
    for (std::size_t i = 0; i < count; ++i) {
      caps.push_back({random.log_between(0.01, 50), random.log_between(1, 300)});
      whole += caps.back().length;
    }
    const double a = random.log_between(10, 1e4);
    const double w = random.log_between(1e-3, 1);
    const std::vector<LawPhase> law = averaged(spread_law(caps, a, w), w, whole);
    double q = 0;
    double v = 0;
    for (const LawPhase& p : law) {
      EXPECT_NEAR(p.position, q, 1e-9 * whole);
      EXPECT_NEAR(p.velocity, v, 1e-9 * 300);
      EXPECT_LE(std::abs(p.jerk), a / w * (1 + 1e-10));
      EXPECT_LE(std::abs(p.acceleration), a * (1 + 1e-9));  // the reserve of the plan
      const double h = p.duration;
      for (int k = 0; k <= 8; ++k) {
        const double t = h * k / 8;
        const double at = p.position + t * (p.velocity + t * (p.acceleration / 2 + t * p.jerk / 6));
        const double speed = p.velocity + t * (p.acceleration + t * p.jerk / 2);
        double end = 0;
        double cap = 0;
        for (const CappedLength& c : caps) {
          end += c.length;
          if (at <= end + 1e-9 * whole) cap = std::max(cap, c.velocity);
          if (at < end - 1e-9 * whole) break;
        }
        EXPECT_LE(speed, cap * (1 + 1e-9));
      }
      q = p.position + h * (p.velocity + h * (p.acceleration / 2 + h * p.jerk / 6));
      v = p.velocity + h * (p.acceleration + h * p.jerk / 2);
    }
    EXPECT_NEAR(q, whole, 1e-12 * whole);
    EXPECT_NEAR(v, 0, 1e-9 * 300);
    if (HasFailure()) break;
  }
}

/// One phase of constant velocity over 49 000 pieces: rounding added up to a step of 4e-10 at its end.
TEST(Average, ManyPiecesInOnePhaseAddUpNoRounding) {
  const auto place = [](int k) {
    return Point{80 * std::sin(2.5e-4 * k), 60 * std::sin(1.9e-4 * k)};
  };
  Program program(2, place(12288));
  program.set({.velocity = 100, .corner = Corner::average, .value = 0.002});
  for (int k = 12289; k <= 28672; ++k) program.line(place(k), k);
  const Limits axis{.velocity = 200, .acceleration = 2000, .jerk = 1e5};
  const PlanAxes axes = to_axes(plan(program, {.axes = {axis, axis}}));
  for (const Trajectory& curve : axes.curves) {
    double step = 0;
    const auto segments = curve.segments();
    for (std::size_t k = 1; k < segments.size(); ++k)
      step = std::max(step, std::abs(value(segments[k], 0) - value(segments[k - 1], 1)));
    EXPECT_LE(step, 1e-12);
  }
}

}  // namespace
}  // namespace jounce::average_test
