// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/compensation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "support/errors.hpp"

namespace jounce::compensation_test {
namespace {

/// HMPL manual 14.1.1, examples 1 to 3.
CompensationSpec line_of_five() {
  return {.axes = {{-100, 200, 5}}, .values = {-0.2, 0.1, -0.3, 0.4, -0.1}};
}
CompensationSpec plate() {
  return {.axes = {{-100, 200, 3}, {-100, 100, 3}},
          .values = {0.3, 0.1, -0.4, -0.4, 0, 0.2, 0.2, -0.1, 0.5}};
}
CompensationSpec volume() {
  return {.axes = {{-10, 20, 3}, {5, 10, 3}, {0, 30, 3}},
          .values = {.3, .1, .2, -.2, 0,  .1, -.1, .3,  .4, .2, -.1, .4, .2, 0,
                     .2, .3, .1, .1,  .4, .3, -.2, -.2, .1, .2, -.1, .1, -.4}};
}

double at(const Compensation& c, double x) {
  return c.at(std::array{x});
}
double at(const Compensation& c, double x, double y) {
  return c.at(std::array{x, y});
}
double at(const Compensation& c, double x, double y, double z) {
  return c.at(std::array{x, y, z});
}

TEST(Compensation, IsThatOfTheManualAlongOneAxis) {
  const Compensation c(line_of_five());
  EXPECT_DOUBLE_EQ(at(c, -250), -0.2);
  EXPECT_NEAR(at(c, 0), -0.05, 1e-16);
  EXPECT_NEAR(at(c, 200), -0.1, 1e-16);
  EXPECT_NEAR(at(c, 450), 0.225, 1e-16);
  EXPECT_DOUBLE_EQ(at(c, 900), -0.1);
  EXPECT_DOUBLE_EQ(at(c, 700), -0.1);
  EXPECT_DOUBLE_EQ(at(c, -100), -0.2);
}

TEST(Compensation, IsThatOfTheManualOverAPlateAndAVolume) {
  const Compensation flat(plate());
  EXPECT_DOUBLE_EQ(at(flat, -100, -100), 0.3);
  EXPECT_NEAR(at(flat, 100, 0), 0, 1e-16);
  EXPECT_NEAR(at(flat, 300, 100), 0.5, 1e-16);
  const Compensation deep(volume());
  EXPECT_DOUBLE_EQ(at(deep, -10, 5, 0), 0.3);
  EXPECT_NEAR(at(deep, 10, 15, 30), 0, 1e-16);
  EXPECT_NEAR(at(deep, 30, 25, 60), -0.4, 1e-15);
}

TEST(Compensation, RunsItsFirstReferenceFastest) {
  const Compensation flat(plate());
  EXPECT_NEAR(at(flat, 300, -100), -0.4, 1e-16);  // the third value
  EXPECT_NEAR(at(flat, -100, 100), 0.2, 1e-16);   // the seventh
  const Compensation deep(volume());
  EXPECT_NEAR(at(deep, 10, 5, 0), 0.1, 1e-16);
  EXPECT_NEAR(at(deep, -10, 15, 0), -0.2, 1e-16);
  EXPECT_NEAR(at(deep, -10, 5, 30), 0.2, 1e-16);
}

/// The mean of the corners, weighted: written out, not by cells.
double trilinear(const CompensationSpec& s, std::array<double, 3> x) {
  double sum = 0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t index = 0;
    std::size_t stride = 1;
    for (std::size_t j = 0; j < 3; ++j) {
      const GridAxis& axis = s.axes[j];
      const double u =
          std::clamp((x[j] - axis.base) / axis.interval, 0.0, static_cast<double>(axis.count - 1));
      const auto i = std::min(static_cast<std::size_t>(u), axis.count - 2);
      const double v = u - static_cast<double>(i);
      const bool high = (corner >> j & 1U) != 0;
      weight *= high ? v : 1 - v;
      index += stride * (i + (high ? 1 : 0));
      stride *= axis.count;
    }
    sum += weight * s.values[index];
  }
  return sum;
}

TEST(Compensation, HoldsTheNearestPointOfTheEdgeInEveryDirection) {
  const Compensation deep(volume());
  for (double x = -40; x <= 60; x += 7)
    for (double y = -10; y <= 40; y += 5)
      for (double z = -20; z <= 90; z += 11)
        EXPECT_NEAR(at(deep, x, y, z), trilinear(volume(), {x, y, z}), 1e-15)
            << x << ' ' << y << ' ' << z;
}

TEST(Compensation, AsASplineIsTheOneWithFreeEnds) {
  CompensationSpec spec = line_of_five();
  spec.rule = GridRule::cubic;
  const Compensation c(spec);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(at(c, -100 + 200.0 * static_cast<double>(i)), spec.values[i], 1e-15);
  // Second differences: continuous inside, zero at the ends.
  const double h = 1e-2;
  const auto curvature = [&](double x) {
    return (at(c, x - h) - 2 * at(c, x) + at(c, x + h)) / (h * h);
  };
  EXPECT_NEAR(curvature(-100 + h), 0, 1e-8);
  EXPECT_NEAR(curvature(700 - h), 0, 1e-8);
  for (const double x : {100.0, 300.0, 500.0})
    EXPECT_NEAR(curvature(x - h), curvature(x + h), 1e-7) << x;
  EXPECT_DOUBLE_EQ(at(c, -250), -0.2);
}

/// A natural spline holds a straight line; in two directions a bilinear function.
TEST(Compensation, AsASplineHoldsABilinearFunction) {
  CompensationSpec spec{.axes = {{0, 2, 4}, {1, 0.5, 3}}, .rule = GridRule::cubic};
  const auto f = [](double x, double y) { return 0.5 - 0.25 * x + 2 * y + 0.125 * x * y; };
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 4; ++i)
      spec.values.push_back(f(2.0 * static_cast<double>(i), 1 + 0.5 * static_cast<double>(j)));
  const Compensation c(spec);
  for (double x = 0; x <= 6; x += 0.3)
    for (double y = 1; y <= 2; y += 0.1) EXPECT_NEAR(at(c, x, y), f(x, y), 1e-14);
}

