// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/spline_space.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "optimize/src/figures/figure_rows.hpp"
#include "support/random.hpp"

namespace jounce::optimize_detail {
namespace {

using test::Random;

/// Uneven knots, far from 0.
SplineSpace some_space(Random& random, int degree, int order) {
  std::vector<double> knots{100};
  for (int i = 0; i < 7; ++i) knots.push_back(knots.back() + random.log_uniform(0.01, 3));
  return {knots, degree, order, 5, 40};
}

/// A random spline: its joints hold.
Coordinates some_spline(Random& random, const SplineSpace& space) {
  Coordinates z(space.size());
  for (double& x : z) x = random.uniform(-1, 1);
  return space.propagated(std::move(z));
}

LinearQuantity some_quantity(Random& random, int degree) {
  LinearQuantity q{.name = "q", .by = {}, .constant = random.uniform(-3, 3)};
  for (int k = 0; k <= std::min(degree, 5); ++k)
    q.by[static_cast<std::size_t>(k)] = random.uniform(-1, 1);
  return q;
}

TEST(SplineSpace, FormsGiveWhatTheSegmentsDo) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int degree = 2 + random.below(6);
    const SplineSpace space = some_space(random, degree, random.below(degree + 1));
    const Coordinates z = some_spline(random, space);
    const auto shape = space.segments(z);
    const LinearQuantity q = some_quantity(random, degree);
    for (std::size_t i = 0; i < space.pieces(); ++i)
      for (const double s : {0.0, 0.3, 1.0}) {
        const Segment g = quantity_of(q, shape[i]);
        const double scale = magnitude(g) + 1;
        EXPECT_NEAR(space.at(q, i, s).at(z), value(g, s), 1e-11 * scale) << i << " " << s;
      }
  }
}

TEST(SplineSpace, SplinesHaveAllButTheHighestDerivativeContinuous) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int degree = 2 + random.below(6);
    const SplineSpace space = some_space(random, degree, degree);
    const Coordinates z = some_spline(random, space);
    for (const Form& f : space.joints()) EXPECT_NEAR(f.at(z), 0, 1e-12);
    auto shape = space.segments(z);
    for (int k = 0; k < degree; ++k) {
      for (std::size_t i = 0; i + 1 < shape.size(); ++i)
        EXPECT_NEAR(value(shape[i], 1), value(shape[i + 1], 0), 1e-11 * (magnitude(shape[i]) + 1));
      for (Segment& f : shape) f = derivative(f);
    }
  }
}

TEST(SplineSpace, CoordinatesOfASplineAreItsOwn) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int degree = 2 + random.below(6);
    const SplineSpace space = some_space(random, degree, degree);
    const Coordinates z = some_spline(random, space);
    const Coordinates again = space.coordinates(space.segments(z));
    double size = 1;
    for (const double x : z) size = std::max(size, std::abs(x));
    for (std::size_t j = 0; j < z.size(); ++j) EXPECT_NEAR(again[j], z[j], 1e-9 * size) << j;
  }
}

TEST(SplineSpace, SquaresAddUpToTheIntegral) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int degree = 2 + random.below(6);
    const SplineSpace space = some_space(random, degree, degree);
    const Coordinates z = some_spline(random, space);
    const LinearQuantity q = some_quantity(random, degree);
    double sum = 0;
    for (const Form& f : space.squares(q)) sum += std::pow(f.at(z), 2);
    const double length = space.knots().back() - space.knots().front();
    const double rms = rows_of(RmsOf{q}, space).value(space.segments(z));
    EXPECT_NEAR(std::sqrt(sum / length), rms, 1e-11 * rms);
  }
}

/// Planes are gradients: below the figure everywhere, equal to it where they touch.
TEST(FigureRows, PlanesTouchTheFigureFromBelow) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int degree = 2 + random.below(6);
    const SplineSpace space = some_space(random, degree, degree);
    const FigureRows rows = rows_of(PeakOf{some_quantity(random, degree)}, space);
    const Coordinates z = some_spline(random, space);
    const auto shape = space.segments(z);
    const double peak = rows.value(shape);
    const auto planes = rows.cuts(shape, peak * (1 - 1e-9));
    ASSERT_FALSE(planes.empty());
    double highest = 0;
    const Coordinates other = some_spline(random, space);
    const double there = rows.value(space.segments(other));
    for (const Form& f : planes) {
      highest = std::max(highest, f.at(z));
      EXPECT_LE(f.at(other), there * (1 + 1e-11));
    }
    EXPECT_NEAR(highest, peak, 1e-11 * peak);
    EXPECT_TRUE(rows.cuts(shape, peak).empty());
  }
}

}  // namespace
}  // namespace jounce::optimize_detail
