// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/optimize.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "optimize/rest_to_rest.hpp"
#include "optimize/src/knots/bound.hpp"

namespace jounce::optimize_test {
namespace {

using test_optimize::rest_to_rest;

constexpr auto optimal = OptimizeStatus::optimal;
constexpr auto converged = OptimizeStatus::converged;

double reached(const Outcome<CamSpec>& outcome) {
  return outcome.figures.front().reached;
}

TEST(Optimize, ReachesThePerfectSpline) {
  // Jerk +-32 with switches at 1/4 and 3/4: three cubics, which are quintics.
  const Outcome<CamSpec> outcome = optimize(rest_to_rest({0.3, 0.6}, Objective::peak_jerk));
  EXPECT_EQ(outcome.status, optimal) << outcome.reason;
  EXPECT_NEAR(reached(outcome), 32, 32e-6);
  EXPECT_NEAR(outcome.best.segments[0].end.master, 0.25, 1e-5);
  EXPECT_NEAR(outcome.best.segments[1].end.master, 0.75, 1e-5);
  EXPECT_NEAR(*outcome.best.segments[0].end.geo_acceleration, 8, 1e-3);
  EXPECT_NEAR(outcome.figures.front().given, 60, 60e-12);  // peak of the 3-4-5 law
}

TEST(Optimize, ReachesThePerfectSplineWithFixedMasters) {
  // Convex: with knots on the switches the jerk is 32, and 11 knots hold them too. Eleven knots
  // have 33 unknowns of very different reach: this is where an unwhitened solver stops at 60.
  for (const int n : {3, 7, 11}) {
    std::vector<double> cuts;
    for (int i = 1; i <= n; ++i) cuts.push_back(static_cast<double>(i) / (n + 1));
    CamProblem problem = rest_to_rest(cuts, Objective::peak_jerk);
    for (FreeKnot& free : problem.free) free.master.reset();
    const Outcome<CamSpec> outcome = optimize(problem);
    EXPECT_EQ(outcome.status, optimal) << n << ": " << outcome.reason;
    EXPECT_NEAR(reached(outcome), 32, 32e-6) << n;
    EXPECT_EQ(outcome.starts, 1);
  }
}

TEST(Optimize, MoreKnotsNeverHurtWhereTheProblemIsConvex) {
  // Knots at i / (n + 1), then at half the distance: each family contains the one before.
  double before = 10;
  for (const int n : {1, 3, 7}) {
    std::vector<double> cuts;
    for (int i = 1; i <= n; ++i) cuts.push_back(static_cast<double>(i) / (n + 1));
    CamProblem problem = rest_to_rest(cuts, Objective::peak_acceleration);
    for (FreeKnot& free : problem.free) free.master.reset();
    const Outcome<CamSpec> outcome = optimize(problem);
    EXPECT_EQ(outcome.status, OptimizeStatus::optimal) << outcome.reason;
    EXPECT_LT(reached(outcome), before);
    EXPECT_GT(reached(outcome), 4);
    before = reached(outcome);
  }
}

TEST(Optimize, BalancesTheJerkOfTwoQuintics) {
  // One knot in the middle, its velocity v free. Over the first half, h = L = 1/2, the jerk goes
  // from 60 h/L^3 - 24 v/L^2 = 240 - 96 v to 60 h/L^3 - 36 v/L^2 = 240 - 144 v: balanced at v = 2.
  CamProblem problem = rest_to_rest({0.5}, Objective::peak_jerk);
  problem.free = {{1, {}, {}, Bound{0, 4}, {}}};
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_EQ(outcome.status, OptimizeStatus::optimal) << outcome.reason;
  EXPECT_NEAR(reached(outcome), 48, 48e-8);
  EXPECT_LE(*outcome.figures.front().bound, 48);
  EXPECT_NEAR(*outcome.best.segments[0].end.geo_velocity, 2, 1e-8);
}

TEST(Optimize, ReachesTheCubicForRms) {
  CamProblem problem = rest_to_rest({}, Objective::rms_acceleration);
  problem.free = {{0, {}, {}, {}, Bound{-20, 20}}, {1, {}, {}, {}, Bound{-20, 20}}};
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_EQ(outcome.status, optimal) << outcome.reason;
  EXPECT_NEAR(reached(outcome), std::sqrt(12), 1e-6);
  EXPECT_NEAR(*outcome.best.start.geo_acceleration, 6, 1e-3);
}

TEST(Optimize, ApproachesConstantAccelerationWithEnoughKnots) {
  // Not in the family: the acceleration of a quintic is continuous. Knots may not come nearer to
  // the ends than 0.02; four of them reach 4.0536 there.
  const Outcome<CamSpec> outcome =
      optimize(rest_to_rest({0.2, 0.4, 0.6, 0.8}, Objective::peak_acceleration));
  EXPECT_EQ(outcome.status, converged) << outcome.reason;
  EXPECT_GT(reached(outcome), 4);
  EXPECT_LT(reached(outcome), 4.0537);
  EXPECT_EQ(*outcome.figures.front().bound, 4);
  EXPECT_NEAR(*outcome.figures.front().gap(), 1 - 4 / reached(outcome), 1e-15);
}

TEST(Optimize, NeverBeatsItsBounds) {
  for (const auto objective :
       {Objective::peak_acceleration, Objective::peak_jerk, Objective::rms_acceleration})
    for (const double cut : {0.3, 0.5, 0.8}) {
      const Outcome<CamSpec> outcome = optimize(rest_to_rest({cut}, objective));
      const FigureResult& r = outcome.figures.front();
      EXPECT_GE(r.reached, *r.bound * (1 - 1e-12));
      EXPECT_LE(r.reached, r.given);
    }
}

TEST(Optimize, MirrorsWithTheSlave) {
  const auto up = optimize(rest_to_rest({0.3, 0.6}, Objective::peak_acceleration));
  const auto down = optimize(rest_to_rest({0.3, 0.6}, Objective::peak_acceleration, -1));
  EXPECT_EQ(up.status, down.status);
  EXPECT_NEAR(reached(up), reached(down), 1e-6 * reached(up));
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(up.best.segments[i].end.slave, -down.best.segments[i].end.slave, 1e-4);
}

TEST(Optimize, IsIndependentOfUnits) {
  // Slave in 1e-6 of the unit, master in 1e3 of it.
  for (const auto objective :
       {Objective::peak_acceleration, Objective::peak_jerk, Objective::rms_acceleration}) {
    const auto plain = optimize(rest_to_rest({0.3, 0.6}, objective));
    const auto scaled = optimize(rest_to_rest({0.3, 0.6}, objective, 1e6, 1e-3));
    const double unit = 1e6 * std::pow(1e3, objective == Objective::peak_jerk ? 3 : 2);
    EXPECT_EQ(plain.status, scaled.status) << plain.reason << "; scaled: " << scaled.reason;
    EXPECT_NEAR(reached(scaled) / unit, reached(plain), 1e-6 * reached(plain));
  }
}

TEST(Optimize, TradesTheFirstObjectiveForTheNextWithinTolerance) {
  CamProblem problem = rest_to_rest({0.3, 0.6}, Objective::peak_acceleration);
  const double alone = reached(optimize(problem));
  problem.minimize.push_back(Objective::peak_jerk);
  problem.options.tolerance = 1e-4;
  const Outcome<CamSpec> strict = optimize(problem);
  problem.options.tolerance = 0.1;
  const Outcome<CamSpec> loose = optimize(problem);
  EXPECT_LE(strict.figures[0].reached, alone * (1 + 2e-4));
  EXPECT_LE(loose.figures[0].reached, alone * 1.1 * (1 + 1e-6));
  EXPECT_LT(loose.figures[1].reached, 0.9 * strict.figures[1].reached);
}

TEST(Optimize, AFlatCamIsOptimalAtZero) {
  CamProblem problem;
  problem.cam.start = {0, 5, 0, 0};
  problem.cam.segments = {{Law::quintic, {1, 5, 0, 0}, ""}, {Law::quintic, {2, 5, 0, 0}, ""}};
  problem.free = {{1, Bound{0.5, 1.5}, Bound{4, 6}, Bound{-1, 1}, Bound{-1, 1}}};
  problem.minimize = {Objective::peak_jerk, Objective::peak_acceleration};
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_EQ(outcome.status, optimal) << outcome.reason;
  EXPECT_NEAR(reached(outcome), 0, 1e-9);
}

TEST(Optimize, MovesTheJointOfTwoRestToRestLaws) {
  // Two inclined sines with a rest between: peak 2 pi h / L^2 each. Rises of 1 and 3 over a total
  // of 1 are equal where L1 / L2 = sqrt(1/3).
  CamProblem problem;
  problem.cam.start = {0, 0, {}, {}};
  problem.cam.segments = {{Law::inclined_sine, {0.5, 1, {}, {}}, ""},
                          {Law::inclined_sine, {1, 4, {}, {}}, ""}};
  problem.free = {{1, Bound{0.1, 0.9}, {}, {}, {}}};
  problem.minimize = {Objective::peak_acceleration};
  const Outcome<CamSpec> outcome = optimize(problem);
  const double L1 = 1 / (1 + std::sqrt(3));
  EXPECT_EQ(outcome.status, converged) << outcome.reason;
  EXPECT_NEAR(outcome.best.segments[0].end.master, L1, 1e-6);
  EXPECT_NEAR(reached(outcome), 2 * std::acos(-1) / (L1 * L1), 1e-5);
  EXPECT_FALSE(outcome.best.segments[0].end.geo_velocity.has_value());  // left to the law, as given
}

}  // namespace
}  // namespace jounce::optimize_test