/// The bicubic spline is that of the splines along one axis, along the other.
TEST(Compensation, AsABicubicSplineIsASplineOfSplines) {
  CompensationSpec spec = plate();
  spec.rule = GridRule::cubic;
  const Compensation c(spec);
  for (double x = -100; x <= 300; x += 37) {
    CompensationSpec across{.axes = {spec.axes[1]}, .rule = GridRule::cubic};
    for (std::size_t row = 0; row < 3; ++row)
      across.values.push_back(
          at(Compensation({.axes = {spec.axes[0]},
                           .values = {&spec.values[3 * row], &spec.values[3 * row] + 3},
                           .rule = GridRule::cubic}),
             x));
    const Compensation second(across);
    for (double y = -120; y <= 120; y += 13) EXPECT_NEAR(at(c, x, y), at(second, y), 1e-15);
  }
}

TEST(Compensation, NamesWhatIsWrongWithItsTable) {
  const auto complaint = [](const CompensationSpec& spec) {
    return test::error_of([&] { const Compensation c(spec); }, "none");
  };
  CompensationSpec spec = line_of_five();
  spec.most = 1;
  EXPECT_EQ(complaint(spec), "none");
  spec.values[2] = 1.1;
  EXPECT_EQ(complaint(spec), "values[3] = 1.1: exceeds the greatest correction, 1");
  spec = line_of_five();
  spec.values.pop_back();
  EXPECT_EQ(complaint(spec), "values = 4: the grid has 5 points");
  spec = line_of_five();
  spec.axes[0].interval = 0;
  EXPECT_THAT(complaint(spec), testing::StartsWith("axes[1].interval = 0:"));
  spec = line_of_five();
  spec.values[0] = std::nan("");
  EXPECT_THAT(complaint(spec), testing::StartsWith("values[1] = nan:"));
  spec = volume();
  spec.rule = GridRule::cubic;
  EXPECT_THAT(complaint(spec), testing::StartsWith("rule = cubic:"));
  EXPECT_THAT(complaint({}), testing::StartsWith("axes = 0:"));
}

// ---- composed with motions -------------------------------------------------------------------

Trajectory move(double from, double to) {
  return s_curve({.from = from, .to = to, .velocity = 90, .acceleration = 400, .jerk = 5000})
      .curve();
}

