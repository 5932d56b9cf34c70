// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/optimize/shape.hpp"
#include "jounce/profiles/curve/curve.hpp"

#include "optimize/clp_shape.hpp"
#include "optimize/shape_problems.hpp"

// Values in closed form (perfect splines: G. Glaeser 1973; least squares: Hermite's polynomials)
// and the results of Clp on a dense grid.

namespace jounce::shape_benchmark_test {
namespace {

using test_optimize::rest_to_rest_shape;
using test_optimize::within;

TEST(ShapeBenchmark, ReachesThePerfectSplines) {
  constexpr std::array least{4.0, 32.0, 384.0, 6144.0};
  for (int n = 2; n <= 5; ++n) {
    SCOPED_TRACE(n);
    ShapeProblem p = rest_to_rest_shape(n);
    p.degree = n;
    p.pieces = 61;  // none of whose knots is a switch
    p.refine = true;
    p.options.tolerance = 1e-7;
    p.minimize = {{PeakOf{derivative_of_shape(n)}}};
    const ShapeOutcome best = optimize_shape(p);
    EXPECT_EQ(best.status, OptimizeStatus::optimal) << best.reason;
    const double known = least[static_cast<std::size_t>(n - 2)];
    EXPECT_NEAR(best.figures[0].reached, known, 1e-6 * known);
    EXPECT_GE(best.figures[0].reached, known * (1 - 1e-12)) << "no law is below";
    ASSERT_TRUE(best.figures[0].bound);
    EXPECT_NEAR(*best.figures[0].bound, known, 1e-9 * known);
  }
}

TEST(ShapeBenchmark, ReachesTheLeastSquares) {
  constexpr std::array least{12.0, 720.0, 100800.0};
  for (int n = 2; n <= 4; ++n) {
    SCOPED_TRACE(n);
    ShapeProblem p = rest_to_rest_shape(n);
    p.degree = 2 * n - 1;
    p.pieces = 50;
    // Something else to begin with: a parabola's law has no third derivative.
    p.given = {cubic(0.4, 0, 0, 0.3, 1.2), cubic(0.6, 0.3, 1.2, 1, 0)};
    p.minimize = {{RmsOf{derivative_of_shape(n)}}};
    const ShapeOutcome best = optimize_shape(p);
    EXPECT_EQ(best.status, OptimizeStatus::optimal) << best.reason;
    const double known = least[static_cast<std::size_t>(n - 2)];
    const double reached = best.figures[0].reached;
    EXPECT_NEAR(reached * reached, known, 1e-6 * known);
    ASSERT_TRUE(best.figures[0].bound);
    EXPECT_NEAR(*best.figures[0].bound * *best.figures[0].bound, known, 1e-9 * known);
  }
}

TEST(ShapeBenchmark, ReachesTheFrontOfJerkAndAcceleration) {
  for (const double jerk : {33.0, 36.0, 40.0, 48.0, 60.0, 80.0, 120.0, 240.0, 500.0, 1000.0}) {
    SCOPED_TRACE(jerk);
    ShapeProblem p = rest_to_rest_shape(3);
    p.degree = 3;
    p.pieces = 80;
    p.refine = true;
    p.minimize = {{PeakOf{derivative_of_shape(2)}}};
    p.corridors = {within(derivative_of_shape(3), jerk, p)};
    const ShapeOutcome best = optimize_shape(p);
    ASSERT_TRUE(best.usable()) << best.reason;
    const double known = jerk / 4 * (1 - std::sqrt(1 - 32 / jerk));
    EXPECT_LE(best.figures[0].reached, known * (1 + 1e-6));
    EXPECT_GE(best.figures[0].reached, known * (1 - 1e-9));
  }
}

TEST(ShapeBenchmark, AgreesWithClpOnADenseGrid) {
  for (const int order : {2, 3}) {
    SCOPED_TRACE(order);
    ShapeProblem p = rest_to_rest_shape(3);
    p.pieces = 195;  // 200 coefficients
    p.minimize = {{PeakOf{derivative_of_shape(order)}}};
    const ShapeOutcome best = optimize_shape(p);
    EXPECT_EQ(best.status, OptimizeStatus::optimal) << best.reason;
    const double clp = test_optimize::clp_least_peak(p.pieces, order, 4);
    EXPECT_LE(best.figures[0].reached, clp * 1.001);
    EXPECT_GE(best.figures[0].reached, clp * (1 - 1e-6)) << "a grid leaves gaps between its places";
  }
}

}  // namespace
}  // namespace jounce::shape_benchmark_test
