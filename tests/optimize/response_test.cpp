// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/optimize/shape.hpp"
#include "jounce/profiles/vibration/vibration_band.hpp"

#include "shape_problems.hpp"

namespace jounce::response_test {
namespace {

using test_optimize::rest_to_rest_shape;
using Status = OptimizeStatus;

constexpr Mode mode{1.5, 0.02};
constexpr int directions = 100;
/// One of the examined directions is at least this near to any phasor.
const double seen = std::cos(std::numbers::pi / (2 * directions));

/// Swing of the mode after the end, as the projections of its phasor on many directions: the same
/// figure as ResidualOf, but a long list of two independent numbers.
std::vector<double> swing(const Trajectory& shape) {
  const std::complex<double> phasor = residual_phasor(shape, mode);
  std::vector<double> y;
  for (int i = 0; i < directions; ++i)
    y.push_back((std::polar(1.0, std::numbers::pi * i / directions) * phasor).real());
  return y;
}

ShapeFigure response() {
  return ResponseOf{"swing", swing};
}
ShapeFigure residual() {
  return ResidualOf{mode.frequency, mode.frequency, mode.damping, mode.damping};
}

ShapeProblem least_rms(int order) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = 40;
  p.minimize = {{RmsOf{derivative_of_shape(order)}}};
  return p;
}

double least(ShapeProblem p, const ShapeFigure& figure, double at_most) {
  p.ceilings = {{figure, at_most}};
  const ShapeOutcome best = optimize_shape(p);
  EXPECT_TRUE(best.status == Status::optimal || best.status == Status::converged)
      << name(figure) << " <= " << at_most << ": " << best.reason;
  EXPECT_TRUE(best.usable()) << name(figure) << " <= " << at_most << ": " << best.reason;
  EXPECT_LE(best.figures[1].reached, at_most * (1 + 1e-9) + 1e-15);
  return best.figures[0].reached;
}

TEST(Response, NarrowCeilingsAreKeptAndCostWhatAResidualDoes) {
  const ShapeProblem p = least_rms(2);
  for (const double at_most : {3e-2, 1e-4, 1e-8}) {
    SCOPED_TRACE(at_most);
    const double found = least(p, response(), at_most);
    EXPECT_LE(found, least(p, residual(), at_most) * (1 + 1e-5)) << "fewer directions";
    EXPECT_GE(found, least(p, residual(), at_most / seen) * (1 - 1e-5)) << "no more are missed";
  }
}

TEST(Response, ThatCanBeNothingIsNothingWithTheLeastRmsJerk) {
  const double silent = least(least_rms(3), residual(), 0);
  ShapeProblem p = least_rms(3);
  for (const ShapeFigure& figure : {response(), ShapeFigure(RmsResponseOf{"rms swing", swing})}) {
    SCOPED_TRACE(name(figure));
    p.minimize = {{figure}};
    const ShapeOutcome best = optimize_shape(p);
    ASSERT_TRUE(best.usable()) << best.reason;
    EXPECT_EQ(best.status, Status::optimal) << best.reason;
    EXPECT_LT(residual_vibration(Trajectory(best.best), mode), 1e-7);
    p.minimize = {{RmsOf{derivative_of_shape(3)}}};
    p.given = best.best;
    EXPECT_NEAR(optimize_shape(p).figures[0].given, silent, 1e-6 * silent);
    p.given.clear();
  }
}

TEST(Response, BesideWallsThatDoNotLetItBeNothingIsAtItsLeast) {
  ShapeProblem p = least_rms(2);
  p.corridors = {test_optimize::within(derivative_of_shape(2), 5, p)};
  p.minimize = {{response()}};
  const ShapeOutcome best = optimize_shape(p);
  ASSERT_TRUE(best.usable()) << best.reason;
  p.minimize = {{residual()}};
  const ShapeOutcome same = optimize_shape(p);
  ASSERT_TRUE(same.usable()) << same.reason;
  EXPECT_GT(same.value, 0);
  EXPECT_NEAR(best.figures[0].reached, same.figures[0].reached,
              2 * (1 - seen) * same.figures[0].reached + 1e-6);
}

}  // namespace
}  // namespace jounce::response_test