/// The motion at many instants against motion + c(references), and derivatives that fit together.
void expect_composed(const Fitted<OverTime>& made, const Trajectory& motion, const Compensation& c,
                     const std::vector<Trajectory>& references, double tolerance) {
  EXPECT_LE(made.error[0], tolerance);
  const double end = motion.end();
  EXPECT_NEAR(made.curve.end(), end, 1e-12 * end);
  for (int i = 0; i <= 1000; ++i) {
    const double t = std::min(end, made.curve.end()) * i / 1000;
    std::vector<double> x;
    for (const Trajectory& each : references) x.push_back(each.jet(t)[0]);
    EXPECT_NEAR(made.curve.jet(t)[0], motion.jet(t)[0] + c.at(x), tolerance + 1e-12) << t;
  }
  EXPECT_TRUE(check_continuity(made.curve, 0).ok());
}

TEST(Compensated, FollowsItsOwnAxisExactly) {
  const Compensation c(line_of_five());
  const Trajectory motion = move(-150, 800);
  const auto made = compensated(motion, c, {{motion}}, 1e-9);
  EXPECT_EQ(made.error[0], 0);
  expect_composed(made, motion, c, {motion}, 1e-9);
  // At cruise the slope of the table steps at 100 from 0.3/200 to -0.4/200: so does the velocity.
  const double passing = 100;
  double t = 0;
  for (double lo = 0, hi = motion.end(); hi - lo > 1e-12; t = (lo + hi) / 2)
    (motion.jet((lo + hi) / 2)[0] < passing ? lo : hi) = (lo + hi) / 2;
  EXPECT_NEAR(made.curve.jet(t - 1e-9)[1], 90 * (1 + 0.3 / 200), 1e-9);
  EXPECT_NEAR(made.curve.jet(t + 1e-9)[1], 90 * (1 - 0.4 / 200), 1e-9);
  EXPECT_FALSE(check_continuity(made.curve, 1).ok());
}

TEST(Compensated, AsASplineIsSmoothInsideTheGrid) {
  CompensationSpec spec = line_of_five();
  spec.rule = GridRule::cubic;
  const Compensation c(spec);
  const Trajectory motion = move(-90, 690);
  const auto made = compensated(motion, c, {{motion}}, 1e-9);
  expect_composed(made, motion, c, {motion}, 1e-9);
  EXPECT_TRUE(check_continuity(made.curve, 2).ok());
}

TEST(Compensated, FollowsTwoAndThreeAxes) {
  const Trajectory x = move(-150, 350);
  const Trajectory fast = move(-140, 40);
  const Trajectory y = until(fast, x.end());
  const Compensation flat(plate());
  expect_composed(compensated(x, flat, {{x, y}}, 1e-9), x, flat, {x, y}, 1e-9);
  CompensationSpec smooth = plate();
  smooth.rule = GridRule::cubic;  // degree 18 behind S-curves: fitted
  const Compensation spline(smooth);
  const auto fitted = compensated(x, spline, {{x, y}}, 1e-9);
  EXPECT_GT(fitted.error[0], 0);
  expect_composed(fitted, x, spline, {x, y}, 1e-9);
  const Compensation deep(volume());
  expect_composed(compensated(x, deep, {{x, y, x}}, 1e-9), x, deep, {x, y, x}, 1e-9);
}

TEST(Compensated, RejectsATableThatAdvancesFromPassToPass) {
  const Compensation c(line_of_five());
  const Trajectory once = move(0, 100);
  const Trajectory on = with(once, Extrapolation::advance);
  EXPECT_THROW(compensated(on, c, {{once}}, 1e-9), InputError);
  EXPECT_THROW(compensated(once, c, {{on}}, 1e-9), InputError);
}

TEST(Compensated, RejectsReferencesOfAnotherLength) {
  const Compensation c(line_of_five());
  EXPECT_THROW(compensated(move(0, 100), c, {{move(0, 50)}}, 1e-9), InputError);
  EXPECT_THROW(compensated(move(0, 100), c, {}, 1e-9), InputError);
}

TEST(Compensation, RejectsAWrongNumberOfReferences) {
  const Compensation flat(plate());
  const std::vector<double> places(4, 0.0);
  const std::vector<Jet> jets(4);
  for (const std::size_t n : {1U, 3U, 4U}) {
    EXPECT_THROW((void)flat.at(std::span(places).first(n)), InputError);
    EXPECT_THROW((void)flat.at(std::span(jets).first(n)), InputError);
    EXPECT_THROW((void)flat.cell(std::span(places).first(n)), InputError);
  }
}

}  // namespace
}  // namespace jounce::compensation_test
