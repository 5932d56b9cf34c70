// SPDX-License-Identifier: Apache-2.0
// Residual ceilings beside an rms, of few pieces and of many.
#include <cmath>
#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

#include "jounce/optimize/shape.hpp"
#include "jounce/profiles/vibration/vibration_band.hpp"

namespace jounce::residual_ceiling_test {
namespace {

using Status = OptimizeStatus;

ShapeProblem quiet(std::size_t pieces, int derivative, const ResidualOf& residual, double at_most) {
  ShapeProblem p;
  p.from = {.value = 0, .velocity = 0, .acceleration = 0};
  p.to = {.value = 1, .velocity = 0, .acceleration = 0};
  p.pieces = pieces;
  p.minimize = {{RmsOf{derivative_of_shape(derivative)}}};
  p.ceilings = {{residual, at_most}};
  return p;
}

double left(const ShapeOutcome& o, const ResidualOf& r) {
  return worst_residual(Trajectory(o.best), {r.low, r.high, r.damping_low, r.damping_high}, 1e-9)
      .residual;
}

/// Solved within 1 % at every piece count from `fewest` on, proven impossible below it.
void keeps_its_ceiling(int derivative, const ResidualOf& residual, double at_most,
                       std::size_t fewest, std::initializer_list<std::size_t> counts) {
  for (const std::size_t pieces : counts) {
    SCOPED_TRACE(std::to_string(pieces) + " pieces, at most " + std::to_string(at_most));
    const ShapeOutcome o = optimize_shape(quiet(pieces, derivative, residual, at_most));
    if (pieces < fewest) {
      EXPECT_EQ(o.status, Status::infeasible) << o.reason;
      continue;
    }
    ASSERT_TRUE(o.status == Status::optimal || o.status == Status::converged) << o.reason;
    EXPECT_TRUE(o.limits.ok());
    EXPECT_LE(left(o, residual),
              at_most + 1e-6);  // share of the travel, like the certificate of worst_residual()
    ASSERT_TRUE(o.bound);
    EXPECT_LE(*o.bound, o.value);
    EXPECT_GE(*o.bound, 0.99 * o.value);
  }
}

TEST(ResidualCeiling, OfOneModeBesideAnRmsIsKept) {
  keeps_its_ceiling(3, {3, 3, 0.01, 0.01}, 1e-4, 8, {8, 9, 11, 14, 19, 26, 37, 50, 60});
}

TEST(ResidualCeiling, OfABandBesideAnRmsJerkIsKeptOrProvenOutOfReach) {
  keeps_its_ceiling(3, {2.5, 3.5, 0.01, 0.01}, 1e-4, 11, {9, 10, 11, 13, 17});
}

TEST(ResidualCeiling, OfABandBesideAnRmsAccelerationIsKept) {
  keeps_its_ceiling(2, {2.5, 3.5, 0.01, 0.01}, 1e-3, 9, {9, 17, 28});
}

/// More pieces are never worse where they contain the fewer: doubled, they do.
TEST(ResidualCeiling, IsNoWorseWithTwiceThePieces) {
  double before = HUGE_VAL;
  for (const std::size_t pieces : {12U, 24U}) {
    const ShapeOutcome o = optimize_shape(quiet(pieces, 3, {2.5, 3.5, 0.01, 0.01}, 1e-4));
    ASSERT_TRUE(o.usable()) << o.reason;
    EXPECT_LE(o.value, before * (1 + 1e-6));
    before = o.value;
  }
}

}  // namespace
}  // namespace jounce::residual_ceiling_test
